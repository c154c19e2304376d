//! [`Joint`]: the description of a joint in C.

use crate::status::Status;
use dq8::{DualQuat, Real};
use dq8_robot::MechanismError;

/// The kind of a joint: the motion that it makes in its own frame.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointKind {
    /// The joint does not move. It has no value.
    Fixed = 0,
    /// The joint turns about `axis`. It has one value, in radians.
    Revolute = 1,
    /// The joint slides along `axis`. It has one value, a length.
    Prismatic = 2,
    /// The joint turns about `axis`, and slides along it by `pitch` for each radian. It has one
    /// value, in radians.
    Screw = 3,
    /// The joint slides in the plane at right angles to `axis`, then turns about `axis`. It has
    /// three values: x, y and the angle in radians. The directions of x and y are the x and y axes
    /// of the joint's frame after the shortest rotation that takes its z axis to `axis`.
    Planar = 4,
    /// The joint moves freely. It has seven values: a quaternion x y z w of any length but zero,
    /// then a translation x y z. It has six rates, the body twist: angular x y z, then linear x y
    /// z.
    Floating = 5,
}

/// The joint between a link and its parent link. The joint with index j carries the link with index
/// j.
///
/// The fields `axis` and `pitch` are read only for kinds of joints that have an axis or a pitch.
/// For other kinds they may be 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint<R> {
    /// The index of the parent link, which must be less than the index of this link, or -1 for the
    /// base.
    pub parent: i32,
    /// The kind, one of enum dq8_joint_kind.
    pub kind: i32,
    /// The pose of the link in its parent link when the values of the joint are zero. It must be a
    /// motion that is unit within 0.001.
    pub placement: [R; 8],
    /// The axis of the joint, or the normal of a planar joint. Its length must be 1 within 0.001.
    pub axis: [R; 3],
    /// The length that a screw slides per radian: the lead of its thread over 2 pi.
    pub pitch: R,
    /// 1 if the joint has no value of its own and mimics joint `leader`: it moves as if its value
    /// were `multiplier` times the value of the leader plus `offset`. Otherwise 0. Both joints must
    /// be of kinds with one value, and the leader must not mimic another joint.
    pub mimics: i32,
    /// The index of the joint whose value this joint takes, if `mimics` is 1.
    pub leader: i32,
    /// The factor of the leader's value, if `mimics` is 1.
    pub multiplier: R,
    /// The value that is added to the product, if `mimics` is 1.
    pub offset: R,
    /// 1 if the joint has limits, otherwise 0. Only a joint with one value can have limits. Inverse
    /// kinematics keeps to the limits, and all other functions ignore them.
    pub limited: i32,
    /// The smallest and the largest value of the joint, if `limited` is 1. Either may be infinite.
    pub limits: [R; 2],
}

impl<R: Real> Joint<R> {
    /// Converts the joint to the type of `dq8_robot`, for a mechanism of `count` joints.
    pub(crate) fn known(&self, count: usize) -> Result<dq8_robot::Joint<R>, Status> {
        const KINDS: [JointKind; 6] = [
            JointKind::Fixed,
            JointKind::Revolute,
            JointKind::Prismatic,
            JointKind::Screw,
            JointKind::Planar,
            JointKind::Floating,
        ];
        let parent = match (self.parent, usize::try_from(self.parent)) {
            (-1, _) => None,
            (_, Ok(parent)) if parent < count => Some(parent),
            _ => return Err(Status::ParentOutOfRange),
        };
        let (axis, pitch) = (self.axis, self.pitch);
        let kind = KINDS.into_iter().find(|kind| *kind as i32 == self.kind);
        let kind = match kind.ok_or(Status::UnknownValue)? {
            JointKind::Fixed => dq8_robot::JointKind::Fixed,
            JointKind::Revolute => dq8_robot::JointKind::Revolute { axis },
            JointKind::Prismatic => dq8_robot::JointKind::Prismatic { axis },
            JointKind::Screw => dq8_robot::JointKind::Screw { axis, pitch },
            JointKind::Planar => dq8_robot::JointKind::Planar { normal: axis },
            JointKind::Floating => dq8_robot::JointKind::Floating,
        };
        let mut known = dq8_robot::Joint::new(parent, DualQuat::from_array(self.placement), kind);
        known.limits = match self.limited {
            0 => None,
            1 => Some(self.limits),
            _ => return Err(Status::UnknownValue),
        };
        match self.mimics {
            0 => Ok(known),
            1 => {
                let leader = usize::try_from(self.leader).or(Err(Status::Mimic))?;
                Ok(known.mimicking(leader, self.multiplier, self.offset))
            }
            _ => Err(Status::UnknownValue),
        }
    }
}

/// The status for joints that form no mechanism, and the index of the wrong joint if a single joint
/// is wrong.
pub(crate) type Fault = (Status, Option<usize>);

/// Converts the error of `dq8_robot` to a [`Fault`].
pub(crate) fn fault(error: &MechanismError) -> Fault {
    let (status, joint) = match *error {
        MechanismError::Parent { joint, .. } => (Status::ParentNotBefore, joint),
        MechanismError::Placement { joint, .. } | MechanismError::DualPart { joint, .. } => {
            (Status::NotUnit, joint)
        }
        MechanismError::NotFinite { joint, .. } => (Status::NotFinite, joint),
        MechanismError::Axis { joint, .. } => (Status::Axis, joint),
        MechanismError::Mimic { joint, .. } => (Status::Mimic, joint),
        MechanismError::Steps { .. } => return (Status::TooManyJoints, None),
        MechanismError::Limits { joint, .. } => (Status::Limits, joint),
        // The enum is `non_exhaustive`: a newer `dq8_robot` may have more errors.
        _ => return (Status::UnknownValue, None),
    };
    (status, Some(joint))
}
