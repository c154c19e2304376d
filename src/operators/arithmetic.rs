//! Operators besides `+`, `-` and `*` on values: `*=`, real numbers as factors, operators on
//! references, sums and products of iterators, and access to components by index.

use crate::geometry::{DualVector, Twist};
use crate::number::Real;
use crate::representation::{Affine, RotationTranslation};
use crate::scalar::{Dual, DualQuat, Quat};
use core::iter::{Product, Sum};
use core::ops::{
    Add, AddAssign, Div, DivAssign, Index, IndexMut, Mul, MulAssign, Neg, Sub, SubAssign,
};

// `a *= b` sets a to the product ab, in which the motion b acts first.
macro_rules! assign {
    ($($thing:ident: $($trait:ident $method:ident $operator:tt),*;)*) => {$($(
        impl<R: Real> $trait for $thing<R> {
            #[inline]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*)*};
}
assign! {
    Dual: AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /;
    Quat: AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *;
    DualQuat: AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *;
    RotationTranslation: MulAssign mul_assign *;
    Affine: MulAssign mul_assign *;
    Twist: AddAssign add_assign +, SubAssign sub_assign -;
    DualVector: AddAssign add_assign +, SubAssign sub_assign -;
}

macro_rules! factors {
    ($($thing:ident)*) => {$(
        /// Multiplies every component by a number.
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
        /// Multiplies every component by the reciprocal of a number.
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
        /// Multiplies every component by a number, which is the left factor.
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

/// Turns a vector by [`Quat::rotate`]. glam and nalgebra have the same operator.
impl<R: Real> Mul<[R; 3]> for Quat<R> {
    type Output = [R; 3];
    #[inline]
    fn mul(self, vector: [R; 3]) -> [R; 3] {
        self.rotate(vector)
    }
}

/// Calls [`DualQuat::mul_rotation_translation`].
impl<R: Real> Mul<RotationTranslation<R>> for DualQuat<R> {
    type Output = Self;
    #[inline]
    fn mul(self, other: RotationTranslation<R>) -> Self {
        self.mul_rotation_translation(other.rotation, other.translation)
    }
}

// The macro implements `&a * &b`, `a * &b`, `&a * b`, `a *= &b` and `-&a`. It is not applied to
// `Dual`: with a second product, the type of the factor in `x * Real::HALF` would be ambiguous.
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

// The product of an iterator has the factors from left to right, so its last factor acts first on
// points.
macro_rules! fold {
    ($($thing:ident: $($trait:ident $method:ident from $start:expr, $operator:tt),*;)*) => {$($(
        impl<R: Real> $trait for $thing<R> {
            fn $method<I: Iterator<Item = Self>>(things: I) -> Self {
                things.fold($start, |so_far, thing| so_far $operator thing)
            }
        }
        impl<'t, R: Real> $trait<&'t Self> for $thing<R> {
            fn $method<I: Iterator<Item = &'t Self>>(things: I) -> Self {
                things.copied().$method()
            }
        }
    )*)*};
}
fold! {
    Quat: Sum sum from Self::ZERO, +, Product product from Self::IDENTITY, *;
    DualQuat: Sum sum from Self::ZERO, +, Product product from Self::IDENTITY, *;
    RotationTranslation: Product product from Self::IDENTITY, *;
    Affine: Product product from Self::IDENTITY, *;
    Twist: Sum sum from Self::default(), +;
    DualVector: Sum sum from Self::default(), +;
}

// Components are indexed in the order of memory. An index that is too large panics, as with arrays.
macro_rules! index {
    ($($thing:ident: $order:literal;)*) => {$(
        #[doc = $order]
        ///
        /// # Panics
        /// If the index is beyond the last component.
        impl<R: Real> Index<usize> for $thing<R> {
            type Output = R;
            #[inline]
            #[track_caller]
            fn index(&self, component: usize) -> &R {
                &self.as_ref()[component]
            }
        }
        #[doc = $order]
        ///
        /// # Panics
        /// If the index is beyond the last component.
        impl<R: Real> IndexMut<usize> for $thing<R> {
            #[inline]
            #[track_caller]
            fn index_mut(&mut self, component: usize) -> &mut R {
                &mut self.as_mut()[component]
            }
        }
    )*};
}
index! {
    Quat: "`[x, y, z, w]`";
    DualQuat: "`[px, py, pz, pw, qx, qy, qz, qw]`";
}
