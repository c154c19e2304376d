//! Contests of what a crowd needs for a frame. A package of its own, as the contests over slices are.

#![allow(missing_docs, reason = "shared by programs, not published")]
#![allow(missing_debug_implementations, reason = "contests hold closures")]

pub mod animation;
pub mod skin;

use dq8_contest_kit::{backends, contest, memory, scene, walk};
