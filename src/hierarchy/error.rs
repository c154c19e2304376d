//! [`HierarchyError`]: parents that are not a hierarchy.

use core::fmt;

/// A parent array that is not a hierarchy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum HierarchyError {
    /// A joint's parent does not come before it: a forward reference, or a cycle.
    ParentNotBefore {
        /// The joint.
        joint: usize,
        /// Its parent.
        parent: u32,
    },
    /// A joint's parent is not a joint at all.
    ParentOutOfRange {
        /// The joint.
        joint: usize,
        /// Its parent, as it was written: a number of any type.
        parent: i128,
        /// The number of joints.
        joints: usize,
    },
    /// A joint is its own ancestor.
    Cycle {
        /// The joint.
        joint: usize,
    },
    /// A joint that there is not.
    NoJoint {
        /// The joint asked for.
        joint: usize,
        /// The number of joints.
        joints: usize,
    },
    /// The joints below a joint do not lie in one range.
    Scattered {
        /// The joint.
        joint: usize,
        /// The first joint below it that comes after one that is not.
        beyond: usize,
    },
    /// Not as many names as joints.
    Names {
        /// The number of names.
        names: usize,
        /// The number of joints.
        joints: usize,
    },
    /// A joint has the name of an earlier one.
    SameName {
        /// The joint.
        joint: usize,
        /// The earlier one.
        earlier: usize,
    },
    /// More joints than a `u32` can number.
    TooManyJoints {
        /// The number of joints.
        joints: usize,
    },
}

impl fmt::Display for HierarchyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ParentNotBefore { joint, parent } if *joint == *parent as usize => {
                write!(f, "joint {joint} is its own parent")
            }
            Self::ParentNotBefore { joint, parent } => write!(
                f,
                "joint {joint} has parent {parent}, which must come before it (sort parents first; \
                 a cycle cannot be sorted)"
            ),
            Self::ParentOutOfRange { joint, parent, joints } => {
                write!(f, "joint {joint} has parent {parent}")?;
                // Negative numbers that came as a `u32`.
                if let Ok(signed @ ..0) = u32::try_from(*parent).map(u32::cast_signed) {
                    write!(f, " ({signed} as a signed number)")?;
                }
                write!(f, ", but there are only {joints} joints, counted from 0, and −1 is none")
            }
            Self::Cycle { joint } => write!(f, "joint {joint} is its own ancestor"),
            Self::NoJoint { joint, joints } => {
                write!(f, "there is no joint {joint} among {joints}, counted from 0")
            }
            Self::Scattered { joint, beyond } => write!(
                f,
                "the joints below joint {joint} are no range: joint {beyond} is one of them, and comes after others \
                 (`Skeleton::sorted` numbers subtrees in one range)"
            ),
            Self::Names { names, joints } => {
                write!(f, "{names} names are not one for each of {joints} joints")
            }
            Self::SameName { joint, earlier } => {
                write!(f, "joint {joint} has the name of joint {earlier}")
            }
            Self::TooManyJoints { joints } => {
                write!(f, "{joints} joints are more than a u32 can number")
            }
        }
    }
}

impl core::error::Error for HierarchyError {}
