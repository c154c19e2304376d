//! [`Joint`]: a joint as C describes it.

use crate::status::Status;
use dq8::{DualQuat, Real};
use dq8_robot::MechanismError;

/// How a joint moves, in its own frame.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointKind {
    /// Not at all. No value.
    Fixed = 0,
    /// Turns about `axis`. One value, radians.
    Revolute = 1,
    /// Slides along `axis`. One value, a length.
    Prismatic = 2,
    /// Turns about `axis` and slides along it, `pitch` for each radian. One value, radians.
    Screw = 3,
    /// Slides in the plane across `axis`, then turns about it. Three values: x, y and the angle.
    /// The axes of x and y are those of the joint's frame after the shortest rotation that takes z
    /// to `axis`.
    Planar = 4,
    /// Moves freely. Seven values: a quaternion x y z w of any length but zero, and a translation.
    /// Six rates: the body twist, angular first.
    Floating = 5,
}

/// How a link is joined to the one that carries it. Link j is what joint j carries.
///
/// Fields that its kind does not name are not read; all may be 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint<R> {
    /// The joint of the link that carries this one, which comes before it, or -1 for the base.
    pub parent: i32,
    /// One of enum dq8_joint_kind.
    pub kind: i32,
    /// The pose of the link in that of its parent where the joint is at zero: a motion, unit to
    /// 0.001.
    pub placement: [R; 8],
    /// The axis or, of a planar joint, the normal; of length 1 to 0.001.
    pub axis: [R; 3],
    /// Of a screw, length for each radian: the lead of a thread over 2 pi.
    pub pitch: R,
    /// 1 if the joint has no value of its own but `multiplier` times that of joint `leader`, plus
    /// `offset`; else 0. Both must be of one value, and the leader have its own.
    pub mimics: i32,
    /// The joint whose value it takes.
    pub leader: i32,
    /// What that value is multiplied by.
    pub multiplier: R,
    /// What is added.
    pub offset: R,
    /// 1 if the joint, which must be of one value, has limits; else 0. Inverse kinematics keeps to
    /// them, nothing else does.
    pub limited: i32,
    /// The least and the largest value; infinite where there is no end.
    pub limits: [R; 2],
}

impl<R: Real> Joint<R> {
    /// A joint as the library has it, one of `count`.
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

/// What is wrong, and with which joint.
pub(crate) type Fault = (Status, Option<usize>);

/// What the library says of joints, as C is told.
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
        // What only a newer dq8 knows.
        _ => return (Status::UnknownValue, None),
    };
    (status, Some(joint))
}
