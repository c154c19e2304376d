//! Inverse kinematics of mechanisms: searches, and all solutions of arms of six hinges.

mod precision;
pub mod reach;
pub mod reach_report;
pub mod solutions;

pub use precision::Precision;

use dq8_python_arrays::{argument, broadcast, call, error, links, number, output, threads};
