//! What dq8-robot has of dq8 that is not for others: it may change in any version.

pub use crate::everyday::{Number, Quick};
#[cfg(feature = "rayon")]
pub use crate::threads::Outputs;
pub use crate::threads::{Choice, Rows, options};
