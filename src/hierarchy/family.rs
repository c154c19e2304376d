//! Parents, children and subtrees of a [`Hierarchy`], and how it is written.

use super::Hierarchy;
use super::error::HierarchyError;
use core::fmt;
use core::ops::Range;

impl<'a> Hierarchy<'a> {
    /// The parent of a joint; `None` of a root, and where there is no such joint.
    #[must_use]
    pub fn parent(&self, joint: usize) -> Option<usize> {
        let parent = *self.parents().get(joint)?;
        (parent != Self::ROOT).then_some(parent as usize)
    }

    /// The joints without a parent, in rising order.
    pub fn roots(&self) -> impl Iterator<Item = usize> + use<'a> {
        of_parent(self.parents(), 0, Self::ROOT)
    }

    /// The joints whose parent is `joint`, in rising order.
    pub fn children(&self, joint: usize) -> impl Iterator<Item = usize> + use<'a> {
        // Beyond the last joint nothing has a parent, and no joint is numbered as the mark of a
        // root.
        let parent = u32::try_from(joint).unwrap_or(Self::ROOT);
        let after = if parent == Self::ROOT { usize::MAX } else { joint.saturating_add(1) };
        of_parent(self.parents(), after, parent)
    }

    /// The parent of a joint, its parent, and so on up to the root; none where there is no such
    /// joint.
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

    /// `true` if nothing hangs from the joint; false where there is no such joint.
    #[must_use]
    pub fn is_leaf(&self, joint: usize) -> bool {
        joint < self.joints() && self.children(joint).next().is_none()
    }

    /// The joint and all that hang from it, as a range of joints: for
    /// [`Job::joints`](super::Job::joints), for a mask, and for slices of locals and models.
    ///
    /// # Errors
    /// If there is no such joint, or what hangs from it does not lie in one range.
    /// [`Skeleton::sorted`](super::Skeleton::sorted) numbers joints so that it always does.
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

    /// A line for each joint, indented below its parent.
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
            // Where the line before neither is the parent nor hangs from it, the indent does not
            // say who is.
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

/// The joints from `first` on whose parent is `parent`.
fn of_parent(parents: &[u32], first: usize, parent: u32) -> impl Iterator<Item = usize> + '_ {
    let joints = parents.iter().enumerate().skip(first);
    joints.filter(move |&(_, &of)| of == parent).map(|(joint, _)| joint)
}

/// A line for each joint, with two spaces for each joint above it; ` (of 3)` where the lines do not
/// show its parent.
impl fmt::Display for Hierarchy<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(f, |_| None)
    }
}
