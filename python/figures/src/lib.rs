//! What has joints and is no robot: skeletons, the meshes that follow them, and their clips.

pub mod hierarchy;
mod method;
pub mod packed_clip;
mod palette;
pub mod skin;

use dq8_python_arrays::{
    argument, broadcast, call, error, links, number, output, plain, shape, threads,
};
