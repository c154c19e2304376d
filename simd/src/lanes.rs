//! Numbers ([`Float`]), vectors of them ([`Lanes`], [`Mask`], [`PackedDualQuat`]), and instruction
//! sets ([`Level`]).
//!
//! The idea is that a kernel is written once, for any `L: Lanes`, and compiled once for every level
//! that is worth it. Which of these versions runs is decided by a value and not by a `cfg`:
//!
//! ```text
//! if let Some(level) = Avx2::detect() {    // asks the CPU; `level` is the proof
//!     level.run(|| {                       // from here on the compiler may use AVX2
//!         let x = L::load(level, &input);  // lanes are made from a level or from other lanes,
//!         (x * x).store(&mut output);      // so whoever holds lanes holds the proof too
//!     });
//! }
//! ```
//!
//! This is why arithmetic on lanes is not `unsafe`, although an AVX2 instruction on a CPU without
//! AVX2 is undefined behaviour: where there is no proof there are no lanes.
//!
//! The three traits name each other, which is why they are in one file: a number has vectors, a
//! vector belongs to an instruction set, and an instruction set has vectors of each number.

use crate::sealed::Sealed;
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
/// A constant is made from a [`Level`], or from another value of the type
/// ([`constant`](Self::constant)), which proves as well that the CPU can compute with it.
///
/// The trait is sealed, because [`Records`](crate::Records) trusts an implementation to read and
/// write as many numbers as it says.
pub trait Lanes:
    Sealed
    + Copy
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
    /// One truth value per lane.
    type Mask: Mask;
    /// The instructions that these lanes need.
    type Level: Level;
    /// The lanes of one register. They are these lanes, or a fraction of them if these fill several
    /// registers. A kernel that works on one such part after the other keeps its numbers in
    /// registers.
    type Native: Lanes<Real = Self::Real, Level = Self::Level>;
    /// The lanes in memory: `[Real; LANES]`.
    type Array: Pod + Debug + AsRef<[Self::Real]> + AsMut<[Self::Real]>;
    /// The number of lanes.
    const LANES: usize;

    /// Returns the level of these lanes: whoever holds lanes holds the proof that the CPU has the
    /// instructions.
    fn level(self) -> Self::Level;
    /// Returns a vector with `value` in every lane.
    fn splat(level: Self::Level, value: Self::Real) -> Self;
    /// The number nearest to `value` in every lane, for code that holds lanes and no level.
    #[inline(always)]
    #[must_use]
    fn constant(self, value: f64) -> Self {
        Self::splat(self.level(), Self::Real::from_f64(value))
    }

    /// Reads lane `i` from element `i`.
    fn load(level: Self::Level, from: &Self::Array) -> Self;
    /// Writes lane `i` to element `i`.
    fn store(self, to: &mut Self::Array);

    /// Stores like [`store`](Self::store), but past the caches, if the CPU has such an instruction
    /// and `to` is aligned for it.
    ///
    /// # Safety
    /// [`Level::fence`] must be called before anything else reads or writes `to`.
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn stream(self, to: &mut Self::Array) {
        self.store(to);
    }

    /// Reads the first elements of `from`, at most `LANES`. Lanes without an element are `padding`.
    #[inline(always)]
    fn load_partial(level: Self::Level, from: &[Self::Real], padding: Self::Real) -> Self {
        let mut array = Self::Array::zeroed();
        array.as_mut().fill(padding);
        for (slot, &value) in array.as_mut().iter_mut().zip(from) {
            *slot = value;
        }
        Self::load(level, &array)
    }
    /// Writes the first lanes to `to`, as many as it has elements. Elements after the first `LANES`
    /// are left as they were.
    #[inline(always)]
    fn store_partial(self, to: &mut [Self::Real]) {
        for (slot, &value) in to.iter_mut().zip(self.to_array().as_ref()) {
            *slot = value;
        }
    }
    /// Returns the lanes as an array.
    #[inline(always)]
    fn to_array(self) -> Self::Array {
        let mut array = Self::Array::zeroed();
        self.store(&mut array);
        array
    }

    /// Loads four numbers per lane and transposes them: number `c` at `from + offset(i)` becomes
    /// lane `i` of vector `c`. `offset` must be `#[inline(always)]`.
    ///
    /// # Safety
    /// The four numbers at each of these `LANES` places must be readable.
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn load_quads(
        level: Self::Level,
        from: *const Self::Real,
        offset: impl Fn(usize) -> usize,
    ) -> [Self; 4] {
        let mut rows = [Self::Array::zeroed(); 4];
        for lane in 0..Self::LANES {
            for (c, row) in rows.iter_mut().enumerate() {
                // SAFETY: the caller keeps the conditions of this function under `# Safety`, which
                // are those of the code here.
                row.as_mut()[lane] = unsafe { *from.add(offset(lane) + c) };
            }
        }
        let [x, y, z, w] = &rows;
        [Self::load(level, x), Self::load(level, y), Self::load(level, z), Self::load(level, w)]
    }
    /// Transposes four vectors and stores four numbers per lane: lane `i` of vector `c` becomes
    /// number `c` at `to + i · stride`.
    ///
    /// # Safety
    /// The four numbers at each of these `LANES` places must be writable, and nothing else may read
    /// or write them meanwhile.
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn store_quads(components: [Self; 4], to: *mut Self::Real, stride: usize) {
        // SAFETY: the caller keeps the conditions of this function under `# Safety`, which are
        // those of the code here.
        unsafe { store_rows(components, to, stride) };
    }
    /// Transposes three vectors and stores three numbers per lane: lane `i` of vector `c` becomes
    /// number `c` at `to + 3i`.
    ///
    /// # Safety
    /// As for [`store_quads`](Self::store_quads).
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn store_triples(components: [Self; 3], to: *mut Self::Real) {
        // SAFETY: the caller keeps the conditions of this function under `# Safety`, which are
        // those of the code here.
        unsafe { store_rows(components, to, 3) };
    }

    /// Loads `C` numbers per lane that adjoin, and transposes them: number `c` at `from + C·i`
    /// becomes lane `i` of vector `c`. Returns `None`, and reads nothing, if these lanes have no
    /// instructions for it: then [`load_quads`](Self::load_quads) is quicker.
    ///
    /// # Safety
    /// The `C` numbers at each of these `LANES` places must be readable.
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn load_adjoining<const C: usize>(
        level: Self::Level,
        from: *const Self::Real,
    ) -> Option<[Self; C]> {
        let _ = (level, from);
        None
    }
    /// Transposes `C` vectors and stores `C` numbers per lane that adjoin: lane `i` of vector `c`
    /// becomes number `c` at `to + C·i`. Returns `false`, and writes nothing, if these lanes have
    /// no instructions for it.
    ///
    /// # Safety
    /// As for [`store_quads`](Self::store_quads), with `C` numbers per lane.
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn store_adjoining<const C: usize>(components: [Self; C], to: *mut Self::Real) -> bool {
        let _ = (components, to);
        false
    }

    /// Interpolates between two records of four 16-bit numbers per lane. With
    /// `[a, b] = records(i)`, lane `i` of vector `c` is 2¹⁴((1−t)·aᶜ + t·bᶜ), where aᶜ
    /// is number `c` of record `from + a` and t is lane `i` of `t`.
    ///
    /// t is clamped to [0, 1], with 0 for NaN, and rounded to a multiple of 2⁻¹⁴. The result
    /// is exact before it is rounded to the type of a lane, so its bits are the same on every
    /// target. `records` must be `#[inline(always)]`.
    ///
    /// # Safety
    /// All these records must be readable.
    #[doc(hidden)]
    unsafe fn between_shorts(
        level: Self::Level,
        from: *const [u8; 8],
        records: impl Fn(usize) -> [usize; 2],
        t: Self,
    ) -> [Self; 4];

    /// Sums the lanes of four vectors in groups of four lanes: lane `i` of a group of the result is
    /// (v₀ + v₂) + (v₁ + v₃), where v are the lanes of that group in vector `i`. These are
    /// four dot products per group, if the vectors are the products. The number of lanes must be a
    /// multiple of four.
    #[inline(always)]
    #[must_use]
    fn sum_quads(vectors: [Self; 4]) -> Self {
        let mut sums = Self::Array::zeroed();
        for (which, vector) in vectors.into_iter().enumerate() {
            let numbers = vector.to_array();
            let groups = sums.as_mut().chunks_exact_mut(4).zip(numbers.as_ref().chunks_exact(4));
            for (sums, numbers) in groups {
                if let &[a, b, c, d] = numbers {
                    sums[which] = (a + c) + (b + d);
                }
            }
        }
        Self::load(vectors[0].level(), &sums)
    }

    /// Returns `self · factor + addend`, rounded once if the hardware fuses.
    #[must_use]
    fn mul_add(self, factor: Self, addend: Self) -> Self;
    /// Returns `addend − self · factor`, rounded once if the hardware fuses.
    #[must_use]
    fn neg_mul_add(self, factor: Self, addend: Self) -> Self;
    /// The correctly rounded square root. Below zero it is NaN.
    #[must_use]
    fn sqrt(self) -> Self;
    /// The value without its sign. NaN stays NaN.
    #[must_use]
    fn abs(self) -> Self;
    /// The magnitude of `self` with the sign bit of `sign`.
    #[must_use]
    fn copysign(self, sign: Self) -> Self;

    /// `self < other`, which is false if either is NaN.
    fn lt(self, other: Self) -> Self::Mask;
    /// `self ≤ other`, which is false if either is NaN.
    fn le(self, other: Self) -> Self::Mask;
    /// `self = other`, which is false if either is NaN, and true for zeros of either sign.
    fn eq(self, other: Self) -> Self::Mask;
    /// `yes` in the lanes in which `mask` is true, and `no` in the others.
    #[must_use]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
}

/// Transposes `C` vectors and stores one number at a time.
///
/// # Safety
/// The same as for [`Lanes::store_quads`], with `C` numbers per lane.
#[inline(always)]
unsafe fn store_rows<L: Lanes, const C: usize>(
    components: [L; C],
    to: *mut L::Real,
    stride: usize,
) {
    for (c, component) in components.into_iter().enumerate() {
        for (lane, &number) in component.to_array().as_ref().iter().enumerate() {
            // SAFETY: the caller keeps the conditions of this function under `# Safety`, which are
            // those of the code here.
            unsafe { *to.add(lane * stride + c) = number };
        }
    }
}

/// One truth value per lane.
pub trait Mask:
    Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self>
{
    /// The number of lanes.
    const LANES: u32;
    /// True if at least one lane is.
    fn any(self) -> bool;
    /// True if every lane is.
    fn all(self) -> bool;
    /// The lanes as bits: bit `i` is lane `i`. The bits beyond the last lane are zero.
    fn to_bitmask(self) -> u32;
}

/// A set of instructions, held as a value that proves the CPU has them.
///
/// Anyone may construct [`Portable`](crate::Portable), because its lanes use only what the build
/// target promises. A level whose instructions are detected at run time has a private field, so
/// only its `detect` can make one. The trait is sealed.
pub trait Level: Sealed + Copy + Debug + Send + Sync + 'static {
    /// Four lanes of `f32`.
    type F32x4: Lanes<Real = f32, Level = Self, Array = [f32; 4]>;
    /// Eight lanes of `f32`.
    type F32x8: PackedDualQuat<Real = f32, Level = Self, Array = [f32; 8]>;
    /// Sixteen lanes of `f32`.
    type F32x16: Lanes<Real = f32, Level = Self, Array = [f32; 16]>;
    /// Two lanes of `f64`.
    type F64x2: Lanes<Real = f64, Level = Self, Array = [f64; 2]>;
    /// Four lanes of `f64`.
    type F64x4: Lanes<Real = f64, Level = Self, Array = [f64; 4]>;
    /// Eight lanes of `f64`.
    type F64x8: PackedDualQuat<Real = f64, Level = Self, Array = [f64; 8]>;

    /// The `f32` lanes that fill a register.
    type Single: Lanes<Real = f32, Level = Self>;
    /// The `f64` lanes that fill a register.
    type Double: Lanes<Real = f64, Level = Self>;

    /// Waits until other instructions see what was stored past the caches.
    #[inline(always)]
    fn fence(self) {}

    /// Prefetches the cache lines of `value`, which will be read or written soon. This pays for
    /// memory that is read in order and is larger than the first-level cache: the CPU foresees such
    /// reads too, but later.
    #[inline(always)]
    fn prefetch<T>(self, value: &T) {
        let _ = value;
    }

    /// Prefetches the first cache line of every `stride`-th value of `memory`, `count` of them in
    /// all, for lanes whose values are not neighbours. Places beyond the end of `memory` are
    /// prefetched too: that is harmless, and cheaper than to test for the end.
    #[inline(always)]
    fn prefetch_every<T>(self, memory: &[T], stride: usize, count: usize) {
        let _ = (memory, stride, count);
    }

    /// Returns `value`, and makes the compiler hold its address in one register. AVX-512 can load a
    /// number into every lane, multiply and add in one step, but only in two if the address is a
    /// sum of registers; a compiler prefers the sum, which saves the instruction that computes the
    /// address.
    #[inline(always)]
    fn locate<T>(self, value: &T) -> &T {
        value
    }

    /// Runs `kernel` compiled with the instructions of this level.
    ///
    /// Everything that `kernel` calls must be `#[inline(always)]`, or it is compiled without them.
    fn run<R>(self, kernel: impl FnOnce() -> R) -> R;
}

/// `f32` or `f64`: the number in a lane, its vectors, and constants of it. The trait is sealed.
pub trait Float:
    Pod
    + Send
    + Sync
    + PartialOrd
    + Default
    + Debug
    + From<f32>
    + Into<f64>
    + core::ops::Neg<Output = Self>
    + core::ops::Add<Output = Self>
    + Sealed
{
    /// True for `f32`, false for `f64`.
    const SINGLE: bool;
    /// The lanes of this number that fill a register of `V`.
    type Lanes<V: Level>: Lanes<Real = Self, Level = V>;
    /// The lanes that hold one record of eight of this number.
    type Packed<V: Level>: PackedDualQuat<Real = Self, Level = V, Array = [Self; 8]>;
    /// The lanes that hold half a record of eight.
    type Half<V: Level>: Lanes<Real = Self, Level = V, Array = [Self; 4]>;
    /// The number of this type that is nearest to `value`.
    fn from_f64(value: f64) -> Self;
    /// The number of this type that is nearest to `value`.
    fn from_i32(value: i32) -> Self;
}

impl Float for f32 {
    const SINGLE: bool = true;
    type Lanes<V: Level> = V::Single;
    type Packed<V: Level> = V::F32x8;
    type Half<V: Level> = V::F32x4;
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
    fn from_f64(value: f64) -> Self {
        value as f32
    }
    #[inline(always)]
    fn from_i32(value: i32) -> Self {
        value as Self
    }
}

impl Float for f64 {
    const SINGLE: bool = false;
    type Lanes<V: Level> = V::Double;
    type Packed<V: Level> = V::F64x8;
    type Half<V: Level> = V::F64x4;
    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn from_i32(value: i32) -> Self {
        value.into()
    }
}

/// Eight lanes `[px, py, pz, pw, qx, qy, qz, qw]`: one dual quaternion p + εq, as it lies in
/// memory.
///
/// Such vectors serve kernels that have only one motion to compute at a time, as where a child
/// waits for its parent. A product of two of them needs only two rearrangements that [`Lanes`] does
/// not have: [`columns`](Self::columns) and [`times_epsilon`](Self::times_epsilon).
pub trait PackedDualQuat: Lanes {
    /// Reads the same four components into both halves.
    #[inline(always)]
    fn load_twice(level: Self::Level, from: &[Self::Real; 4]) -> Self {
        let mut twice = Self::Array::zeroed();
        for half in twice.as_mut().chunks_exact_mut(4) {
            half.copy_from_slice(from);
        }
        Self::load(level, &twice)
    }

    /// Returns eight vectors, each with one of the eight components in all lanes.
    #[inline(always)]
    fn splat_each(level: Self::Level, from: &[Self::Real; 8]) -> [Self; 8] {
        let &[a, b, c, d, e, f, g, h] = level.locate(from);
        [
            Self::splat(level, a),
            Self::splat(level, b),
            Self::splat(level, c),
            Self::splat(level, d),
            Self::splat(level, e),
            Self::splat(level, f),
            Self::splat(level, g),
            Self::splat(level, h),
        ]
    }

    /// Returns the columns of the matrix that multiplies from the left, in both halves: for a
    /// quaternion b, p·b = c₀b_x + c₁b_y + c₂b_z + c₃b_w.
    ///
    /// ```text
    /// c₀ = (pw, pz, −py, −px)   c₁ = (−pz, pw, px, −py)
    /// c₂ = (py, −px, pw, −pz)   c₃ = p
    /// ```
    #[inline(always)]
    #[must_use]
    fn columns(self) -> [Self; 4] {
        let level = self.level();
        let from = self.to_array();
        let mut columns = [Self::Array::zeroed(); 3];
        for (half, p) in from.as_ref().chunks_exact(4).enumerate() {
            let &[x, y, z, w] = p else { break };
            let rows = [[w, z, -y, -x], [-z, w, x, -y], [y, -x, w, -z]];
            for (column, row) in columns.iter_mut().zip(rows) {
                for (slot, value) in column.as_mut().iter_mut().skip(4 * half).zip(row) {
                    *slot = value;
                }
            }
        }
        let [x, y, z] = &columns;
        [Self::load(level, x), Self::load(level, y), Self::load(level, z), self]
    }

    /// Returns ε·(p + εq) = εp: the lower half moves to the upper half, and the lower half
    /// becomes −0.
    ///
    /// It is −0 and not +0, because the result is added to another dual quaternion: x + (−0) is
    /// x for every x, but −0 + (+0) is +0.
    #[inline(always)]
    #[must_use]
    fn times_epsilon(self) -> Self {
        let mut shifted = self.constant(-0.0).to_array();
        let half = self.to_array();
        for (slot, &value) in shifted.as_mut().iter_mut().skip(4).zip(half.as_ref()) {
            *slot = value;
        }
        Self::load(self.level(), &shifted)
    }
}
