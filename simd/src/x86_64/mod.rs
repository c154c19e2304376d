//! Lanes for x86-64 instructions that are found at run time.
//!
//! | file | what it holds |
//! |---|---|
//! | `vector.rs` | the short macro that makes a lane type of a register and its instructions |
//! | `frame.rs` | where vector registers are spilled to |
//! | `prefetch.rs` | memory that will be needed soon |
//! | `quads.rs` | transposes between records of four or three numbers and vectors of components |
//! | `shorts.rs` | what lies between records of four short numbers |
//! | `packed.rs` | one dual quaternion in a register |
//! | `avx2.rs` | [`Avx2`]: 8 × `f32`, 4 × `f64`, and half as many; AVX2 and FMA |
//! | `avx512.rs` | [`Avx512`]: 16 × `f32`, 8 × `f64`, and the narrower ones; AVX-512 F, VL, DQ |
//!
//! Every lane value holds the proof of its level: the constructors ask for it. That is what makes
//! the calls of intrinsics sound, and each `SAFETY` comment here refers to it.

mod avx2;
mod avx512;
mod frame;
mod packed;
mod prefetch;
mod quads;
mod shorts;
mod vector;

pub use avx2::Avx2;
pub use avx512::Avx512;
