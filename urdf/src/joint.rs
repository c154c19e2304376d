//! One `<joint>`.

use crate::error::UrdfError;
use crate::file::{JointElement, Kind};
use dq8::mechanism::{Joint, JointKind, Mimic};
use dq8::{DualQuat, Quat};
use std::collections::HashMap;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// The joint of a mechanism, but for what it mimics.
pub(crate) fn joint(from: &JointElement, parent: usize) -> Result<Joint<f64>, UrdfError> {
    let kind = match from.kind {
        Kind::Fixed => JointKind::Fixed,
        Kind::Revolute | Kind::Continuous => JointKind::Revolute { axis: axis(from)? },
        Kind::Prismatic => JointKind::Prismatic { axis: axis(from)? },
        Kind::Planar => JointKind::Planar { normal: axis(from)? },
        Kind::Floating => JointKind::Floating,
    };
    let joint = Joint::new(Some(parent), placement(from), kind);
    Ok(Joint { limits: from.limits, ..joint })
}

/// Roll about x, then pitch about y, then yaw about z, all of them fixed axes.
fn placement(from: &JointElement) -> DualQuat<f64> {
    let [roll, pitch, yaw] = from.rpy;
    let turn = Quat::from_axis_angle(Z, yaw)
        * Quat::from_axis_angle(Y, pitch)
        * Quat::from_axis_angle(X, roll);
    DualQuat::from_rotation_translation(turn, from.xyz)
}

/// Files have axes of any length.
fn axis(joint: &JointElement) -> Result<[f64; 3], UrdfError> {
    let axis = joint.axis;
    let [x, y, z] = axis;
    let length = x.hypot(y).hypot(z);
    if length > 0.0 && length.is_finite() {
        return Ok(axis.map(|number| number / length));
    }
    Err(UrdfError::Axis { joint: joint.name.clone(), axis })
}

/// What a joint mimics in the end: files have joints that mimic joints that mimic.
pub(crate) fn mimic(
    joint: &JointElement,
    by_name: &HashMap<&str, &JointElement>,
    links: &HashMap<&str, usize>,
) -> Result<Option<Mimic<f64>>, UrdfError> {
    let Some(mut next) = joint.mimic.as_ref() else { return Ok(None) };
    let error = || UrdfError::Mimic {
        joint: joint.name.clone(),
        other: joint.mimic.as_ref().map(|mimic| mimic.joint.clone()).unwrap_or_default(),
    };
    let (mut multiplier, mut offset) = (1.0, 0.0);
    // Longer than there are joints is a circle.
    for _ in 0..by_name.len() {
        let Some(other) = by_name.get(next.joint.as_str()) else {
            let (joint, name) = (joint.name.clone(), next.joint.clone());
            return Err(UrdfError::Unknown { joint, element: "mimic joint", name });
        };
        offset += multiplier * next.offset;
        multiplier *= next.multiplier;
        match other.mimic.as_ref() {
            Some(further) => next = further,
            None => {
                let link = links.get(other.child.as_str()).copied().ok_or_else(error)?;
                return Ok(Some(Mimic { joint: link, multiplier, offset }));
            }
        }
    }
    Err(error())
}
