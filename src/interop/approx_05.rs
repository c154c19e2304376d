//! The traits of approx 0.5, implemented so that they compare component by component. So −σ does
//! not compare as near to σ, although both are the same motion.

use crate::geometry::Twist;
use crate::number::Real;
use crate::representation::RotationTranslation;
use crate::scalar::{DualQuat, Quat};
use approx::{AbsDiffEq, RelativeEq, UlpsEq};

macro_rules! compare {
    ($($thing:ident)*) => {$(
        impl<R: Real + AbsDiffEq<Epsilon: Copy>> AbsDiffEq for $thing<R> {
            type Epsilon = R::Epsilon;
            fn default_epsilon() -> R::Epsilon {
                R::default_epsilon()
            }
            fn abs_diff_eq(&self, other: &Self, epsilon: R::Epsilon) -> bool {
                let pairs = self.to_array().into_iter().zip(other.to_array());
                pairs.into_iter().all(|(a, b)| R::abs_diff_eq(&a, &b, epsilon))
            }
        }
        impl<R: Real + RelativeEq<Epsilon: Copy>> RelativeEq for $thing<R> {
            fn default_max_relative() -> R::Epsilon {
                R::default_max_relative()
            }
            fn relative_eq(&self, other: &Self, epsilon: R::Epsilon, max: R::Epsilon) -> bool {
                let pairs = self.to_array().into_iter().zip(other.to_array());
                pairs.into_iter().all(|(a, b)| R::relative_eq(&a, &b, epsilon, max))
            }
        }
        impl<R: Real + UlpsEq<Epsilon: Copy>> UlpsEq for $thing<R> {
            fn default_max_ulps() -> u32 {
                R::default_max_ulps()
            }
            fn ulps_eq(&self, other: &Self, epsilon: R::Epsilon, max_ulps: u32) -> bool {
                let pairs = self.to_array().into_iter().zip(other.to_array());
                pairs.into_iter().all(|(a, b)| R::ulps_eq(&a, &b, epsilon, max_ulps))
            }
        }
    )*};
}
compare! { Quat DualQuat RotationTranslation Twist }
