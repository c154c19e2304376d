//! The reference: one motion at a time, textbook formulas with plain branches.
//!
//! Written by hand beside the papers and independent of [`batch`](crate::batch), which is tested
//! against it. The contract that both keep is [`Motion`](crate::Motion).

mod blend;
mod dual;
mod dual_quat;
mod matrix;
mod motion;
mod norm;
mod quat;
mod rigid;
mod screw;
mod transform;
mod vector;

pub use dual::Dual;
pub use dual_quat::DualQuat;
pub use quat::Quat;
