//! One `<joint>`.

use super::file::{JointElement, Kind};
use crate::{Joint, JointKind};
use dq8::{DualQuat, Quat};

/// The joint of a mechanism, but for what it mimics.
pub(crate) fn joint(from: &JointElement, parent: usize) -> Joint<f64> {
    let axis = from.axis;
    let kind = match from.kind {
        Kind::Fixed => JointKind::Fixed,
        Kind::Revolute | Kind::Continuous => JointKind::Revolute { axis },
        Kind::Prismatic => JointKind::Prismatic { axis },
        Kind::Planar => JointKind::Planar { normal: axis },
        Kind::Floating => JointKind::Floating,
    };
    let joint = Joint::new(Some(parent), placement(from), kind);
    Joint { limits: from.limits, ..joint }
}

fn placement(from: &JointElement) -> DualQuat<f64> {
    let [roll, pitch, yaw] = from.rpy;
    DualQuat::from_rotation_translation(Quat::from_rpy(roll, pitch, yaw), from.xyz)
}
