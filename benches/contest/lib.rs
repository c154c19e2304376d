//! Jobs, their data, and everyone who does them, for the example `compare`.
//!
//! A [`Task`](task::Task) makes the data of a [`Contest`](contest::Contest), whose contenders can be
//! checked against `f64` and timed, by whoever holds it. [`memory`] is how each contender keeps motions
//! and points, [`limit`] is what the machine can do at most.

#![allow(missing_docs, reason = "of one program, not published")]
#![allow(missing_debug_implementations, reason = "contests hold closures")]

pub mod caches;
pub mod contest;
pub mod limit;
pub mod memory;
pub mod scene;
pub mod skeleton;
pub mod task;
mod walk;

use dq8::Backend;

/// Those that take part: all that this machine has, and, with the feature `reproducible`, the one that does not fuse.
pub fn backends() -> impl Iterator<Item = Backend> {
    #[cfg(feature = "reproducible")]
    return Backend::available().chain([Backend::reproducible()]);
    #[cfg(not(feature = "reproducible"))]
    return Backend::available();
}
