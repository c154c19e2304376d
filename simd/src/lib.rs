//! Lanes for `dq8`.
//!
//! | module | what it holds |
//! |---|---|
//! | [`lanes`] | [`Lanes`] and [`Mask`], what a kernel may ask of a vector of numbers; [`Float`], the number in a lane; [`Level`], the proof that the CPU can compute with it |
//! | [`records`] | [`Records`]: transposes between vectors and records of numbers |
//! | [`mod@portable`] | [`Portable`]: the lanes of the crate `wide`, with the instructions of the build target |
//! | [`one`] | plain `f32` and `f64` as vectors of one lane |
//! | [`unfused`] | [`Unfused`]: the lanes of another level, whose `mul_add` rounds twice |
//! | [`block`] | [`Block`]: structure-of-arrays memory, a row of numbers for each component |
//!
//! Kernels are written once, generic over [`Lanes`], and marked `#[inline(always)]`: a kernel that
//! is not inlined into its [`Level::run`] pays a call for every instruction.
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
