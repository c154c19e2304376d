//! [`Hierarchy`]: a parent array that has been checked, with queries for parents, children and
//! subtrees, and its errors.

use crate::macros::{Count, brief, errors};
use core::fmt;
use core::ops::Range;

/// A joint hierarchy: the parent of every joint. The parents are checked once, so that no run has
/// to check them.
///
/// Joints are numbered so that every parent comes before its children, as in glTF exporters,
/// ozz-animation and BVH files; there may be several roots.
///
/// ```
/// use dq8::{DualQuat, Hierarchy};
/// // hip → knee → foot, hip → tail
/// let parents = [Hierarchy::ROOT, 0, 1, 0];
/// let leg = Hierarchy::new(&parents)?;
/// let down = DualQuat::from_translation([0.0_f32, -1.0, 0.0]);
/// let mut poses = [down; 4];
/// leg.job().local_to_model_in_place(&mut poses)?;
/// assert_eq!(poses[2].translation(), [0.0, -3.0, 0.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Hierarchy<'a> {
    parents: &'a [u32],
}

brief!([] Hierarchy<'_>: Hierarchy |it| { joints: it.joints() });

impl<'a> Hierarchy<'a> {
    /// The value that marks a root in a parent array, because a root has no parent: −1 as a
    /// `u32`.
    pub const ROOT: u32 = u32::MAX;

    /// Checks `parents`: `parents[j]` is the parent of joint `j`, or [`ROOT`](Self::ROOT). A
    /// [`Skeleton`](super::Skeleton) takes parents of other integer types, such as `usize`, and in
    /// any order.
    ///
    /// # Errors
    /// If a parent is not a joint, or does not come before its child (a forward reference or a
    /// cycle). The error names the first such joint and its parent. There is an error too if there
    /// are more joints than a `u32` can count.
    ///
    /// ```
    /// use dq8::{Hierarchy, hierarchy::HierarchyError};
    /// assert_eq!(
    ///     Hierarchy::new(&[Hierarchy::ROOT, 2, 1]),
    ///     Err(HierarchyError::ParentNotBefore { joint: 1, parent: 2 })
    /// );
    /// ```
    pub fn new(parents: &'a [u32]) -> Result<Self, HierarchyError> {
        if parents.len() > Self::ROOT as usize {
            return Err(HierarchyError::TooManyJoints { joints: parents.len() });
        }
        for (joint, &parent) in parents.iter().enumerate() {
            if parent == Self::ROOT || (parent as usize) < joint {
                continue;
            }
            return Err(if (parent as usize) < parents.len() {
                HierarchyError::ParentNotBefore { joint, parent }
            } else {
                let parent = parent.into();
                HierarchyError::ParentOutOfRange { joint, parent, joints: parents.len() }
            });
        }
        Ok(Self { parents })
    }

    /// Makes a hierarchy of parents that [`new`](Self::new) has already checked.
    #[cfg(feature = "alloc")]
    pub(super) const fn of_checked(parents: &'a [u32]) -> Self {
        Self { parents }
    }

    /// The number of joints.
    #[must_use]
    pub const fn joints(&self) -> usize {
        self.parents.len()
    }

    /// The parent array.
    #[must_use]
    pub const fn parents(&self) -> &'a [u32] {
        self.parents
    }
}

impl<'a> Hierarchy<'a> {
    /// Returns the parent of a joint; `None` for a root or if there is no such joint.
    #[must_use]
    pub fn parent(&self, joint: usize) -> Option<usize> {
        let parent = *self.parents().get(joint)?;
        (parent != Self::ROOT).then_some(parent as usize)
    }

    /// Lists the joints without a parent, in rising order.
    pub fn roots(&self) -> impl Iterator<Item = usize> + use<'a> {
        of_parent(self.parents(), 0, Self::ROOT)
    }

    /// Lists the joints whose parent is `joint`, in rising order.
    pub fn children(&self, joint: usize) -> impl Iterator<Item = usize> + use<'a> {
        // `ROOT` is no joint, although root joints have it as their parent. For `joint` = `ROOT`,
        // and for larger indices, the search begins behind the last joint, so that it finds no
        // children.
        let parent = u32::try_from(joint).unwrap_or(Self::ROOT);
        let after = if parent == Self::ROOT { usize::MAX } else { joint.saturating_add(1) };
        of_parent(self.parents(), after, parent)
    }

    /// Lists the ancestors of a joint: its parent, its grandparent, and so on up to the root.
    /// The list is empty if there is no such joint.
    ///
    /// ```
    /// use dq8::Skeleton;
    /// // hip → knee → foot, hip → tail
    /// let leg = Skeleton::new(&[-1, 0, 1, 0])?;
    /// assert!(leg.ancestors(2).eq([1, 0]));
    /// assert!(leg.is_leaf(3) && !leg.is_leaf(1));
    /// # Ok::<(), dq8::hierarchy::HierarchyError>(())
    /// ```
    pub fn ancestors(&self, joint: usize) -> impl Iterator<Item = usize> + use<'a> {
        let of = *self;
        core::iter::successors(of.parent(joint), move |&joint| of.parent(joint))
    }

    /// Returns `true` if the joint has no children, and `false` if there is no such joint.
    #[must_use]
    pub fn is_leaf(&self, joint: usize) -> bool {
        joint < self.joints() && self.children(joint).next().is_none()
    }

    /// Returns the range of joints that holds the joint and all its descendants, for
    /// [`Job::joints`](super::Job::joints), for a mask, or for slices of locals and models.
    ///
    /// # Errors
    /// If there is no such joint, or the joint and its descendants are not in one range.
    /// [`Skeleton::sorted`](super::Skeleton::sorted) orders joints so that each subtree is a range.
    ///
    /// ```
    /// use dq8::{Skeleton, hierarchy::HierarchyError};
    /// // hip → left knee → left foot, hip → right knee
    /// let rig = Skeleton::new(&[-1, 0, 1, 0])?;
    /// assert_eq!(rig.subtree(1)?, 1..3);
    /// // Its left foot comes after its right knee.
    /// let mixed = Skeleton::new(&[-1, 0, 0, 1])?;
    /// assert_eq!(mixed.subtree(1), Err(HierarchyError::Scattered { joint: 1, beyond: 3 }));
    /// # Ok::<(), HierarchyError>(())
    /// ```
    #[doc(alias("descendants"))]
    pub fn subtree(&self, joint: usize) -> Result<Range<usize>, HierarchyError> {
        let joints = self.joints();
        let Some(after) = self.parents().get(joint.saturating_add(1)..) else {
            return Err(HierarchyError::NoJoint { joint, joints });
        };
        let inside = |end: usize, parent: u32| (joint..end).contains(&(parent as usize));
        let count = after.iter().zip(joint + 1..).take_while(|&(&p, end)| inside(end, p)).count();
        let end = joint + 1 + count;
        match after.iter().skip(count).position(|&parent| inside(end, parent)) {
            Some(place) => Err(HierarchyError::Scattered { joint, beyond: end + place }),
            None => Ok(joint..end),
        }
    }

    /// Writes a line for each joint, indented below its parent.
    pub(super) fn write<'n>(
        &self,
        f: &mut fmt::Formatter<'_>,
        name: impl Fn(usize) -> Option<&'n str>,
    ) -> fmt::Result {
        for joint in 0..self.joints() {
            write!(f, "{:1$}{joint}", "", 2 * self.ancestors(joint).count())?;
            if let Some(name) = name(joint) {
                write!(f, " {name}")?;
            }
            // The indent shows the parent only if the joint of the previous line is the parent or a
            // descendant of the parent. Otherwise the line names the parent.
            if let (Some(parent), Some(before)) = (self.parent(joint), joint.checked_sub(1))
                && parent != before
                && !self.ancestors(before).any(|of| of == parent)
            {
                write!(f, " (of {parent})")?;
            }
            f.write_str("\n")?;
        }
        Ok(())
    }
}

/// Lists the joints from `first` on whose parent is `parent`.
fn of_parent(parents: &[u32], first: usize, parent: u32) -> impl Iterator<Item = usize> + '_ {
    let joints = parents.iter().enumerate().skip(first);
    joints.filter(move |&(_, &of)| of == parent).map(|(joint, _)| joint)
}

/// Writes a line for each joint, with two spaces for each of its ancestors, and with ` (of 3)`
/// where the indents do not show that its parent is joint 3.
impl fmt::Display for Hierarchy<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(f, |_| None)
    }
}

errors! {
    /// A parent array that is not a hierarchy.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    HierarchyError {
        /// The parent of a joint does not come before the joint: a forward reference or a cycle.
        ParentNotBefore { joint: usize = "The joint.", parent: u32 = "Its parent." }
            => "joint {joint} {}", NotBefore { joint: *joint, parent: *parent };
        /// The parent of a joint is not the index of a joint.
        ParentOutOfRange {
            joint: usize = "The joint.",
            parent: i128 = "Its parent, as it was written: a number of any type.",
            joints: usize = "The number of joints."
        }
            => "joint {joint} has parent {parent}{}, which is none of {}, counted from 0 (the parent of a root is −1)",
            Signed(*parent), Count(*joints, "joint");
        /// A joint is its own ancestor.
        Cycle { joint: usize = "The joint." } => "joint {joint} is its own ancestor";
        /// A caller asked for a joint that the hierarchy does not have.
        NoJoint { joint: usize = "The joint asked for.", joints: usize = "The number of joints." }
            => "there is no joint {joint} among {}, counted from 0", Count(*joints, "joint");
        /// A joint and its descendants are not in one range.
        Scattered {
            joint: usize = "The joint.",
            beyond: usize = "The first joint below it that comes after one that is not."
        }
            => "the joints below joint {joint} are no range: joint {beyond} is one of them, and comes after others \
                (`Skeleton::sorted` numbers subtrees in one range)";
        /// The number of names differs from the number of joints.
        Names { names: usize = "The number of names.", joints: usize = "The number of joints." }
            => "{} for {}: each needs one", Count(*names, "name"), Count(*joints, "joint");
        /// A joint has the name of an earlier joint.
        SameName { joint: usize = "The joint.", earlier: usize = "The earlier one." }
            => "joint {joint} has the name of joint {earlier}";
        /// There are more joints than a `u32` can count.
        TooManyJoints { joints: usize = "The number of joints." } => "{joints} joints are more than a u32 can count";
    }
}

/// The part of an error text about a joint whose parent does not come before it.
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

/// The part of an error text that shows a parent as a signed number; empty if it is not negative.
struct Signed(i128);

impl fmt::Display for Signed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match u32::try_from(self.0).map(u32::cast_signed) {
            Ok(signed @ ..0) => write!(f, " ({signed} as a signed number)"),
            _ => Ok(()),
        }
    }
}
