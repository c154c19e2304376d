//! Levels and lanes of x86-64 instructions that are detected at run time.
//!
//! Every value of a lane type holds a value of its level, which only detection makes. So whoever
//! has a vector has the proof that the CPU has the level's instructions, which makes the calls of
//! intrinsics sound.

// | file | contents |
// |---|---|
// | `vector.rs` | the macro that defines a lane type by its register and its instructions |
// | `frame.rs` | the alignment of the stack slots of spilled vector registers |
// | `prefetch.rs` | prefetches of memory |
// | `quads.rs` | transposes between records of four or three components and vectors |
// | `shorts.rs` | interpolation between records of four 16-bit integers |
// | `f32x4.rs` | records of two or three components, for the lanes of `Portable` |
// | `packed.rs` | one dual quaternion in a register |
// | `avx2.rs` | `Avx2`: 8 and 4 lanes of `f32`, 4 and 2 lanes of `f64` |
// | `avx512.rs` | `Avx512`: 16, 8 and 4 lanes of `f32`, 8, 4 and 2 lanes of `f64` |

mod avx2;
mod avx512;
#[cfg(target_feature = "sse2")]
pub(crate) mod f32x4;
mod frame;
mod packed;
mod prefetch;
mod quads;
mod shorts;
mod vector;

pub use avx2::Avx2;
pub use avx512::Avx512;
