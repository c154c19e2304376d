//! Lanes for `dq8`.
//!
//! | module | contents |
//! |---|---|
//! | [`lanes`] | [`Lanes`] and [`Mask`]: the operations of a vector of numbers |
//! | | [`Float`]: the number in a lane |
//! | | [`Level`]: a set of instructions, and the proof that the CPU has them |
//! | [`records`] | [`Records`]: transposes between vectors and records of numbers |
//! | [`mod@portable`] | [`Portable`]: the instructions that the build target has |
//! | [`x86_64`] | `Avx2` and `Avx512`: instructions that are detected at run time |
//! | [`one`] | plain `f32` and `f64` as vectors of one lane |
//! | [`unfused`] | [`Unfused`]: another level, whose `mul_add` rounds twice |
//! | [`block`] | [`Block`]: structure-of-arrays memory, one row of numbers per component |
//!
//! A kernel is one function, generic over [`Lanes`]. It is marked `#[inline(always)]`, as is
//! everything that it calls: a function that is not inlined into [`Level::run`] is compiled without
//! the instructions of the level, and then every operation on lanes is a function call.
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
#[cfg(target_arch = "x86_64")]
pub mod x86_64;

pub use block::{Block, Native, Row};
pub use lanes::{Float, Lanes, Level, MAX_LANES, Mask, PackedDualQuat};
pub use portable::Portable;
pub use records::Records;
pub use unfused::Unfused;

/// The portable lane types themselves.
pub use wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
