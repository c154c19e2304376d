//! The traits of element types ([`Float`]), of vectors ([`Lanes`], [`Mask`], [`PackedDualQuat`]),
//! and of instruction sets ([`Level`]).
//!
//! A kernel is written once, for any `L: Lanes`, and the compiler makes a monomorphised copy of it
//! for every level that calls it. A value of the level chooses the copy at run time:
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
//! Lanes are made only from a level or from other lanes, and only detection makes a level whose
//! instructions the build target lacks. That is why arithmetic on lanes is not `unsafe`, although
//! an AVX2 instruction on a CPU without AVX2 is undefined behaviour.
//!
//! [`Float`], [`Lanes`] and [`Level`] are in one file because they name each other: an element type
//! has vectors, a vector belongs to a level, and a level has vectors of each element type.

use crate::sealed::Sealed;
use bytemuck::{Pod, Zeroable};
use core::fmt::Debug;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// The largest lane count of any level: sixteen `f32`.
pub const MAX_LANES: usize = 16;

/// A vector of `LANES` floating-point values, one per lane. Each operation acts on all lanes.
///
/// Arithmetic is IEEE 754 lane by lane. Only [`mul_add`](Self::mul_add) and
/// [`neg_mul_add`](Self::neg_mul_add) may differ between types: they round once if the lanes fuse
/// the multiplication with the addition, and twice if they do not.
///
/// A vector with one value in all lanes is made from a [`Level`] ([`splat`](Self::splat)) or from
/// another vector of the type ([`constant`](Self::constant)). Either of them proves that the CPU
/// has the instructions of the type.
///
/// The trait is sealed, because the unsafe code of [`Records`](crate::Records) relies on `LANES`
/// being the length of `Array`.
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
    /// The element type: `f32` or `f64`.
    type Real: Float;
    /// One truth value per lane.
    type Mask: Mask;
    /// The level whose instructions these lanes need.
    type Level: Level;
    /// The lanes that fill one register: this type, or a narrower type if a vector of this type
    /// needs several registers. A kernel over the narrower type keeps its values in registers
    /// instead of spilling them to the stack.
    type Native: Lanes<Real = Self::Real, Level = Self::Level>;
    /// The array of the lanes in memory, `[Real; LANES]`.
    type Array: Pod + Debug + AsRef<[Self::Real]> + AsMut<[Self::Real]>;
    /// The lane count.
    const LANES: usize;

    /// Returns the level of these lanes: whoever holds lanes holds the proof that the CPU has the
    /// instructions.
    fn level(self) -> Self::Level;
    /// Returns a vector with `value` in every lane.
    fn splat(level: Self::Level, value: Self::Real) -> Self;
    /// Returns a vector with `value`, rounded to the element type, in every lane. This is for code
    /// that has lanes but no level.
    #[inline(always)]
    #[must_use]
    fn constant(self, value: f64) -> Self {
        Self::splat(self.level(), Self::Real::from_f64(value))
    }

    /// Loads element `i` of `from` into lane `i`.
    fn load(level: Self::Level, from: &Self::Array) -> Self;
    /// Stores lane `i` to element `i` of `to`.
    fn store(self, to: &mut Self::Array);

    /// Stores like [`store`](Self::store), but past the caches, if the CPU has a non-temporal store
    /// and `to` is aligned to the register. Otherwise it stores through the caches.
    ///
    /// # Safety
    /// [`Level::fence`] must be called before any other code reads or writes `to`.
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn stream(self, to: &mut Self::Array) {
        self.store(to);
    }

    /// Loads the first elements of `from`, at most `LANES`. If `from` has fewer than `LANES`
    /// elements, the remaining lanes are `padding`.
    #[inline(always)]
    fn load_partial(level: Self::Level, from: &[Self::Real], padding: Self::Real) -> Self {
        let mut array = Self::Array::zeroed();
        array.as_mut().fill(padding);
        for (slot, &value) in array.as_mut().iter_mut().zip(from) {
            *slot = value;
        }
        Self::load(level, &array)
    }
    /// Stores the first lanes to `to`, one per element. Elements of `to` after the first `LANES`
    /// keep their values.
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

    /// Loads four components per lane and transposes them: component `c` at `from + offset(i)`
    /// becomes lane `i` of vector `c`. Offsets count elements. The closure `offset` must be
    /// `#[inline(always)]`.
    ///
    /// # Safety
    /// For each lane `i`, the four components from `from + offset(i)` on must be readable.
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
                // SAFETY: `c` is below four, and the caller guarantees that the four components
                // from `from + offset(lane)` on are readable for each lane.
                row.as_mut()[lane] = unsafe { *from.add(offset(lane) + c) };
            }
        }
        let [x, y, z, w] = &rows;
        [Self::load(level, x), Self::load(level, y), Self::load(level, z), Self::load(level, w)]
    }
    /// Transposes four vectors and stores four components per lane: lane `i` of vector `c` becomes
    /// component `c` at `to + i · stride`. The stride counts elements.
    ///
    /// # Safety
    /// For each lane `i`, the four components from `to + i · stride` on must be writable, and no
    /// other thread may read or write them during the call.
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn store_quads(components: [Self; 4], to: *mut Self::Real, stride: usize) {
        // SAFETY: `store_rows` writes four components at `to + i · stride` for each lane `i`,
        // which the caller guarantees to be writable and unused by other threads.
        unsafe { store_rows(components, to, stride) };
    }
    /// Transposes three vectors and stores three components per lane: lane `i` of vector `c`
    /// becomes component `c` at `to + 3i`.
    ///
    /// # Safety
    /// The `3 · LANES` components from `to` on must be writable, and no other thread may read or
    /// write them during the call.
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn store_triples(components: [Self; 3], to: *mut Self::Real) {
        // SAFETY: `store_rows` writes three components at `to + 3i` for each lane `i`, which the
        // caller guarantees to be writable and unused by other threads.
        unsafe { store_rows(components, to, 3) };
    }

    /// Loads records of `C` components that adjoin in memory, one per lane, and transposes them:
    /// component `c` at `from + C·i` becomes lane `i` of vector `c`. Returns `None`, and reads
    /// nothing, if these lanes have no instruction for records of this length. Then
    /// [`load_quads`](Self::load_quads) is quicker.
    ///
    /// # Safety
    /// The `C · LANES` components from `from` on must be readable.
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn load_adjoining<const C: usize>(
        level: Self::Level,
        from: *const Self::Real,
    ) -> Option<[Self; C]> {
        let _ = (level, from);
        None
    }
    /// Transposes `C` vectors and stores records of `C` components that adjoin in memory: lane `i`
    /// of vector `c` becomes component `c` at `to + C·i`. Returns `false`, and writes nothing, if
    /// these lanes have no instruction for records of this length.
    ///
    /// # Safety
    /// The `C · LANES` components from `to` on must be writable, and no other thread may read or
    /// write them during the call.
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn store_adjoining<const C: usize>(components: [Self; C], to: *mut Self::Real) -> bool {
        let _ = (components, to);
        false
    }

    /// Interpolates between two records of four 16-bit integers per lane. With
    /// `[a, b] = records(i)`, lane `i` of vector `c` is 2¹⁴((1−t)·aᶜ + t·bᶜ), where aᶜ
    /// is component `c` of record `from + a`, bᶜ is component `c` of record `from + b`, and t is
    /// lane `i` of `t`.
    ///
    /// t is clamped to [0, 1], with 0 for NaN, and rounded to a multiple of 2⁻¹⁴. The sum is
    /// computed exactly and then rounded to the element type, so its bits are the same on every
    /// target. The closure `records` must be `#[inline(always)]`.
    ///
    /// # Safety
    /// For each lane `i`, the two records `from + a` and `from + b` with `[a, b] = records(i)` must
    /// be readable.
    #[doc(hidden)]
    unsafe fn between_shorts(
        level: Self::Level,
        from: *const [u8; 8],
        records: impl Fn(usize) -> [usize; 2],
        t: Self,
    ) -> [Self; 4];

    /// Sums each group of four adjacent lanes, for four vectors at once. Lane `i` of a group of the
    /// result is (v₀ + v₂) + (v₁ + v₃), where v₀ to v₃ are the lanes of that group in
    /// vector `i`. If the vectors are products of components, each sum is a dot product. `LANES`
    /// must be a multiple of four.
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

    /// Returns `self · factor + addend`, rounded once if the lanes fuse, and twice if they do not.
    #[must_use]
    fn mul_add(self, factor: Self, addend: Self) -> Self;
    /// Returns `addend − self · factor`, rounded once if the lanes fuse, and twice if they do
    /// not.
    #[must_use]
    fn neg_mul_add(self, factor: Self, addend: Self) -> Self;
    /// Returns the correctly rounded square root, which is NaN for values below zero.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Returns the absolute value of each lane. NaN stays NaN.
    #[must_use]
    fn abs(self) -> Self;
    /// Returns the magnitude of `self` with the sign bit of `sign`.
    #[must_use]
    fn copysign(self, sign: Self) -> Self;

    /// Compares `self < other`, which is false in lanes where either value is NaN.
    fn lt(self, other: Self) -> Self::Mask;
    /// Compares `self ≤ other`, which is false in lanes where either value is NaN.
    fn le(self, other: Self) -> Self::Mask;
    /// Compares `self = other`, which is false in lanes where either value is NaN. Zeros of
    /// different signs are equal.
    fn eq(self, other: Self) -> Self::Mask;
    /// Returns `yes` in the lanes in which `mask` is true, and `no` in the lanes in which it is
    /// false.
    #[must_use]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
}

/// Transposes `C` vectors and stores one component at a time: lane `i` of vector `c` becomes
/// component `c` at `to + i · stride`.
///
/// # Safety
/// For each lane `i`, the `C` components from `to + i · stride` on must be writable, and no other
/// thread may read or write them during the call.
#[inline(always)]
unsafe fn store_rows<L: Lanes, const C: usize>(
    components: [L; C],
    to: *mut L::Real,
    stride: usize,
) {
    for (c, component) in components.into_iter().enumerate() {
        for (lane, &number) in component.to_array().as_ref().iter().enumerate() {
            // SAFETY: `lane` is below `LANES` and `c` below `C`, so this write goes to a component
            // that the caller guarantees to be writable and unused by other threads.
            unsafe { *to.add(lane * stride + c) = number };
        }
    }
}

/// One truth value per lane.
pub trait Mask:
    Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self>
{
    /// The lane count.
    const LANES: u32;
    /// Returns true if at least one lane is true.
    fn any(self) -> bool;
    /// Returns true if every lane is true.
    fn all(self) -> bool;
    /// Returns the lanes as bits: bit `i` is lane `i`, and the bits after the last lane are zero.
    fn to_bitmask(self) -> u32;
}

/// An instruction set, held as a value that proves that the CPU has it.
///
/// All code may construct [`Portable`](crate::Portable), because its lanes use only the
/// instructions of the build target. The levels whose instructions are detected at run time, `Avx2`
/// and `Avx512`, have a private field, so only their method `detect` can make a value. The trait is
/// sealed.
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

    /// The `f32` lanes that fill one register.
    type Single: Lanes<Real = f32, Level = Self>;
    /// The `f64` lanes that fill one register.
    type Double: Lanes<Real = f64, Level = Self>;

    /// Orders the stores that went past the caches ([`Lanes::stream`]) before all later stores, so
    /// that other threads see them in this order.
    #[inline(always)]
    fn fence(self) {}

    /// Prefetches the cache lines of `value`, which will be read or written soon. This pays for
    /// memory that is read in order and is larger than the first-level cache: the CPU prefetches
    /// such memory by itself too, but later.
    #[inline(always)]
    fn prefetch<T>(self, value: &T) {
        let _ = value;
    }

    /// Prefetches the first cache line of every `stride`-th value of `memory`, `count` lines
    /// altogether, for lanes whose values do not adjoin. Addresses beyond the end of `memory` are
    /// prefetched too, which is harmless and cheaper than a test for the end.
    #[inline(always)]
    fn prefetch_every<T>(self, memory: &[T], stride: usize, count: usize) {
        let _ = (memory, stride, count);
    }

    /// Returns `value`, and makes the compiler hold its address in one register. An AVX-512
    /// multiply-add that broadcasts an operand from memory takes one step of the CPU's front end,
    /// but two if the address is a sum of registers. The compiler alone would choose the sum, which
    /// saves the instruction that computes the address (docs/measured.md, *One address*).
    #[inline(always)]
    fn locate<T>(self, value: &T) -> &T {
        value
    }

    /// Runs `kernel` compiled with the instructions of this level.
    ///
    /// Every function that `kernel` calls must be `#[inline(always)]`, or it is compiled without
    /// the instructions of this level.
    fn run<R>(self, kernel: impl FnOnce() -> R) -> R;
}

/// The element type of a lane, `f32` or `f64`, with its vectors and its constants. The trait is
/// sealed.
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
    /// The lanes of this element type that fill one register of the level `V`.
    type Lanes<V: Level>: Lanes<Real = Self, Level = V>;
    /// The eight lanes that hold one dual quaternion of this element type.
    type Packed<V: Level>: PackedDualQuat<Real = Self, Level = V, Array = [Self; 8]>;
    /// The four lanes that hold half a dual quaternion, one quaternion.
    type Half<V: Level>: Lanes<Real = Self, Level = V, Array = [Self; 4]>;
    /// Returns `value` rounded to this type.
    fn from_f64(value: f64) -> Self;
    /// Returns `value` rounded to this type.
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

/// Eight lanes `[px, py, pz, pw, qx, qy, qz, qw]` that hold one dual quaternion p + εq in the
/// order of memory.
///
/// Such vectors serve kernels that can compute only one motion at a time, because each joint needs
/// the pose of its parent first. The product of two dual quaternions needs two rearrangements of
/// lanes that [`Lanes`] does not have: [`columns`](Self::columns) and
/// [`times_epsilon`](Self::times_epsilon).
pub trait PackedDualQuat: Lanes {
    /// Loads the four components of `from` into lanes 0 to 3 and again into lanes 4 to 7.
    #[inline(always)]
    fn load_twice(level: Self::Level, from: &[Self::Real; 4]) -> Self {
        let mut twice = Self::Array::zeroed();
        for half in twice.as_mut().chunks_exact_mut(4) {
            half.copy_from_slice(from);
        }
        Self::load(level, &twice)
    }

    /// Returns eight vectors: vector `c` has component `c` of `from` in all lanes.
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

    /// Returns the columns c₀ to c₃ of the matrix of the multiplication from the left by p,
    /// such that p·b = c₀b_x + c₁b_y + c₂b_z + c₃b_w for every quaternion b. The lower
    /// half of each vector has the column of p, and the upper half that of q.
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
    /// The lower half is −0 and not +0, because the result is added to another dual quaternion:
    /// x + (−0) is x for every x, but −0 + (+0) is +0.
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
