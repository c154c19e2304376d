//! [`Level`]: the proof that the CPU can compute with a lane type.

use crate::lane::Lanes;
use crate::octet::Octet;
use core::fmt::Debug;

/// A set of instructions, held as a value that proves the CPU has them.
///
/// [`Portable`](crate::Portable) is free to construct, because its lanes use what the build target
/// already promises. A level whose instructions are found at run time has a private field, so that
/// only detection can hand it out; whoever holds one of its lanes therefore holds the proof too.
pub trait Level: Copy + Debug + Send + Sync + 'static {
    /// Four lanes of `f32`.
    type F32x4: Lanes<Real = f32, Level = Self, Array = [f32; 4]>;
    /// Eight lanes of `f32`.
    type F32x8: Octet<Real = f32, Level = Self, Array = [f32; 8]>;
    /// Sixteen lanes of `f32`.
    type F32x16: Lanes<Real = f32, Level = Self, Array = [f32; 16]>;
    /// Two lanes of `f64`.
    type F64x2: Lanes<Real = f64, Level = Self, Array = [f64; 2]>;
    /// Four lanes of `f64`.
    type F64x4: Lanes<Real = f64, Level = Self, Array = [f64; 4]>;
    /// Eight lanes of `f64`.
    type F64x8: Octet<Real = f64, Level = Self, Array = [f64; 8]>;

    /// The `f32` lanes that fill a register.
    type Single: Lanes<Real = f32, Level = Self>;
    /// The `f64` lanes that fill a register.
    type Double: Lanes<Real = f64, Level = Self>;

    /// Waits until what was stored past the caches is where other instructions see it.
    #[inline(always)]
    fn fence(self) {}

    /// Asks for the cache lines of `value`, which will be read or written soon. For what is read one after
    /// the other over more memory than the first cache holds: the CPU guesses that too, but later.
    #[inline(always)]
    fn prefetch<T>(self, value: &T) {
        let _ = value;
    }

    /// `value`, whose address is in a register of its own. For values of which single numbers are
    /// multiplied into every lane: AVX-512 loads, multiplies and adds in one step from such an address,
    /// and in two from a sum of registers, which a compiler would take to save an instruction.
    #[inline(always)]
    fn locate<T>(self, value: &T) -> &T {
        value
    }

    /// Runs `kernel` compiled with the instructions of this level.
    ///
    /// Everything that `kernel` calls must be `#[inline(always)]`, or it is compiled without them.
    fn run<R>(self, kernel: impl FnOnce() -> R) -> R;
}
