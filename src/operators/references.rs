//! Operators of references: `&a * &b`, `a * &b`, `&a * b`, `a *= &b`, `-&a`. `Dual` has none:
//! with a second product, the type of the factor in `x * Real::HALF` would be ambiguous.

use crate::geometry::{DualVector, Twist};
use crate::number::Real;
use crate::representation::{Affine, RotationTranslation};
use crate::scalar::{DualQuat, Quat};
use core::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

macro_rules! references {
    ($($thing:ident: $($trait:ident $method:ident $assign:ident $method_assign:ident),*;)*) => {$($(
        impl<R: Real> $trait<&Self> for $thing<R> {
            type Output = Self;
            #[inline]
            fn $method(self, other: &Self) -> Self {
                $trait::$method(self, *other)
            }
        }
        impl<R: Real> $trait<$thing<R>> for &$thing<R> {
            type Output = $thing<R>;
            #[inline]
            fn $method(self, other: $thing<R>) -> $thing<R> {
                $trait::$method(*self, other)
            }
        }
        impl<R: Real> $trait for &$thing<R> {
            type Output = $thing<R>;
            #[inline]
            fn $method(self, other: Self) -> $thing<R> {
                $trait::$method(*self, *other)
            }
        }
        impl<R: Real> $assign<&Self> for $thing<R> {
            #[inline]
            fn $method_assign(&mut self, other: &Self) {
                *self = $trait::$method(*self, *other);
            }
        }
    )*)*};
}
references! {
    Quat: Add add AddAssign add_assign, Sub sub SubAssign sub_assign, Mul mul MulAssign mul_assign;
    DualQuat: Add add AddAssign add_assign, Sub sub SubAssign sub_assign, Mul mul MulAssign mul_assign;
    Twist: Add add AddAssign add_assign, Sub sub SubAssign sub_assign;
    DualVector: Add add AddAssign add_assign, Sub sub SubAssign sub_assign;
    RotationTranslation: Mul mul MulAssign mul_assign;
    Affine: Mul mul MulAssign mul_assign;
}

macro_rules! negative {
    ($($thing:ident)*) => {$(
        impl<R: Real> Neg for &$thing<R> {
            type Output = $thing<R>;
            #[inline]
            fn neg(self) -> $thing<R> {
                -*self
            }
        }
    )*};
}
negative! { Quat DualQuat Twist DualVector }
