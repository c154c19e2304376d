//! Lanes for x86-64 instructions that are detected at run time.
//!
//! Every value of a lane type holds the proof of its level, because its constructors ask for one.
//! This is what makes calls of intrinsics sound, and what the `SAFETY` comments here mean by
//! "proves the instructions".

// | file | contents |
// |---|---|
// | `vector.rs` | the macro that makes a lane type of a register and its instructions |
// | `frame.rs` | the place of spilled vector registers |
// | `prefetch.rs` | prefetches of memory |
// | `quads.rs` | transposes between records of four or three numbers and vectors |
// | `shorts.rs` | interpolation between records of four 16-bit numbers |
// | `packed.rs` | one dual quaternion in a register |
// | `avx2.rs` | `Avx2`: 8 × `f32`, 4 × `f64`, and half as many |
// | `avx512.rs` | `Avx512`: 16 × `f32`, 8 × `f64`, and the narrower ones |

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
