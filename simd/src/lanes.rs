//! Numbers, vectors of them, and instruction sets: [`Float`], [`Lanes`] and [`Mask`], [`Level`],
//! [`PackedDualQuat`]. They name each other: a number has vectors, a vector belongs to an
//! instruction set, and an instruction set has vectors of each number.

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
/// A constant needs a [`Level`] or another value of the type ([`constant`](Self::constant)): a
/// value of the type is itself proof that the CPU can compute with it.
///
/// Sealed: [`Records`](crate::Records) takes the word of an implementation for how much it reads
/// and writes.
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
    #[doc(hidden)]
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

    /// Transposes on the way in: lane `i` of four vectors is the four numbers at `from + place(i)`.
    /// `place` must be `#[inline(always)]`.
    ///
    /// # Safety
    /// All those numbers may be read.
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn load_quads(
        level: Self::Level,
        from: *const Self::Real,
        place: impl Fn(usize) -> usize,
    ) -> [Self; 4] {
        let mut rows = [Self::Array::zeroed(); 4];
        for lane in 0..Self::LANES {
            for (c, row) in rows.iter_mut().enumerate() {
                // SAFETY: promised.
                row.as_mut()[lane] = unsafe { *from.add(place(lane) + c) };
            }
        }
        let [x, y, z, w] = &rows;
        [Self::load(level, x), Self::load(level, y), Self::load(level, z), Self::load(level, w)]
    }
    /// Transposes on the way out: lane `i` of four vectors goes to the four numbers at
    /// `to + i · stride`.
    ///
    /// # Safety
    /// All those numbers may be written, and nothing else reads or writes them.
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn store_quads(components: [Self; 4], to: *mut Self::Real, stride: usize) {
        // SAFETY: promised.
        unsafe { store_rows(components, to, stride) };
    }
    /// Transposes on the way out: lane `i` of three vectors goes to the three numbers at `to + 3i`.
    ///
    /// # Safety
    /// As for [`store_quads`](Self::store_quads).
    #[doc(hidden)]
    #[inline(always)]
    unsafe fn store_triples(components: [Self; 3], to: *mut Self::Real) {
        // SAFETY: promised.
        unsafe { store_rows(components, to, 3) };
    }

    /// Lane `i` of four vectors is 2¹⁴((1−t)a + tb), exact but for the last rounding, of the
    /// four numbers of the records a and b of `from` whose places are `place(i)`. t is cut to [0,
    /// 1], NaN to 0, and rounded to a multiple of 2⁻¹⁴. The bits are the same on every target.
    /// `place` must be `#[inline(always)]`.
    ///
    /// # Safety
    /// All those records may be read.
    #[doc(hidden)]
    unsafe fn between_shorts(
        level: Self::Level,
        from: *const [u8; 8],
        place: impl Fn(usize) -> [usize; 2],
        t: Self,
    ) -> [Self; 4];

    /// In each group of four lanes, lane `i` is the sum of the group's numbers of vector `i`, as
    /// (0 + 2) + (1 + 3): four dot products whose products are there. For vectors of four lanes or
    /// a multiple of that.
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

/// One truth value per lane.
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

/// A set of instructions, held as a value that proves the CPU has them.
///
/// [`Portable`](crate::Portable) is free to construct, because its lanes use what the build target
/// already promises. A level whose instructions are found at run time has a private field, so that
/// only detection can hand it out; whoever holds one of its lanes therefore holds the proof too.
/// Sealed.
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

    /// Waits until what was stored past the caches is where other instructions see it.
    #[inline(always)]
    fn fence(self) {}

    /// Asks for the cache lines of `value`, which will be read or written soon. For what is read
    /// one after the other over more memory than the first cache holds: the CPU guesses that too,
    /// but later.
    #[inline(always)]
    fn prefetch<T>(self, value: &T) {
        let _ = value;
    }

    /// Asks for where `count` values begin, `stride` apart, of which the first is the first of
    /// `memory`; for lanes that lie apart. Those beyond its end are asked for too, which harms
    /// nobody and saves the question.
    #[inline(always)]
    fn prefetch_every<T>(self, memory: &[T], stride: usize, count: usize) {
        let _ = (memory, stride, count);
    }

    /// `value`, whose address is in a register of its own. For values of which single numbers are
    /// multiplied into every lane: AVX-512 loads, multiplies and adds in one step from such an
    /// address, and in two from a sum of registers, which a compiler would take to save an
    /// instruction.
    #[inline(always)]
    fn locate<T>(self, value: &T) -> &T {
        value
    }

    /// Runs `kernel` compiled with the instructions of this level.
    ///
    /// Everything that `kernel` calls must be `#[inline(always)]`, or it is compiled without them.
    fn run<R>(self, kernel: impl FnOnce() -> R) -> R;
}

/// `f32` or `f64`, as far as a kernel must tell them apart: to write constants and to find its
/// lanes. Sealed.
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
    /// Whether this is `f32`.
    const SINGLE: bool;
    /// The lanes of this number that fill a register of `V`.
    type Lanes<V: Level>: Lanes<Real = Self, Level = V>;
    /// The lanes that hold one record of eight of this number.
    type Packed<V: Level>: PackedDualQuat<Real = Self, Level = V, Array = [Self; 8]>;
    /// The lanes that hold half a record of eight.
    type Half<V: Level>: Lanes<Real = Self, Level = V, Array = [Self; 4]>;
    /// The nearest number of this type.
    fn from_f64(value: f64) -> Self;
    /// The nearest number of this type.
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
/// Products of such vectors serve where there is only one thing to compute at a time: a child waits
/// for its parent. Two rearrangements are all that they need in addition to [`Lanes`].
pub trait PackedDualQuat: Lanes {
    /// Four numbers in both halves.
    #[inline(always)]
    fn load_twice(level: Self::Level, from: &[Self::Real; 4]) -> Self {
        let mut twice = Self::Array::zeroed();
        for half in twice.as_mut().chunks_exact_mut(4) {
            half.copy_from_slice(from);
        }
        Self::load(level, &twice)
    }

    /// What the components x, y, z and w of another quaternion multiply, in both halves: with these
    /// four columns, p·b = c₀b_x + c₁b_y + c₂b_z + c₃b_w.
    ///
    /// ```text
    /// c₀ = (pw, pz, −py, −px)   c₁ = (−pz, pw, px, −py)   c₂ = (py, −px, pw, −pz)   c₃ = p
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

    /// εσ: the lower half in the upper one, and −0 below, for ε² = 0.
    ///
    /// A sum with −0 is the other number, of whichever sign; a sum of −0 and +0 would be +0.
    #[inline(always)]
    #[must_use]
    fn raised(self) -> Self {
        let mut raised = self.constant(-0.0).to_array();
        let half = self.to_array();
        for (slot, &value) in raised.as_mut().iter_mut().skip(4).zip(half.as_ref()) {
            *slot = value;
        }
        Self::load(self.level(), &raised)
    }
}
