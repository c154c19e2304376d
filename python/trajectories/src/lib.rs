//! Poses at times: trajectories, clouds of points that are each moved by the pose at their own
//! time, splines, comparisons; and the fits by which trajectories are laid over each other.

pub mod compare;
pub mod fit;
pub mod hand_eye;
mod options;
mod pieces;
pub mod resample;
mod robust;
pub mod spline;
pub mod trajectory;

use dq8_python_arrays::{argument, axis, call, error, number, output, shape, threads};
