//! The contest of what a crowd needs for a frame: most of what there is to compile, so in a package
//! of its own.

#![allow(missing_docs, reason = "shared by programs, not published")]
#![allow(missing_debug_implementations, reason = "contests hold closures")]

pub mod animation;

use dq8_contest_kit::{backends, contest, memory, scene, walk};
