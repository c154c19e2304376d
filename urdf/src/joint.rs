//! One `<joint>`.

use crate::error::UrdfError;
use dq8::mechanism::{Joint, JointKind, Mimic};
use dq8::{DualQuat, Quat};
use std::collections::HashMap;
use urdf_rs::JointType;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// The joint of a mechanism, but for what it mimics.
pub(crate) fn joint(from: &urdf_rs::Joint, parent: usize) -> Result<Joint<f64>, UrdfError> {
    let kind = match from.joint_type {
        JointType::Fixed => JointKind::Fixed,
        JointType::Revolute | JointType::Continuous => JointKind::Revolute { axis: axis(from)? },
        JointType::Prismatic => JointKind::Prismatic { axis: axis(from)? },
        JointType::Planar => JointKind::Planar { normal: axis(from)? },
        JointType::Floating => JointKind::Floating,
        JointType::Spherical => {
            let what = format!("<joint name={:?} type=\"spherical\">", from.name);
            return Err(UrdfError::NotExpressed { what });
        }
    };
    let mut joint = Joint::new(Some(parent), placement(&from.origin), kind);
    let limits = [from.limit.lower, from.limit.upper];
    let limited = matches!(from.joint_type, JointType::Revolute | JointType::Prismatic);
    // What is left out is zero: a joint with no room at all says nothing about its limits.
    if limited && limits != [0.0, 0.0] {
        joint = joint.with_limits(limits);
    }
    Ok(joint)
}

/// Roll about x, then pitch about y, then yaw about z, all of them fixed axes.
fn placement(origin: &urdf_rs::Pose) -> DualQuat<f64> {
    let [roll, pitch, yaw] = origin.rpy.0;
    let turn = Quat::from_axis_angle(Z, yaw)
        * Quat::from_axis_angle(Y, pitch)
        * Quat::from_axis_angle(X, roll);
    DualQuat::from_rotation_translation(turn, origin.xyz.0)
}

/// Files have axes of any length.
fn axis(joint: &urdf_rs::Joint) -> Result<[f64; 3], UrdfError> {
    let axis = joint.axis.xyz.0;
    let [x, y, z] = axis;
    let length = x.hypot(y).hypot(z);
    if length > 0.0 && length.is_finite() {
        return Ok(axis.map(|number| number / length));
    }
    Err(UrdfError::Axis { joint: joint.name.clone(), axis })
}

/// What a joint mimics in the end: files have joints that mimic joints that mimic.
pub(crate) fn mimic(
    joint: &urdf_rs::Joint,
    by_name: &HashMap<&str, &urdf_rs::Joint>,
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
        offset += multiplier * next.offset.unwrap_or(0.0);
        multiplier *= next.multiplier.unwrap_or(1.0);
        match other.mimic.as_ref() {
            Some(further) => next = further,
            None => {
                let link = links.get(other.child.link.as_str()).copied().ok_or_else(error)?;
                return Ok(Some(Mimic { joint: link, multiplier, offset }));
            }
        }
    }
    Err(error())
}
