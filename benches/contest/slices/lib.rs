//! Contests over slices. A package of its own, so that they are compiled beside those down a
//! hierarchy: both have many kernels.

#![allow(missing_docs, reason = "shared by programs, not published")]
#![allow(missing_debug_implementations, reason = "contests hold closures")]

pub mod pairs;
pub mod points;

use dq8_contest_kit::{backends, caches, contest, limit, memory};
