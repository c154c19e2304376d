//! Mechanisms: poses, Jacobians and velocities of links, and inverse kinematics.

mod configurations;
mod floating;
mod joints;
pub mod mechanism;
pub mod rates;
pub mod solutions;
pub mod track;
pub mod urdf;

use dq8_python_arrays::{
    argument, broadcast, call, columns, error, links, number, output, shape, threads,
};
