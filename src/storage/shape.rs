//! [`ShapeError`], the error of slices that do not fit each other, and the checks that return it.

use crate::macros::{Count, errors};
use core::ops::Range;

errors! {
    /// The error of slices that do not fit a hierarchy or each other. No output has been written.
    #[derive(Clone, Debug, PartialEq, Eq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    ShapeError {
        /// A slice does not hold a whole number of instances.
        NotWhole {
            /// The name of the slice.
            what: &'static str,
            /// The length of the slice.
            length: usize,
            /// The number of joints of one instance.
            joints: usize,
        } => "{what} holds {}, which is not a multiple of the {}", Count(*length, "element"), Count(*joints, "joint");
        /// A slice is empty, although it needs at least one element.
        Empty {
            /// The name of the slice.
            what: &'static str,
        } => "{what} holds no element";
        /// A slice has the wrong length.
        Length {
            /// The name of the slice.
            what: &'static str,
            /// The length of the slice.
            length: usize,
            /// The length that the slice must have.
            expected: usize,
        } => "{what} holds {} where {expected} {} needed", Count(*length, "element"), if *expected == 1 { "is" } else { "are" };
        /// A range of joints does not lie within the hierarchy.
        Joints {
            /// The range.
            range: Range<usize>,
            /// The number of joints.
            joints: usize,
        } => "joints {range:?} are not a range of a hierarchy of {}", Count(*joints, "joint");
        /// A joint of a range has its parent outside of the range. The run keeps its models in
        /// scratch memory only, so the parent's model is not available.
        NoParent {
            /// The joint.
            joint: usize,
            /// The parent of the joint.
            parent: usize,
        } => "joint {joint} is computed, but its parent, joint {parent}, is not";
        /// A pair of an order is not a joint and its parent, or it has a parent although a root
        /// follows it. The order was then made for another hierarchy, or `Plan::new` did not make
        /// it.
        NotOrder {
            /// The index of the pair in the order.
            place: usize,
        } => "pair {place} of the order is not a joint of this hierarchy and its parent";
        /// A job was given a plan that was made for another hierarchy.
        OtherPlan => "the plan was made for another hierarchy than the job";
        /// A caller asked for a link that the robot (crate `dq8-robot`) does not have.
        NoLink {
            /// The link asked for.
            link: usize,
            /// The number of links.
            links: usize,
        } => "there is no link {link}: the mechanism has {links}, counted from 0";
        /// A caller asked for a pose that the crowd does not have.
        NoPose {
            /// The instance asked for.
            instance: usize,
            /// The joint asked for.
            joint: usize,
            /// The number of instances.
            instances: usize,
            /// The number of joints.
            joints: usize,
        } => "there is no joint {joint} of instance {instance}: the crowd has {} of {}", Count(*instances, "instance"), Count(*joints, "joint");
        /// The frame that was given for an instance is not in the clip, or it is the last frame,
        /// after which there is none.
        NoFrame {
            /// The index of the instance.
            instance: usize,
            /// The frame asked for.
            frame: usize,
            /// The number of frames.
            frames: usize,
        } => "instance {instance} is sampled after frame {frame}, the last or beyond: the clip has {}", Count(*frames, "frame");
        /// An instance is sampled at a place that these packed clips did not make.
        NoPlace {
            /// The index of the instance.
            instance: usize,
        } => "instance {instance} is sampled at a place in other clips than these";
        /// There are fewer poses than the window is long.
        NoWindow {
            /// The number of poses.
            poses: usize,
            /// The length of the window.
            window: usize,
        } => "a window of {window} does not fit into {}", Count(*poses, "pose");
    }
}

/// Checks that the slice with the name `what` has the length `expected`.
///
/// # Errors
/// If the length differs from `expected`.
#[inline]
pub fn same_length(what: &'static str, length: usize, expected: usize) -> Result<(), ShapeError> {
    if length == expected { Ok(()) } else { Err(ShapeError::Length { what, length, expected }) }
}

/// Returns the number of instances in the slice with the name `what`, each of `joints` joints (or
/// links, or values).
///
/// # Errors
/// If `length` is not a multiple of `joints`.
#[inline]
pub fn whole_instances(
    what: &'static str,
    joints: usize,
    length: usize,
) -> Result<usize, ShapeError> {
    // Most callers have one instance, and for them this comparison saves a slow division.
    if length == joints && length > 0 {
        return Ok(1);
    }
    match length.checked_rem(joints) {
        Some(0) => Ok(length / joints),
        None if length == 0 => Ok(0),
        _ => Err(ShapeError::NotWhole { what, length, joints }),
    }
}

/// Checks that a range of joints lies within a hierarchy of `joints` joints.
pub(crate) fn joints_within(range: &Range<usize>, joints: usize) -> Result<(), ShapeError> {
    if range.start <= range.end && range.end <= joints {
        return Ok(());
    }
    Err(ShapeError::Joints { range: range.clone(), joints })
}
