use super::error::HierarchyError;
use crate::brief::brief;

/// A joint hierarchy: the parent of every joint, checked once, so that no run has to.
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
    /// The parent of a joint that has none: −1 as a `u32`.
    pub const ROOT: u32 = u32::MAX;

    /// Checks `parents`: `parents[j]` is the parent of joint `j`, or [`ROOT`](Self::ROOT). A
    /// [`Skeleton`](super::Skeleton) takes parents of another type, such as `usize`, or in another
    /// order.
    ///
    /// # Errors
    /// If a parent is not a joint, or does not come before its child (a forward reference or a
    /// cycle). The error names the first such joint and its parent. Also if there are more joints
    /// than a `u32` can number.
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

    /// Of parents that have been checked.
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
