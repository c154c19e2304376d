//! One `<joint>`.

use crate::file::{JointElement, Kind};
use dq8::mechanism::{Joint, JointKind};
use dq8::{DualQuat, Quat};

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

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

/// Roll about x, then pitch about y, then yaw about z, all of them fixed axes.
fn placement(from: &JointElement) -> DualQuat<f64> {
    let [roll, pitch, yaw] = from.rpy;
    let turn = Quat::from_axis_angle(Z, yaw)
        * Quat::from_axis_angle(Y, pitch)
        * Quat::from_axis_angle(X, roll);
    DualQuat::from_rotation_translation(turn, from.xyz)
}
