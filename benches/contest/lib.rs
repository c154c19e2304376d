//! Jobs, their data, and everyone who does them: what the criterion benches and the example
//! `compare` share.
//!
//! A [`Task`](task::Task) makes the data of a [`Contest`](contest::Contest), whose contenders can
//! be checked against `f64` and timed, by whoever holds it. [`memory`] is how each contender keeps
//! motions and points, [`limit`] is what the machine can do at most.
//!
//! Contests are in three packages, and what they are made of in a fourth, so that two cores compile
//! them.

#![allow(missing_docs, reason = "shared by programs, not published")]
#![allow(missing_debug_implementations, reason = "contests hold closures")]

pub mod task;

pub use dq8_contest_kit::{backends, caches, contest, limit, memory, scene, skeleton, walk};
