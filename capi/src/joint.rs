//! [`Joint`]: the description of a joint in C.

use crate::status::Status;
use dq8::{DualQuat, Real};
use dq8_robot::MechanismError;

/// The motion of a joint, in its own frame.
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
    /// three values: x, y and the angle in radians. The directions of x and y are those of the
    /// joint's frame after the shortest rotation that takes z to `axis`.
    Planar = 4,
    /// The joint moves freely. It has seven values: a quaternion x y z w of any length but zero,
    /// and a translation x y z. It has six rates: the body twist, the angular part first.
    Floating = 5,
}

/// The joint between a link and its parent link. Joint j carries link j.
///
/// The fields `axis` and `pitch` are read only for the kinds that have them, and may be 0
/// otherwise.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint<R> {
    /// The number of the parent link, which must be less than that of this one, or -1 for the base.
    pub parent: i32,
    /// One of enum dq8_joint_kind.
    pub kind: i32,
    /// The pose of the link in its parent when the values of the joint are zero: a motion that is
    /// unit to 0.001.
    pub placement: [R; 8],
    /// The axis, or the normal of a planar joint. Its length must be 1 to 0.001.
    pub axis: [R; 3],
    /// The length that a screw slides per radian: the lead of its thread over 2 pi.
    pub pitch: R,
    /// 1 if the joint has no value of its own, but `multiplier` times the value of joint `leader`
    /// plus `offset`; otherwise 0. Both joints must be of kinds with one value, and the leader must
    /// have its own.
    pub mimics: i32,
    /// The joint whose value this joint takes.
    pub leader: i32,
    /// The factor of that value.
    pub multiplier: R,
    /// The number that is added to the product.
    pub offset: R,
    /// 1 if the joint has limits, otherwise 0. Only a joint of one value can have limits. Inverse
    /// kinematics keeps to them; all other functions ignore them.
    pub limited: i32,
    /// The smallest and the largest value. Either may be infinite.
    pub limits: [R; 2],
}

impl<R: Real> Joint<R> {
    /// The joint as the library has it, in a mechanism of `count` joints.
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

/// The reason why joints are no mechanism, and the joint that is wrong, if it is one.
pub(crate) type Fault = (Status, Option<usize>);

/// The library's error as a [`Fault`].
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
        // A newer dq8 may have more errors.
        _ => return (Status::UnknownValue, None),
    };
    (status, Some(joint))
}
