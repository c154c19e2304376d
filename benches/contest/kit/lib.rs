//! What contests are made of: contenders, the memory of each, skeletons, and what the machine can
//! do at most.

#![allow(missing_docs, reason = "shared by programs, not published")]
#![allow(missing_debug_implementations, reason = "contests hold closures")]

pub mod caches;
pub mod contest;
pub mod limit;
pub mod memory;
pub mod scene;
pub mod skeleton;
pub mod walk;

use dq8::Backend;

/// Those that take part: all that this machine has, and, with the feature `reproducible`, the one
/// that does not fuse.
pub fn backends() -> impl Iterator<Item = Backend> {
    #[cfg(feature = "reproducible")]
    return Backend::available().chain([Backend::reproducible()]);
    #[cfg(not(feature = "reproducible"))]
    return Backend::available();
}
