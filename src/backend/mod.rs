//! The choice of instructions and threads.

mod dispatch;
mod threads;

pub use dispatch::{Backend, Kernel, UnavailableBackend};
pub use threads::{Choice, Outputs, Rows, options};
