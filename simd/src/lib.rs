//! Lanes for `dq8`.
//!
//! | module | contents |
//! |---|---|
//! | [`lanes`] | [`Lanes`] and [`Mask`]: the operations of a vector and of its comparisons |
//! | | [`Float`]: the element type of a lane, `f32` or `f64` |
//! | | [`Level`]: a set of instructions, and the proof that the CPU has them |
//! | [`records`] | [`Records`]: transposes between records in memory and vectors of components |
//! | [`mod@portable`] | [`Portable`]: the level of the instructions that the build target has |
//! | [`x86_64`] | `Avx2` and `Avx512`: the levels that are detected at run time |
//! | [`one`] | plain `f32` and `f64` as vectors of one lane |
//! | [`unfused`] | [`Unfused`]: a wrapper of any level, whose `mul_add` rounds twice |
//! | [`block`] | [`Block`]: a block of AoSoA memory, with one row per component |
//!
//! A kernel is one function, generic over [`Lanes`]. The kernel and every function that it calls
//! are marked `#[inline(always)]`. A function that is not inlined into [`Level::run`] is compiled
//! without the instructions of the level, and then each of its operations on lanes becomes a
//! function call.
//!
//! ```
//! use dq8_simd::{Lanes, Portable};
//! use wide::f32x8;
//!
//! fn length<L: Lanes>(x: L, y: L) -> L {
//!     x.mul_add(x, y * y).sqrt()
//! }
//! let three = f32x8::splat(3.0);
//! let four = <f32x8 as Lanes>::splat(Portable, 4.0);
//! assert_eq!(length(three, four).to_array(), [5.0; 8]);
//! ```
#![no_std]

#[cfg(feature = "alloc")]
extern crate alloc;

#[cfg(all(target_arch = "aarch64", target_feature = "neon", target_endian = "little"))]
mod aarch64;
pub mod block;
#[cfg(target_arch = "x86_64")]
mod detect;
mod index;
#[doc(hidden)]
pub mod internal;
pub mod lanes;
pub mod one;
#[cfg(target_arch = "x86_64")]
mod pair;
pub mod portable;
pub mod records;
#[cfg(not(dq8_record))]
mod sealed;
#[cfg(dq8_record)]
pub mod sealed;
mod shorts;
pub mod unfused;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod wasm32;
#[cfg(target_arch = "x86_64")]
pub mod x86_64;

pub use block::{Block, Native, Row};
pub use lanes::{Float, Lanes, Level, MAX_LANES, Mask, PackedDualQuat};
pub use portable::Portable;
pub use records::Records;
pub use unfused::Unfused;

/// The vectors of the crate `wide`, which are the lane types of [`Portable`].
pub use wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
