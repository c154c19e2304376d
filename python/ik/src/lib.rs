//! Inverse kinematics of mechanisms: searches, clips that are tracked, and all solutions of arms of
//! six hinges.

pub mod goals;
mod precision;
pub mod reach;
pub mod reach_report;
pub mod search;
pub mod solutions;
pub mod track;

pub use precision::Precision;

use dq8_python_arrays::{argument, broadcast, call, error, links, number, output, threads};
