//! [`Lane`]: what a kernel may ask of a vector of numbers.

use crate::float::Float;
use crate::level::Level;
use bytemuck::{Pod, Zeroable};
use core::fmt::Debug;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// A vector of `LANES` floating-point numbers that are computed together.
///
/// Arithmetic is IEEE 754 lane by lane. Only [`mul_add`](Self::mul_add) and
/// [`neg_mul_add`](Self::neg_mul_add) may differ between types: they round once where the hardware
/// fuses, twice elsewhere.
///
/// A constant needs a [`Level`] or another lane to stand beside ([`with`](Self::with)): a value of
/// the type is itself proof that the CPU can compute with it.
pub trait Lane:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// The number in each lane: `f32` or `f64`.
    type Real: Float;
    /// One truth value a lane.
    type Mask: Mask;
    /// The instructions that these lanes need.
    type Level: Level;
    /// The lanes in memory: `[Real; LANES]`.
    type Array: Pod + Debug + AsRef<[Self::Real]> + AsMut<[Self::Real]>;
    /// How many numbers there are.
    const LANES: usize;

    /// The proof that this value is.
    fn level(self) -> Self::Level;
    /// `value` in every lane.
    fn splat(level: Self::Level, value: Self::Real) -> Self;
    /// The number nearest to `value` in every lane, for code that holds a lane and no level.
    #[inline(always)]
    #[must_use]
    fn with(self, value: f64) -> Self {
        Self::splat(self.level(), Self::Real::from_f64(value))
    }

    /// Lane `i` from element `i`.
    fn load(level: Self::Level, from: &Self::Array) -> Self;
    /// Element `i` from lane `i`.
    fn store(self, to: &mut Self::Array);

    /// The first elements of `from`, at most `LANES`; `padding` in the lanes that are left.
    #[inline(always)]
    fn load_partial(level: Self::Level, from: &[Self::Real], padding: Self::Real) -> Self {
        let mut array = Self::Array::zeroed();
        array.as_mut().fill(padding);
        for (slot, &value) in array.as_mut().iter_mut().zip(from) {
            *slot = value;
        }
        Self::load(level, &array)
    }
    /// The first lanes into `to`, at most `LANES`; elements beyond are left as they were.
    #[inline(always)]
    fn store_partial(self, to: &mut [Self::Real]) {
        for (slot, &value) in to.iter_mut().zip(self.to_array().as_ref()) {
            *slot = value;
        }
    }
    /// The lanes as an array.
    #[inline(always)]
    fn to_array(self) -> Self::Array {
        let mut array = Self::Array::zeroed();
        self.store(&mut array);
        array
    }

    /// Transposes on the way in: record `i` of `from` becomes lane `i` of `C` vectors.
    /// Lanes without a record take `padding`.
    #[inline(always)]
    fn load_records<const C: usize>(
        level: Self::Level,
        from: &[[Self::Real; C]],
        padding: [Self::Real; C],
    ) -> [Self; C] {
        let mut rows = padding.map(|value| {
            let mut row = Self::Array::zeroed();
            row.as_mut().fill(value);
            row
        });
        for (lane, record) in from.iter().take(Self::LANES).enumerate() {
            for (row, &value) in rows.iter_mut().zip(record) {
                if let Some(slot) = row.as_mut().get_mut(lane) {
                    *slot = value;
                }
            }
        }
        rows.map(|row| Self::load(level, &row))
    }
    /// Transposes on the way out: lane `i` of `C` vectors becomes record `i` of `to`.
    /// Records beyond `LANES` are left as they were.
    #[inline(always)]
    fn store_records<const C: usize>(components: [Self; C], to: &mut [[Self::Real; C]]) {
        let rows = components.map(Self::to_array);
        for (lane, record) in to.iter_mut().take(Self::LANES).enumerate() {
            for (value, row) in record.iter_mut().zip(&rows) {
                if let Some(&source) = row.as_ref().get(lane) {
                    *value = source;
                }
            }
        }
    }

    /// `self · factor + addend`, rounded once where the hardware fuses.
    #[must_use]
    fn mul_add(self, factor: Self, addend: Self) -> Self;
    /// `addend − self · factor`, rounded once where the hardware fuses.
    #[must_use]
    fn neg_mul_add(self, factor: Self, addend: Self) -> Self;
    /// The correctly rounded square root; NaN below zero.
    #[must_use]
    fn sqrt(self) -> Self;
    /// The value without its sign; NaN stays NaN.
    #[must_use]
    fn abs(self) -> Self;
    /// The magnitude of `self` with the sign bit of `sign`.
    #[must_use]
    fn copysign(self, sign: Self) -> Self;

    /// `self < other`; false where either is NaN.
    fn lt(self, other: Self) -> Self::Mask;
    /// `self ≤ other`; false where either is NaN.
    fn le(self, other: Self) -> Self::Mask;
    /// `self = other`; false where either is NaN, true for zeros of either sign.
    fn eq(self, other: Self) -> Self::Mask;
    /// `yes` in the lanes where `mask` holds, `no` in the others.
    #[must_use]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
}

/// One truth value a lane.
pub trait Mask:
    Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self>
{
    /// How many lanes there are.
    const LANES: u32;
    /// True if some lane is.
    fn any(self) -> bool;
    /// True if every lane is.
    fn all(self) -> bool;
    /// Bit `i` is lane `i`; the bits beyond the last lane are zero.
    fn to_bitmask(self) -> u32;
}

/// A row of numbers in memory, `[f32; N]` or `[f64; N]`, and the lanes that read it.
///
/// Sealed: blocks rely on a row being plain numbers of at least sixteen bytes.
pub trait Row: Pod + AsRef<[Self::Real]> + AsMut<[Self::Real]> + Debug + sealed::Sealed {
    /// The number.
    type Real: Float;
    /// The lane type of `V` that holds one row.
    type Lane<V: Level>: Lane<Real = Self::Real, Level = V, Array = Self>;
    /// How many numbers.
    const LANES: usize;
}

mod sealed {
    pub trait Sealed {}
}

/// One line a row type; the six have nothing in common that a generic `impl` could name.
macro_rules! rows {
    ($($real:ty, $lanes:literal => $lane:ident;)*) => {$(
        impl sealed::Sealed for [$real; $lanes] {}
        impl Row for [$real; $lanes] {
            type Real = $real;
            type Lane<V: Level> = V::$lane;
            const LANES: usize = $lanes;
        }
    )*};
}
rows! {
    f32, 4 => F32x4;
    f32, 8 => F32x8;
    f32, 16 => F32x16;
    f64, 2 => F64x2;
    f64, 4 => F64x4;
    f64, 8 => F64x8;
}
