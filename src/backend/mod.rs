//! Which instructions compute, and on how many threads.

mod dispatch;
mod threads;

pub use dispatch::{Backend, Kernel, UnavailableBackend};
#[cfg(not(feature = "rayon"))]
pub(crate) use threads::Outputs;
#[cfg(feature = "rayon")]
pub use threads::Outputs;
pub use threads::{Choice, Rows, options};
