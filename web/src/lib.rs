//! What JavaScript calls: functions on numbers, which are places and lengths in this module's own
//! memory. `package/` is the only caller; it hands out no place, and so no page can pass a wrong
//! one.
//!
//! A function returns 0, or another number when it failed, and then [`error::dq8_error`] is the
//! text of the error. The C interface is no border for this: it tells errors by numbers alone, has
//! no clips, and leaves the memory of skins and robots to callers, who could write there what has
//! been checked.

#[cfg(feature = "skeletons")]
mod clip;
#[cfg(feature = "skeletons")]
mod crowd;
#[cfg(any(feature = "skeletons", feature = "robots"))]
mod error;
#[cfg(feature = "skeletons")]
mod limb;
#[cfg(feature = "skeletons")]
mod linear;
mod memory;
#[cfg(feature = "skeletons")]
mod motions;
#[cfg(feature = "pack")]
mod pack;
mod pool;
#[cfg(feature = "robots")]
mod robots;
#[cfg(feature = "skeletons")]
mod skeleton;
#[cfg(feature = "skeletons")]
mod skin;

/// A motion, eight numbers.
#[cfg(any(feature = "skeletons", feature = "robots"))]
type Motion = dq8::DualQuat<f32>;

/// A 4×4 matrix, column after column: what WebGL, WebGPU and three.js read.
#[cfg(feature = "skeletons")]
type Columns = [[f32; 4]; 4];
