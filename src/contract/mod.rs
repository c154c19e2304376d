//! Contracts that the scalar reference and the lanes share. The contracts of motions, of rotations
//! and of dual numbers are traits, each written as one list of methods.

mod dual_number;
mod motion;
mod quaternion;
mod shared_trait;

pub use dual_number::DualNumber;
pub(crate) use dual_number::{delegate_dual_number, power};
pub use motion::Motion;
pub(crate) use motion::delegate_motion;
pub use quaternion::Quaternion;
pub(crate) use quaternion::delegate_quaternion;
pub(crate) use shared_trait::{sealed, shared_trait, sums_by_part};
