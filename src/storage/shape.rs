//! [`ShapeError`]: slices that do not fit each other, and the checks that return it.

use core::fmt;
use core::ops::Range;

/// Slices that do not fit a hierarchy, or each other. Nothing has been written.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ShapeError {
    /// A slice does not hold a whole number of instances.
    NotWhole {
        /// The name of the slice.
        what: &'static str,
        /// Its length.
        length: usize,
        /// The joints of one instance.
        joints: usize,
    },
    /// A slice holds nothing where something is needed.
    Empty {
        /// The name of the slice.
        what: &'static str,
    },
    /// A slice has the wrong length.
    Length {
        /// The name of the slice.
        what: &'static str,
        /// Its length.
        length: usize,
        /// The length it must have.
        expected: usize,
    },
    /// A range of joints that is not a range of this hierarchy.
    Joints {
        /// The range.
        range: Range<usize>,
        /// The number of joints.
        joints: usize,
    },
    /// A joint of a range, whose parent is not in it: models that go through scratch are not kept for it.
    NoParent {
        /// The joint.
        joint: usize,
        /// Its parent.
        parent: usize,
    },
    /// A pair of an order that is not a joint and its parent, or comes before the last root: the order was made for
    /// other parents, or not at all.
    NotOrder {
        /// The number of the pair.
        place: usize,
    },
    /// A job was given the plan of other parents than its own.
    OtherPlan,
    /// A link that a robot (crate `dq8-robot`) does not have.
    NoLink {
        /// The link asked for.
        link: usize,
        /// The number of links.
        links: usize,
    },
    /// A pose that a crowd does not have.
    NoPose {
        /// The instance asked for.
        instance: usize,
        /// The joint asked for.
        joint: usize,
        /// The number of instances.
        instances: usize,
        /// The number of joints.
        joints: usize,
    },
    /// A frame that a clip does not have, or that no frame follows.
    NoFrame {
        /// The instance that is to be there.
        instance: usize,
        /// The frame asked for.
        frame: usize,
        /// The number of frames.
        frames: usize,
    },
    /// A place that packed clips do not have: it was made of others.
    NoPlace {
        /// The instance that is to be there.
        instance: usize,
    },
}

impl fmt::Display for ShapeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotWhole { what, length, joints } => write!(
                f,
                "{what} holds {length} elements, which is not a multiple of the {joints} joints"
            ),
            Self::Empty { what } => write!(f, "{what} holds no element"),
            Self::Length { what, length, expected } => {
                write!(f, "{what} holds {length} elements where {expected} are needed")
            }
            Self::Joints { range, joints } => write!(
                f,
                "joints {}..{} are not a range of a hierarchy of {joints} joints",
                range.start, range.end
            ),
            Self::NoParent { joint, parent } => write!(
                f,
                "the parent of joint {joint}, joint {parent}, is not among those that are computed"
            ),
            Self::NotOrder { place } => {
                write!(f, "pair {place} of the order is not one of these parents")
            }
            Self::OtherPlan => f.write_str("the plan is of other parents than the job"),
            Self::NoLink { link, links } => {
                write!(f, "there is no link {link}: the mechanism has {links}, counted from 0")
            }
            Self::NoPose { instance, joint, instances, joints } => write!(
                f,
                "no joint {joint} of instance {instance} among {instances} instances of {joints} joints"
            ),
            Self::NoFrame { instance, frame, frames } => write!(
                f,
                "instance {instance} lies after frame {frame}, and none follows it among {frames} frames"
            ),
            Self::NoPlace { instance } => {
                write!(f, "instance {instance} lies at a place of other clips than these")
            }
        }
    }
}

impl core::error::Error for ShapeError {}

/// Checks that the slice that is called `what` holds as many elements as it must.
///
/// # Errors
/// If it does not.
#[inline]
pub fn same_length(what: &'static str, length: usize, expected: usize) -> Result<(), ShapeError> {
    if length == expected { Ok(()) } else { Err(ShapeError::Length { what, length, expected }) }
}

/// The number of instances of `joints` joints (links, values …) in the slice that is called `what`.
///
/// # Errors
/// If it holds no whole number of them.
#[inline]
pub fn whole_instances(
    what: &'static str,
    joints: usize,
    length: usize,
) -> Result<usize, ShapeError> {
    // Divisions are slow, and most callers have one instance.
    if length == joints && length > 0 {
        return Ok(1);
    }
    match length.checked_rem(joints) {
        Some(0) => Ok(length / joints),
        None if length == 0 => Ok(0),
        _ => Err(ShapeError::NotWhole { what, length, joints }),
    }
}

/// Checks that these are joints of a hierarchy.
pub(crate) fn joints_within(range: &Range<usize>, joints: usize) -> Result<(), ShapeError> {
    if range.start <= range.end && range.end <= joints {
        return Ok(());
    }
    Err(ShapeError::Joints { range: range.clone(), joints })
}
