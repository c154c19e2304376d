//! Inverse kinematics of two bones: hip, knee and ankle to a point, by the triangle of the bones and the way to the
//! target. For robots and other chains of joints there is `Reach` of the crate `dq8-robot`.

mod error;
mod two_bone;

pub use error::LimbError;
pub use two_bone::{Span, TwoBone};
