//! Inverse kinematics of two bones: hip, knee and ankle to a point, by the triangle of the bones
//! and the way to the target. For robots and other chains of joints there is `Reach` of the crate
//! `dq8-robot`.

mod error;
mod limb;

pub use crate::scalar::two_bone::{LimbError, Span, TwoBone};
pub use error::LimbsError;
pub use limb::Limb;
pub(crate) use limb::{Asked, fault};
