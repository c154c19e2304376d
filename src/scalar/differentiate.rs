//! Dual numbers as [`Real`] numbers: code that is written for [`Real`] computes its own derivative.

use crate::number::Real;
use crate::scalar::Dual;
use core::fmt;

/// Those that dual numbers have anyway.
macro_rules! functions {
    ($($name:ident($($x:ident)?))*) => {$(
        fn $name(self $(, $x: Self)?) -> Self {
            Self::$name(self $(, $x)?)
        }
    )*};
}

/// Forward automatic differentiation: a function written for every `R: Real`, computed with x + ε,
/// gives f(x) + εf′(x) (Jia eq. 10). `Dual<Dual<R>>` are the hyper-dual numbers of Fike & Alonso
/// (2011), with ε₁ outside and ε₂ inside, and give second derivatives without a difference.
///
/// The operations of [`DualQuat`](crate::DualQuat) and [`Quat`](crate::Quat) are such functions:
///
/// ```
/// use dq8::{Dual, Quat};
/// // How does a point on a wheel move as the wheel turns?
/// let angle = Dual::new(0.5_f64, 1.0);
/// let axis = [0.0, 0.0, 1.0].map(|c| Dual::new(c, 0.0));
/// let rim = [1.0, 0.0, 0.0].map(|c| Dual::new(c, 0.0));
/// let velocity = Quat::from_axis_angle(axis, angle).rotate(rim).map(|c| c.dual);
/// assert!((velocity[0] + 0.5_f64.sin()).abs() + (velocity[1] - 0.5_f64.cos()).abs() < 1e-15);
/// ```
///
/// The derivative at a kink or a pole of f is that of the branch taken, infinite or NaN, as floats
/// have it. A length is such a function at zero, and the exponential and the logarithm of a motion
/// begin with a length: without any turn they are NaN, the value included. Joints at rest are best
/// written with `from_axis_angle` and `from_screw`, which have no such point. `Real::EPSILON` is
/// the rounding of `R`; the dual unit ε is [`Dual::EPSILON`].
impl<R: Real> Real for Dual<R> {
    const ZERO: Self = Self::new(R::ZERO, R::ZERO);
    const ONE: Self = Self::new(R::ONE, R::ZERO);
    const TWO: Self = Self::new(R::TWO, R::ZERO);
    const HALF: Self = Self::new(R::HALF, R::ZERO);
    const PI: Self = Self::new(R::PI, R::ZERO);
    const EPSILON: Self = Self::new(R::EPSILON, R::ZERO);
    const NAN: Self = Self::new(R::NAN, R::NAN);

    fn from_f64(value: f64) -> Self {
        Self::new(R::from_f64(value), R::ZERO)
    }
    fn is_finite(self) -> bool {
        self.real.is_finite() && self.dual.is_finite()
    }
    fn abs(self) -> Self {
        // As the numbers are ordered, +0 − ε is negative.
        let dual = if self < <Self as Real>::ZERO { -self.dual } else { self.dual };
        Self::new(self.real.abs(), dual)
    }
    functions! { sqrt() sin() cos() tan() asin() acos() atan() atan2(x) exp() ln() }
}

impl<R: Real> fmt::Display for Dual<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({} + {}ε)", self.real, self.dual)
    }
}

/// a + ε0
impl<R: Real> From<f32> for Dual<R> {
    fn from(value: f32) -> Self {
        Self::new(R::from(value), R::ZERO)
    }
}

/// The real part, for error messages.
impl<R: Real> From<Dual<R>> for f64 {
    fn from(value: Dual<R>) -> Self {
        value.real.into()
    }
}
