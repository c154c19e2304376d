//! Which instructions compute, and on how many threads.

mod dispatch;
mod threads;

pub use dispatch::{Backend, Kernel, UnavailableBackend};
pub use threads::{Choice, Outputs, Rows, options};
