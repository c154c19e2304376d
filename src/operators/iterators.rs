//! `sum()` and `product()` of iterators. A product runs from left to right: its last factor acts
//! first.

use crate::geometry::{DualVector, Twist};
use crate::number::Real;
use crate::representation::{Affine, RotationTranslation};
use crate::scalar::{DualQuat, Quat};
use core::iter::{Product, Sum};

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
