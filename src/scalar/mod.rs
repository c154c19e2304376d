//! The reference: one motion at a time, textbook formulas with plain branches.
//!
//! The formulas are written by hand from the papers and independent of [`batch`](crate::batch),
//! which is tested against them. Both implement the contract [`Motion`](crate::Motion).

pub(crate) mod blend;
mod contract;
mod derivative;
mod dual;
mod dual_quat;
mod error;
mod jacobian;
mod matrix;
mod metric;
pub(crate) mod must_be_unit;
mod norm;
mod quat;
mod rigid;
mod screw;
mod slerp;
mod transform;
pub(crate) mod two_bone;
pub mod vector;

pub use dual::Dual;
pub use dual_quat::DualQuat;
pub use error::{InverseError, MatrixError, NormalizeError};
pub use jacobian::lie_bracket;
pub use quat::Quat;
