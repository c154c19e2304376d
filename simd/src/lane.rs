//! [`Lanes`]: what a kernel may ask of a vector of numbers.

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
/// A constant needs a [`Level`] or another lane to stand beside ([`constant`](Self::constant)): a value of
/// the type is itself proof that the CPU can compute with it.
pub trait Lanes:
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
    /// The lanes of one register: these, or a fraction of them where they are several registers. A
    /// kernel that works part by part keeps its numbers in registers.
    type Native: Lanes<Real = Self::Real, Level = Self::Level>;
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
    fn constant(self, value: f64) -> Self {
        Self::splat(self.level(), Self::Real::from_f64(value))
    }

    /// Lane `i` from element `i`.
    fn load(level: Self::Level, from: &Self::Array) -> Self;
    /// Element `i` from lane `i`.
    fn store(self, to: &mut Self::Array);

    /// [`store`](Self::store) past the caches, where the CPU has such an instruction and `to` is
    /// aligned for it.
    ///
    /// # Safety
    /// Before anything else reads or writes `to`, [`Level::fence`] must have been called.
    #[inline(always)]
    unsafe fn stream(self, to: &mut Self::Array) {
        self.store(to);
    }

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
        let mut components = [Self::splat(level, Self::Real::default()); C];
        if let Some(from) = from.get(..Self::LANES)
            && C.is_multiple_of(4)
        {
            for (quad, first) in components.chunks_exact_mut(4).zip((0..C).step_by(4)) {
                let flat = from.as_flattened().get(first..).unwrap_or_default();
                quad.copy_from_slice(&Self::load_quads(level, flat, C));
            }
            return components;
        }
        if from.len() >= Self::LANES && C == 3 {
            let [x, y, z, _] = Self::load_quads(level, from.as_flattened(), C);
            components.copy_from_slice(&[x, y, z]);
            return components;
        }
        for (c, component) in components.iter_mut().enumerate() {
            let mut row = Self::Array::zeroed();
            for (lane, slot) in row.as_mut().iter_mut().enumerate() {
                *slot = from.get(lane).unwrap_or(&padding)[c];
            }
            *component = Self::load(level, &row);
        }
        components
    }
    /// Transposes on the way out: lane `i` of `C` vectors becomes record `i` of `to`.
    /// Records beyond `LANES` are left as they were.
    #[inline(always)]
    fn store_records<const C: usize>(components: [Self; C], to: &mut [[Self::Real; C]]) {
        if let Some(to) = to.get_mut(..Self::LANES)
            && C.is_multiple_of(4)
        {
            for (quad, first) in components.chunks_exact(4).zip((0..C).step_by(4)) {
                let flat = to.as_flattened_mut().get_mut(first..).unwrap_or_default();
                if let &[x, y, z, w] = quad {
                    Self::store_quads([x, y, z, w], flat, C);
                }
            }
            return;
        }
        if let (&[x, y, z], true) = (components.as_slice(), to.len() >= Self::LANES) {
            Self::store_triples([x, y, z], to.as_flattened_mut());
            return;
        }
        for (c, component) in components.into_iter().enumerate() {
            for (record, &value) in to.iter_mut().zip(component.to_array().as_ref()) {
                record[c] = value;
            }
        }
    }
    /// Transposes on the way in: lane `i` of four vectors is `from[i · stride ..][.. 4]`, zero where
    /// `from` ends before.
    #[inline(always)]
    fn load_quads(level: Self::Level, from: &[Self::Real], stride: usize) -> [Self; 4] {
        load_each(level, from, stride)
    }
    /// Transposes on the way out: lane `i` of four vectors goes to `to[i · stride ..][.. 4]`, for
    /// strides of 4 or more; what is beyond the end of `to` is dropped.
    #[inline(always)]
    fn store_quads(components: [Self; 4], to: &mut [Self::Real], stride: usize) {
        store_each(components, to, stride);
    }
    /// Transposes on the way out: lane `i` of three vectors goes to `to[3i ..][.. 3]`; what is beyond
    /// the end of `to` is dropped.
    #[inline(always)]
    fn store_triples(components: [Self; 3], to: &mut [Self::Real]) {
        store_each(components, to, 3);
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

/// [`Lanes::load_quads`] one number at a time.
#[inline(always)]
pub(crate) fn load_each<L: Lanes>(level: L::Level, from: &[L::Real], stride: usize) -> [L; 4] {
    let mut components = [L::splat(level, L::Real::default()); 4];
    for (c, component) in components.iter_mut().enumerate() {
        let mut row = L::Array::zeroed();
        for (lane, slot) in row.as_mut().iter_mut().enumerate() {
            *slot = from.get(lane * stride + c).copied().unwrap_or_default();
        }
        *component = L::load(level, &row);
    }
    components
}

/// [`Lanes::store_quads`] and [`Lanes::store_triples`] one number at a time.
#[inline(always)]
pub(crate) fn store_each<L: Lanes, const C: usize>(
    components: [L; C],
    to: &mut [L::Real],
    stride: usize,
) {
    for (c, component) in components.into_iter().enumerate() {
        for (lane, &value) in component.to_array().as_ref().iter().enumerate() {
            if let Some(slot) = to.get_mut(lane * stride + c) {
                *slot = value;
            }
        }
    }
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
    type Lanes<V: Level>: Lanes<Real = Self::Real, Level = V, Array = Self>;
    /// How many numbers.
    const LANES: usize;
}

/// The lanes of one register that read a row, or a part of it.
pub type Native<A, V> = <<A as Row>::Lanes<V> as Lanes>::Native;

mod sealed {
    pub trait Sealed {}
}

/// One line a row type; the six have nothing in common that a generic `impl` could name.
macro_rules! rows {
    ($($real:ty, $lanes:literal => $lane:ident;)*) => {$(
        impl sealed::Sealed for [$real; $lanes] {}
        impl Row for [$real; $lanes] {
            type Real = $real;
            type Lanes<V: Level> = V::$lane;
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
