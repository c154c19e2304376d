//! [`HierarchyError`]: parents that are not a hierarchy.

use crate::errors::{Count, errors};
use core::fmt;

errors! {
    /// A parent array that is not a hierarchy.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    HierarchyError {
        /// A joint's parent does not come before it: a forward reference, or a cycle.
        ParentNotBefore { joint: usize = "The joint.", parent: u32 = "Its parent." }
            => "joint {joint} {}", NotBefore { joint: *joint, parent: *parent };
        /// A joint's parent is not a joint at all.
        ParentOutOfRange {
            joint: usize = "The joint.",
            parent: i128 = "Its parent, as it was written: a number of any type.",
            joints: usize = "The number of joints."
        }
            => "joint {joint} has parent {parent}{}, which is none of {}, counted from 0 (the parent of a root is −1)",
            Signed(*parent), Count(*joints, "joint");
        /// A joint is its own ancestor.
        Cycle { joint: usize = "The joint." } => "joint {joint} is its own ancestor";
        /// A joint that there is not.
        NoJoint { joint: usize = "The joint asked for.", joints: usize = "The number of joints." }
            => "there is no joint {joint} among {}, counted from 0", Count(*joints, "joint");
        /// The joints below a joint do not lie in one range.
        Scattered {
            joint: usize = "The joint.",
            beyond: usize = "The first joint below it that comes after one that is not."
        }
            => "the joints below joint {joint} are no range: joint {beyond} is one of them, and comes after others \
                (`Skeleton::sorted` numbers subtrees in one range)";
        /// Not as many names as joints.
        Names { names: usize = "The number of names.", joints: usize = "The number of joints." }
            => "{} for {}: each needs one", Count(*names, "name"), Count(*joints, "joint");
        /// A joint has the name of an earlier one.
        SameName { joint: usize = "The joint.", earlier: usize = "The earlier one." }
            => "joint {joint} has the name of joint {earlier}";
        /// More joints than a `u32` can number.
        TooManyJoints { joints: usize = "The number of joints." } => "{joints} joints are more than a u32 can count";
    }
}

/// What is said of a joint and its parent.
struct NotBefore {
    joint: usize,
    parent: u32,
}

impl fmt::Display for NotBefore {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { joint, parent } = *self;
        if joint == parent as usize {
            return f.write_str("is its own parent");
        }
        write!(
            f,
            "has parent {parent}, which must come before it (sort parents first; a cycle cannot be sorted)"
        )
    }
}

/// A negative number that came as a `u32`; nothing, of others.
struct Signed(i128);

impl fmt::Display for Signed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match u32::try_from(self.0).map(u32::cast_signed) {
            Ok(signed @ ..0) => write!(f, " ({signed} as a signed number)"),
            _ => Ok(()),
        }
    }
}
