//! Quicker forms of operations of the scalar reference, for `f32` and `f64`.
//!
//! The reference serves every [`Real`](crate::Real) number, in the order of the papers. Most
//! callers hold floats and want speed, so the reference first asks for a quicker form:
//! `R::quick(quick::Product(a, b))`. Only `f32` and `f64` have such forms. For other types, also
//! for those that only wrap a float, the reference computes its own formula, so the tests can
//! compare the two.
//!
//! - `quad`: one quaternion in the four lanes of a register, or of two.
//! - `between`: interpolation on a screw, in such registers.
//! - `one_lane`: calls of [`batch`](crate::batch) with one lane, for operations without a better
//!   form.
//!
//! No multiplication is fused with an addition, so the results have the same bits on all targets.
//! Products and sums are therefore written with `*` and `+`: `mul_add` of these registers would
//! fuse on targets that can.

#[cfg(not(dq8_record))]
mod between;
#[cfg(dq8_record)]
pub mod between;
mod one_lane;
mod quad;

use crate::geometry::DualVector;
use core::ops::BitXor;
use dq8_simd::{Float, Lanes, Portable, f32x4, f64x4};

/// An operation that is computed for `f32` and `f64` in a quicker way than by the textbook formula.
pub trait Quick<R> {
    /// The type of the result.
    type Output;
    /// Computes the result, or returns `None` for input that needs the textbook formula.
    fn compute(self) -> Option<Self::Output>
    where
        R: Number;
}

/// Defines a struct for the arguments of each operation. Code that is generic over `Real` cannot
/// call a function over [`Number`], but it can make this struct and ask `R::quick` for the result.
macro_rules! operations {
    ($($name:ident($($argument:ident: $of:ty),*) -> $output:ty = $home:ident::$function:ident;)*) => {$(
        #[derive(Debug)]
        pub(crate) struct $name<R>($(pub(crate) $of),*);

        impl<R> Quick<R> for $name<R> {
            type Output = $output;
            #[inline(always)]
            fn compute(self) -> Option<$output>
            where
                R: Number,
            {
                let Self($($argument),*) = self;
                $home::$function($($argument),*)
            }
        }
    )*};
}
operations! {
    Product(a: [R; 8], b: [R; 8]) -> [R; 8] = quad::product;
    Unit(motion: [R; 8]) -> [R; 8] = quad::unit;
    Inverse(motion: [R; 8]) -> [R; 8] = quad::inverse;
    Lerp(a: [R; 8], b: [R; 8], t: R) -> [R; 8] = quad::lerp;
    Sclerp(a: [R; 8], b: [R; 8], t: R) -> [R; 8] = between::sclerp;
    Log(motion: [R; 8]) -> DualVector<R> = one_lane::log;
    Exp(log: DualVector<R>) -> [R; 8] = one_lane::exp;
    Pow(motion: [R; 8], t: R) -> [R; 8] = one_lane::pow;
    Sqrt(motion: [R; 8]) -> [R; 8] = one_lane::sqrt;
    Point(motion: [R; 8], point: [R; 3]) -> [R; 3] = quad::point;
    Translation(motion: [R; 8]) -> [R; 3] = quad::translation;
    Matrix3x4(motion: [R; 8]) -> [[R; 4]; 3] = quad::matrix3x4;
    QuaternionProduct(a: [R; 4], b: [R; 4]) -> [R; 4] = quad::quaternion_product;
    QuaternionUnit(quaternion: [R; 4]) -> [R; 4] = quad::quaternion_unit;
    Slerp(a: [R; 4], b: [R; 4], t: R) -> [R; 4] = between::slerp;
    Rotate(rotation: [R; 4], vector: [R; 3]) -> [R; 3] = quad::rotate;
    Limb(root: [R; 3], lengths: [R; 2], target: [R; 3], pole: [R; 3]) -> ([[R; 4]; 2], [R; 2]) = one_lane::limb;
}

/// `f32` or `f64`. Each is also a vector of one lane.
pub trait Number:
    Float + between::Even + Lanes<Real = Self, Level = Portable, Mask = bool>
{
    /// The register of four lanes that holds a quaternion.
    type Four: Four<Number = Self>;
    /// Returns the largest power of two that does not exceed `self`, a positive normal number.
    fn power_of_two(self) -> Self;
    /// Returns `true` if `self` lies between two positive numbers. It takes one comparison of
    /// integers.
    fn is_between(self, least: Self, most: Self) -> bool;
}

/// Implements [`Number`] for `f32` and `f64`, which differ in the bits of the exponent.
macro_rules! numbers {
    ($($real:ident $four:ident $exponent:literal;)*) => {$(
        impl Number for $real {
            type Four = $four;
            #[inline(always)]
            fn power_of_two(self) -> Self {
                Self::from_bits(self.to_bits() & $exponent)
            }
            #[inline(always)]
            fn is_between(self, least: Self, most: Self) -> bool {
                let (least, most) = (least.to_bits(), most.to_bits());
                self.to_bits().wrapping_sub(least) < most.wrapping_sub(least)
            }
        }
        impl Four for $four {
            type Number = $real;
        }
    )*};
}
numbers! {
    f32 f32x4 0x7f80_0000;
    f64 f64x4 0x7ff0_0000_0000_0000;
}

/// A register of four lanes.
pub trait Four:
    Lanes<Real = <Self as Four>::Number, Level = Portable, Array = [<Self as Four>::Number; 4]>
    + BitXor<Output = Self>
{
    /// The type of the value in a lane.
    type Number: Number<Four = Self>;
}
