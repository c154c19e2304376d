//! Numbers and rotations as factors: `q * 2.0`, `2.0 * q`, `q / 2.0`, and what a rotation does to a
//! vector.

use crate::geometry::{DualVector, Twist};
use crate::number::Real;
use crate::representation::RotationTranslation;
use crate::scalar::{DualQuat, Quat};
use core::ops::{Div, DivAssign, Mul, MulAssign};

macro_rules! factors {
    ($($thing:ident)*) => {$(
        /// Every component times a number.
        impl<R: Real> Mul<R> for $thing<R> {
            type Output = Self;
            #[inline]
            fn mul(self, factor: R) -> Self {
                self.scale(factor)
            }
        }
        impl<R: Real> MulAssign<R> for $thing<R> {
            #[inline]
            fn mul_assign(&mut self, factor: R) {
                *self = *self * factor;
            }
        }
        /// Every component times the reciprocal of a number.
        impl<R: Real> Div<R> for $thing<R> {
            type Output = Self;
            #[inline]
            fn div(self, divisor: R) -> Self {
                self.scale(R::ONE / divisor)
            }
        }
        impl<R: Real> DivAssign<R> for $thing<R> {
            #[inline]
            fn div_assign(&mut self, divisor: R) {
                *self = *self / divisor;
            }
        }
    )*};
}
factors! { Quat DualQuat Twist DualVector }

macro_rules! left_factors {
    ($($real:ident $thing:ident),*) => {$(
        /// A number times every component.
        impl Mul<$thing<$real>> for $real {
            type Output = $thing<$real>;
            #[inline]
            fn mul(self, thing: $thing<$real>) -> $thing<$real> {
                thing.scale(self)
            }
        }
    )*};
}
left_factors! {
    f32 Quat, f32 DualQuat, f32 Twist, f32 DualVector,
    f64 Quat, f64 DualQuat, f64 Twist, f64 DualVector
}

/// [`Quat::rotate`], as glam and nalgebra write it.
impl<R: Real> Mul<[R; 3]> for Quat<R> {
    type Output = [R; 3];
    #[inline]
    fn mul(self, vector: [R; 3]) -> [R; 3] {
        self.rotate(vector)
    }
}

/// [`DualQuat::mul_rotation_translation`]
impl<R: Real> Mul<RotationTranslation<R>> for DualQuat<R> {
    type Output = Self;
    #[inline]
    fn mul(self, other: RotationTranslation<R>) -> Self {
        self.mul_rotation_translation(other.rotation, other.translation)
    }
}
