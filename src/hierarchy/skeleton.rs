use super::error::HierarchyError;
use super::owned_plan::OwnedPlan;
use super::parent_index::{ParentIndex, as_written, index};
use super::root::NoRoot;
use super::{Hierarchy, Job, Plan};
use crate::brief::brief;
use crate::storage::Element;
use crate::storage::shape::ShapeError;
use alloc::boxed::Box;
use alloc::collections::BTreeMap;
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;
use core::ops::Range;

/// A hierarchy that owns its parents, to be stored in a struct: what an engine keeps for each rig.
///
/// A [`Hierarchy`] borrows its parents; this holds them, and the [`Plan`](super::Plan) of them, with which its
/// [`job`](Self::job) is faster for one instance in a plain slice.
///
/// Parents are integers of 8 to 64 bits: −1, the largest number of the type or `None` says that there is none. As
/// glTF, URDF and FBX list them in any order, [`sorted`](Self::sorted) finds one with parents first.
///
/// ```
/// use dq8::{DualQuat, Quat, Skeleton, hierarchy::Bones};
///
/// struct Rig {
///     skeleton: Skeleton,
///     offsets: Vec<[f32; 3]>,
/// }
///
/// // foot → knee → hip, as a file may list them; −1 for the hip.
/// let (skeleton, order) = Skeleton::sorted(&[1, 2, -1])?;
/// assert_eq!(order, [2, 1, 0]);
/// let down = [[0.0, -1.0, 0.0], [0.0, -1.0, 0.0], [0.0; 3]];
/// let rig = Rig { skeleton, offsets: order.iter().map(|&joint| down[joint]).collect() };
///
/// let (mut models, mut palette) = ([DualQuat::default(); 3], [[[0.0; 4]; 3]; 3]);
/// let locals = Bones { rotations: &[Quat::IDENTITY; 3], offsets: &rig.offsets };
/// let job = rig.skeleton.job().root(DualQuat::from_translation([0.0, 5.0, 0.0]));
/// job.palette_and_models(locals, &mut models, &[DualQuat::IDENTITY; 3], &mut palette)?;
/// assert_eq!(models[2].translation(), [0.0, 3.0, 0.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone)]
#[doc(alias("rig", "armature"))]
pub struct Skeleton {
    /// Checked: every parent comes before its children.
    parents: Box<[u32]>,
    plan: OwnedPlan,
    /// One for each joint, or none.
    names: Box<[Box<str>]>,
}

brief!([] Skeleton: Skeleton |it| { joints: it.parents.len(), names: it.names.len() });

impl Skeleton {
    /// Of parents that come before their children.
    ///
    /// # Errors
    /// As [`Hierarchy::new`]; [`sorted`](Self::sorted) takes any order.
    ///
    /// # Panics
    /// If the memory cannot be allocated, as for any `Vec`.
    ///
    /// ```
    /// use dq8::Skeleton;
    /// let parents = [None, Some(0_usize), Some(1)];
    /// assert_eq!(Skeleton::new(&parents)?.parents(), [u32::MAX, 0, 1]);
    /// assert!(Skeleton::new(&[1, -1]).is_err());
    /// # Ok::<(), dq8::hierarchy::HierarchyError>(())
    /// ```
    pub fn new<P: ParentIndex>(parents: &[P]) -> Result<Self, HierarchyError> {
        let indices: Box<[u32]> = parents.iter().map(|&parent| index(parent)).collect();
        let hierarchy = Hierarchy::new(&indices).map_err(|error| as_written(error, parents))?;
        let plan = OwnedPlan::new(&hierarchy);
        Ok(Self { parents: indices, plan, names: Box::default() })
    }

    /// Of parents in any order, and the order of its joints: joint `j` is number `order[j]` of `parents`. Each joint is
    /// followed by all that hang from it, so that every [`subtree`](Self::subtree) is a range; brothers stay in their
    /// order.
    ///
    /// # Errors
    /// If a parent is not a joint, joints are their own ancestors, or there are more than a `u32` can
    /// number.
    ///
    /// # Panics
    /// If the memory cannot be allocated, as for any `Vec`.
    ///
    /// ```
    /// use dq8::{Skeleton, hierarchy::HierarchyError};
    /// let (skeleton, order) = Skeleton::sorted(&[Some(2_u32), Some(0), None])?;
    /// assert_eq!((skeleton.parents(), order), (&[u32::MAX, 0, 1][..], vec![2, 0, 1]));
    /// assert_eq!(Skeleton::sorted(&[1, 0]).unwrap_err(), HierarchyError::Cycle { joint: 0 });
    /// # Ok::<(), HierarchyError>(())
    /// ```
    pub fn sorted<P: ParentIndex>(parents: &[P]) -> Result<(Self, Vec<usize>), HierarchyError> {
        const NONE: u32 = Hierarchy::ROOT;
        let joints = parents.len();
        if joints > NONE as usize {
            return Err(HierarchyError::TooManyJoints { joints });
        }
        let old: Vec<u32> = parents.iter().map(|&parent| index(parent)).collect();
        // Of each joint its first child and its next brother, in their order; the roots are children of nobody.
        let (mut child, mut brother) = (vec![NONE; joints], vec![NONE; joints]);
        let mut root = NONE;
        for (joint, &parent) in old.iter().enumerate().rev() {
            let first = if parent == NONE {
                &mut root
            } else {
                let error =
                    HierarchyError::ParentOutOfRange { joint, parent: parent.into(), joints };
                child.get_mut(parent as usize).ok_or_else(|| as_written(error, parents))?
            };
            brother[joint] = core::mem::replace(first, joint as u32);
        }
        let (mut order, mut sorted) = (Vec::with_capacity(joints), Vec::with_capacity(joints));
        // What comes next, and the new number of its parent.
        let mut waiting = vec![[root, NONE]];
        while let Some([joint, parent]) = waiting.pop() {
            if joint != NONE {
                waiting.push([brother[joint as usize], parent]);
                waiting.push([child[joint as usize], order.len() as u32]);
                sorted.push(parent);
                order.push(joint as usize);
            }
        }
        if order.len() < joints {
            // Whoever is reached from no root hangs below a circle: as many steps up as there are joints lead into it.
            let mut reached = vec![false; joints];
            order.iter().for_each(|&joint| reached[joint] = true);
            let lost = reached.iter().position(|reached| !reached).unwrap_or(0);
            let joint = (0..joints).fold(lost, |joint, _| old[joint] as usize);
            return Err(HierarchyError::Cycle { joint });
        }
        Ok((Self::new(&sorted)?, order))
    }

    /// With a name for each joint; empty where it has none.
    ///
    /// # Errors
    /// If there are not as many names as joints, or two joints have the same.
    ///
    /// # Panics
    /// If the memory cannot be allocated, as for any `Vec`.
    ///
    /// ```
    /// use dq8::Skeleton;
    /// // What a file lists in any order has its names in the same one.
    /// let (names, parents) = (["hand", "shoulder", "elbow"], [2, -1, 1]);
    /// let (arm, order) = Skeleton::sorted(&parents)?;
    /// let arm = arm.with_names(order.iter().map(|&joint| names[joint]))?;
    /// assert_eq!((arm.joint("elbow"), arm.name(2)), (Some(1), Some("hand")));
    /// assert_eq!(arm.to_string(), "0 shoulder\n  1 elbow\n    2 hand\n");
    /// # Ok::<(), dq8::hierarchy::HierarchyError>(())
    /// ```
    pub fn with_names<N: Into<Box<str>>>(
        self,
        names: impl IntoIterator<Item = N>,
    ) -> Result<Self, HierarchyError> {
        let names: Box<[Box<str>]> = names.into_iter().map(Into::into).collect();
        let joints = self.joints();
        if names.len() != joints {
            return Err(HierarchyError::Names { names: names.len(), joints });
        }
        let mut joint_of = BTreeMap::new();
        for (joint, name) in names.iter().enumerate().filter(|(_, name)| !name.is_empty()) {
            if let Some(earlier) = joint_of.insert(name, joint) {
                return Err(HierarchyError::SameName { joint, earlier });
            }
        }
        Ok(Self { names, ..self })
    }

    /// The name of a joint, if it has one.
    #[must_use]
    pub fn name(&self, joint: usize) -> Option<&str> {
        self.names.get(joint).map(|name| &**name).filter(|name| !name.is_empty())
    }

    /// The name of each joint that has one, `None` for the others.
    pub fn names(&self) -> impl ExactSizeIterator<Item = Option<&str>> {
        (0..self.joints()).map(|joint| self.name(joint))
    }

    /// The joint of this name.
    #[must_use]
    #[doc(alias("find_joint", "joint_index", "bone_index"))]
    pub fn joint(&self, name: &str) -> Option<usize> {
        (0..self.names.len()).find(|&joint| self.name(joint) == Some(name))
    }

    /// The number of joints.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.parents.len()
    }

    /// The parent of each joint, [`Hierarchy::ROOT`] where there is none.
    #[must_use]
    pub fn parents(&self) -> &[u32] {
        &self.parents
    }

    /// As [`Hierarchy::parent`].
    #[must_use]
    pub fn parent(&self, joint: usize) -> Option<usize> {
        self.hierarchy().parent(joint)
    }

    /// As [`Hierarchy::roots`].
    pub fn roots(&self) -> impl Iterator<Item = usize> + '_ {
        self.hierarchy().roots()
    }

    /// As [`Hierarchy::children`].
    pub fn children(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        self.hierarchy().children(joint)
    }

    /// As [`Hierarchy::ancestors`].
    pub fn ancestors(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        self.hierarchy().ancestors(joint)
    }

    /// As [`Hierarchy::is_leaf`].
    #[must_use]
    pub fn is_leaf(&self, joint: usize) -> bool {
        self.hierarchy().is_leaf(joint)
    }

    /// As [`Hierarchy::subtree`].
    ///
    /// # Errors
    /// If there is no such joint, or what hangs from it does not lie in one range.
    pub fn subtree(&self, joint: usize) -> Result<Range<usize>, HierarchyError> {
        self.hierarchy().subtree(joint)
    }

    /// The same parents, borrowed.
    #[must_use]
    pub fn hierarchy(&self) -> Hierarchy<'_> {
        Hierarchy::of_checked(&self.parents)
    }

    /// A run with options: a root, a palette, any form of locals.
    pub fn job(&self) -> Job<'_, NoRoot, Plan<'_>> {
        self.hierarchy().job().plan(&self.plan.borrowed(&self.parents))
    }

    /// As [`Hierarchy::local_to_model`].
    ///
    /// # Errors
    /// If the slices differ in length or hold no whole number of instances; `models` is untouched.
    #[doc(alias("forward_kinematics", "fk", "LocalToModelJob"))]
    pub fn local_to_model<E: Element<8>>(
        &self,
        locals: &[E],
        models: &mut [E],
    ) -> Result<(), ShapeError> {
        self.job().local_to_model(locals, models)
    }
}

/// The same parents and names.
impl PartialEq for Skeleton {
    fn eq(&self, other: &Self) -> bool {
        (&self.parents, &self.names) == (&other.parents, &other.names)
    }
}

impl Eq for Skeleton {}

/// As [`Hierarchy`], with the names of the joints.
impl fmt::Display for Skeleton {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.hierarchy().write(f, |joint| self.name(joint))
    }
}

impl From<Hierarchy<'_>> for Skeleton {
    fn from(hierarchy: Hierarchy<'_>) -> Self {
        let plan = OwnedPlan::new(&hierarchy);
        Self { parents: hierarchy.parents().into(), plan, names: Box::default() }
    }
}
