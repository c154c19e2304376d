//! Poses at times.

pub mod resample;

use dq8_python_arrays::{argument, axis, call, error, number, output, shape, threads};
