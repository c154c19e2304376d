//! [`Lanes`]: what a kernel may ask of a vector of numbers.

use crate::float::Float;
use crate::level::Level;
use bytemuck::{Pod, Zeroable};
use core::fmt::Debug;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// The most lanes that a register of any level has.
pub const MAX_LANES: usize = 16;

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
        Self::load_strided(level, from, None, &padding)
    }
    /// Transposes on the way out: lane `i` of `C` vectors becomes record `i` of `to`.
    /// Records beyond `LANES` are left as they were.
    #[inline(always)]
    fn store_records<const C: usize>(components: [Self; C], to: &mut [[Self::Real; C]]) {
        Self::store_strided(components, to, None);
    }
    /// [`load_records`](Self::load_records) of every `stride`-th record; `None` is 1, which the compiler
    /// can see.
    #[inline(always)]
    fn load_strided<const C: usize>(
        level: Self::Level,
        from: &[[Self::Real; C]],
        stride: Option<usize>,
        padding: &[Self::Real; C],
    ) -> [Self; C] {
        let mut components = [Self::splat(level, Self::Real::default()); C];
        let flat = from.as_flattened();
        let apart = C.saturating_mul(stride.unwrap_or(1));
        // Four numbers are read of a record of three.
        if C < 3 || flat.len() < reach(Self::LANES, apart, C.max(4)) {
            let rows = load_each::<Self, C>(from, stride.unwrap_or(1), padding);
            for (component, row) in components.iter_mut().zip(&rows) {
                *component = Self::load(level, row);
            }
            return components;
        }
        // Four components at a time; the last four begin earlier where C is no multiple of four.
        let mut first = 0;
        loop {
            // SAFETY: record `LANES − 1` begins `(LANES − 1) · apart` numbers from the start, and four
            // numbers from `first` on are part of it, or, of three, are there: checked above.
            let quad = unsafe { Self::load_quads(level, flat.as_ptr().add(first), apart) };
            for (component, loaded) in components.iter_mut().skip(first).zip(quad) {
                *component = loaded;
            }
            if first + 4 >= C {
                return components;
            }
            first = (first + 4).min(C - 4);
        }
    }
    /// [`store_records`](Self::store_records) to every `stride`-th record; `None` is 1.
    #[inline(always)]
    fn store_strided<const C: usize>(
        components: [Self; C],
        to: &mut [[Self::Real; C]],
        stride: Option<usize>,
    ) {
        let flat = to.as_flattened_mut();
        let apart = C.saturating_mul(stride.unwrap_or(1));
        let fits = flat.len() >= reach(Self::LANES, apart, C);
        if let (&[x, y, z], true, 3) = (components.as_slice(), fits, apart) {
            // SAFETY: checked above.
            return unsafe { Self::store_triples([x, y, z], flat.as_mut_ptr()) };
        }
        if C < 4 || !fits {
            let mut rows = [Self::Array::zeroed(); C];
            for (row, component) in rows.iter_mut().zip(components) {
                component.store(row);
            }
            return store_each::<Self, C>(&rows, to, stride.unwrap_or(1));
        }
        let mut first = 0;
        while let Some(&[x, y, z, w]) = components.get(first..).and_then(|rest| rest.first_chunk())
        {
            // SAFETY: record `LANES − 1` begins `(LANES − 1) · apart` numbers from the start, and four
            // numbers from `first` on are part of it: checked above.
            unsafe { Self::store_quads([x, y, z, w], flat.as_mut_ptr().add(first), apart) };
            if first + 4 >= C {
                return;
            }
            first = (first + 4).min(C - 4);
        }
    }
    /// Transposes on the way in: lane `i` of four vectors is the four numbers at `from + i · stride`.
    ///
    /// # Safety
    /// All those numbers may be read.
    #[inline(always)]
    unsafe fn load_quads(level: Self::Level, from: *const Self::Real, stride: usize) -> [Self; 4] {
        let mut rows = [Self::Array::zeroed(); 4];
        for lane in 0..Self::LANES {
            for (c, row) in rows.iter_mut().enumerate() {
                // SAFETY: promised.
                row.as_mut()[lane] = unsafe { *from.add(lane * stride + c) };
            }
        }
        let [x, y, z, w] = &rows;
        [Self::load(level, x), Self::load(level, y), Self::load(level, z), Self::load(level, w)]
    }
    /// Transposes on the way out: lane `i` of four vectors goes to the four numbers at `to + i · stride`.
    ///
    /// # Safety
    /// All those numbers may be written, and nothing else reads or writes them.
    #[inline(always)]
    unsafe fn store_quads(components: [Self; 4], to: *mut Self::Real, stride: usize) {
        // SAFETY: promised.
        unsafe { store_rows(components, to, stride) };
    }
    /// Transposes on the way out: lane `i` of three vectors goes to the three numbers at `to + 3i`.
    ///
    /// # Safety
    /// As for [`store_quads`](Self::store_quads).
    #[inline(always)]
    unsafe fn store_triples(components: [Self; 3], to: *mut Self::Real) {
        // SAFETY: promised.
        unsafe { store_rows(components, to, 3) };
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

/// How many numbers `lanes` records of `count` reach over, `stride` apart.
#[inline(always)]
pub(crate) fn reach(lanes: usize, stride: usize, count: usize) -> usize {
    stride.saturating_mul(lanes - 1).saturating_add(count)
}

/// Transposes on the way out one number at a time.
///
/// # Safety
/// As for [`Lanes::store_quads`], of `C` numbers.
#[inline(always)]
unsafe fn store_rows<L: Lanes, const C: usize>(
    components: [L; C],
    to: *mut L::Real,
    stride: usize,
) {
    for (c, component) in components.into_iter().enumerate() {
        for (lane, &number) in component.to_array().as_ref().iter().enumerate() {
            // SAFETY: promised.
            unsafe { *to.add(lane * stride + c) = number };
        }
    }
}

/// [`Lanes::load_strided`] one number at a time: where the records end. Not inlined, and without
/// vectors: the loop that calls it keeps its registers.
#[cold]
#[inline(never)]
fn load_each<L: Lanes, const C: usize>(
    from: &[[L::Real; C]],
    stride: usize,
    padding: &[L::Real; C],
) -> [L::Array; C] {
    let mut rows = [L::Array::zeroed(); C];
    let mut records = from.iter().step_by(stride.max(1));
    for lane in 0..L::LANES {
        for (row, &value) in rows.iter_mut().zip(records.next().unwrap_or(padding)) {
            row.as_mut()[lane] = value;
        }
    }
    rows
}

/// [`Lanes::store_strided`] one number at a time: where the records end.
#[cold]
#[inline(never)]
fn store_each<L: Lanes, const C: usize>(
    rows: &[L::Array; C],
    to: &mut [[L::Real; C]],
    stride: usize,
) {
    for (lane, record) in to.iter_mut().step_by(stride.max(1)).take(L::LANES).enumerate() {
        for (slot, row) in record.iter_mut().zip(rows) {
            *slot = row.as_ref()[lane];
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
