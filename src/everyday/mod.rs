//! The quicker forms that `f32` and `f64` have of what the scalar reference computes.
//!
//! The reference serves every [`Real`](crate::Real) number, in the order of the papers. Most callers
//! hold floats and want speed, so [`Real`](crate::Real) offers the functions below (`quick_product` and
//! the like), and the reference asks for them first. Nothing else calls them, and only these two numbers
//! have them: a wrapper of a float takes the reference's own path, and the tests compare the two.
//!
//! - `quad`: one quaternion in the four lanes of a register, or of two.
//! - `between`: interpolation on a screw, in such registers.
//! - `one_lane`: operations of [`batch`](crate::batch) at one lane: what has no better form, and on
//!   targets without such registers most of the others.

mod between;
mod one_lane;
mod quad;

pub(crate) use between::{sclerp, slerp};
use core::ops::BitXor;
use dq8_simd::{Float, Lanes, Portable, f32x4, f64x4};
pub(crate) use one_lane::{exp, log, pow, sqrt};
pub(crate) use quad::{
    inverse, lerp, matrix3x4, point, product, quaternion_product, quaternion_unit, rotate,
    translation, unit,
};

/// `f32` or `f64`: a number, and one lane.
pub(crate) trait Number:
    Float + between::Even + Lanes<Real = Self, Level = Portable, Mask = bool>
{
    /// The lanes that hold a quaternion.
    type Four: Four<Number = Self>;
    /// How many registers these are.
    const REGISTERS: usize = 4 / <Self::Four as Lanes>::Native::LANES;
    /// The largest power of two that is no larger than this positive normal number.
    fn power_of_two(self) -> Self;
    /// Whether this lies between two positive numbers: one comparison, of bits.
    fn is_between(self, least: Self, most: Self) -> bool;
}

impl Number for f32 {
    type Four = f32x4;
    #[inline(always)]
    fn power_of_two(self) -> Self {
        Self::from_bits(self.to_bits() & 0x7f80_0000)
    }
    #[inline(always)]
    fn is_between(self, least: Self, most: Self) -> bool {
        let (least, most) = (least.to_bits(), most.to_bits());
        self.to_bits().wrapping_sub(least) < most.wrapping_sub(least)
    }
}

impl Number for f64 {
    type Four = f64x4;
    #[inline(always)]
    fn power_of_two(self) -> Self {
        Self::from_bits(self.to_bits() & 0x7ff0_0000_0000_0000)
    }
    #[inline(always)]
    fn is_between(self, least: Self, most: Self) -> bool {
        let (least, most) = (least.to_bits(), most.to_bits());
        self.to_bits().wrapping_sub(least) < most.wrapping_sub(least)
    }
}

/// Four lanes.
pub(crate) trait Four:
    Lanes<Real = <Self as Four>::Number, Level = Portable, Array = [<Self as Four>::Number; 4]>
    + BitXor<Output = Self>
{
    /// The number in each.
    type Number: Number<Four = Self>;
}

impl Four for f32x4 {
    type Number = f32;
}

impl Four for f64x4 {
    type Number = f64;
}
