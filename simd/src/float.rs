//! [`Float`]: the number in a lane.

use crate::lane::Lanes;
use crate::level::Level;
use crate::octet::Octet;
use bytemuck::Pod;
use core::fmt::Debug;

/// `f32` or `f64`, as far as a kernel must tell them apart: to write constants and to find its lanes. Sealed.
pub trait Float:
    Pod
    + PartialOrd
    + Default
    + Debug
    + From<f32>
    + Into<f64>
    + core::ops::Neg<Output = Self>
    + sealed::Sealed
{
    /// Whether this is `f32`.
    const SINGLE: bool;
    /// The lanes of this number that fill a register of `V`.
    type Lanes<V: Level>: Lanes<Real = Self, Level = V>;
    /// The lanes that hold one record of eight of this number.
    type Octet<V: Level>: Octet<Real = Self, Level = V, Array = [Self; 8]>;
    /// The nearest number of this type.
    fn from_f64(value: f64) -> Self;
}

impl Float for f32 {
    const SINGLE: bool = true;
    type Lanes<V: Level> = V::Single;
    type Octet<V: Level> = V::F32x8;
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
    fn from_f64(value: f64) -> Self {
        value as f32
    }
}

impl Float for f64 {
    const SINGLE: bool = false;
    type Lanes<V: Level> = V::Double;
    type Octet<V: Level> = V::F64x8;
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}
