//! Quicker forms of operations of the scalar reference, for `f32` and `f64`.
//!
//! The reference serves every [`Real`](crate::Real) number, in the order of the papers. Most
//! callers hold floats and want speed, so the reference first asks for the operations below:
//! `R::quick(quick::Product(a, b))`. Only `f32` and `f64` answer. A type that wraps a float takes
//! the path of the reference, and the tests compare the two.
//!
//! - `quad`: one quaternion in the four lanes of a register, or of two.
//! - `between`: interpolation on a screw, in such registers.
//! - `one_lane`: operations of [`batch`](crate::batch) with one lane, for operations without a
//!   better form.
//!
//! Nothing is fused, and no form depends on the target: the bits are the same on all of them. So
//! products and sums are written as such, because `mul_add` of these registers fuses where the
//! target does.

#[cfg(not(dq8_record))]
mod between;
#[cfg(dq8_record)]
pub mod between;
mod one_lane;
mod quad;

use crate::geometry::DualVector;
use core::ops::BitXor;
use dq8_simd::{Float, Lanes, Portable, f32x4, f64x4};

/// An operation that `f32` and `f64` compute in another way than the textbook form.
pub trait Quick<R> {
    /// The answer.
    type Output;
    /// Computes the result, or returns `None` for input that is left to the textbook form.
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

/// `f32` or `f64`, which is a vector of one lane too.
pub trait Number:
    Float + between::Even + Lanes<Real = Self, Level = Portable, Mask = bool>
{
    /// The lanes that hold a quaternion.
    type Four: Four<Number = Self>;
    /// Returns the largest power of two that is not greater than this positive normal number.
    fn power_of_two(self) -> Self;
    /// Returns `true` if this lies between two positive numbers. It takes one comparison of
    /// integers.
    fn is_between(self, least: Self, most: Self) -> bool;
}

/// The implementations differ in the number of bits of the exponent.
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

/// Four lanes.
pub trait Four:
    Lanes<Real = <Self as Four>::Number, Level = Portable, Array = [<Self as Four>::Number; 4]>
    + BitXor<Output = Self>
{
    /// The type of a lane.
    type Number: Number<Four = Self>;
}
