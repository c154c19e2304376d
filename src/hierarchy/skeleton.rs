//! [`Skeleton`]: a hierarchy that owns its parents, its plan and the names of its joints. It takes
//! parents of any integer type ([`ParentIndex`]) and in any order ([`JointOrder`]).

use super::parents::HierarchyError;
use super::plan::{Order, Plan, PlanScratch, is_long_chain, schedule, split_roots};
use super::run::NoRoot;
use super::{Hierarchy, Job};
use crate::macros::brief;
use crate::storage::Element;
use crate::storage::shape::{ShapeError, same_length};
use alloc::boxed::Box;
use alloc::collections::BTreeMap;
use alloc::vec;
use alloc::vec::Vec;
use core::fmt;
use core::ops::{Deref, Range};
use dq8_simd::internal::CheckedSchedule;

/// A hierarchy that owns its parents, to be stored in a struct, such as an engine's rig.
///
/// A [`Hierarchy`] borrows its parents. A skeleton owns them and their [`Plan`](super::Plan), with
/// which its [`job`](Self::job) computes one instance in a plain slice faster.
///
/// Parents are integers of 8 to 64 bits; a root has the parent −1, the largest value of the type,
/// or `None`. Files such as glTF, URDF and FBX list joints in any order; [`sorted`](Self::sorted)
/// puts parents before their children.
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
/// // What the file has for its joints follows.
/// let down = [[0.0, -1.0, 0.0], [0.0, -1.0, 0.0], [0.0; 3]];
/// let rig = Rig { skeleton, offsets: order.gather(&down)? };
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
    /// The parent of each joint. The parents have been checked: each comes before its children.
    parents: Box<[u32]>,
    plan: OwnedPlan,
    /// A name for each joint, or an empty slice if the joints have no names.
    names: Box<[Box<str>]>,
}

/// The permutation between the joints of a skeleton and those of the file, that is, of the list of
/// parents from which [`Skeleton::sorted`] made the skeleton. It derefs to a slice: joint `j` of
/// the skeleton is joint `order[j]` of the file.
///
/// ```
/// use dq8::Skeleton;
/// // hand ← elbow ← shoulder
/// let (arm, order) = Skeleton::sorted(&[2, -1, 1])?;
/// assert_eq!(order.gather(&["hand", "shoulder", "elbow"])?, ["shoulder", "elbow", "hand"]);
/// // A vertex that hangs on the file's joints 0 and 2.
/// assert_eq!([0, 2].map(|joint| order.of(joint)), [Some(2), Some(1)]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JointOrder {
    /// The index in the file of each joint of the skeleton.
    old: Vec<usize>,
    /// The index in the skeleton of each joint of the file.
    new: Vec<usize>,
}

impl JointOrder {
    /// Reorders a list with one element for each joint of the file into the order of the skeleton.
    ///
    /// # Errors
    /// If the list does not have one element for each joint.
    ///
    /// # Panics
    /// If the memory cannot be allocated, as for any `Vec`.
    pub fn gather<T: Clone>(&self, things: &[T]) -> Result<Vec<T>, ShapeError> {
        same_length("things", things.len(), self.old.len())?;
        Ok(self.old.iter().map(|&joint| things[joint].clone()).collect())
    }

    /// Returns the index in the skeleton of a joint of the file; `None` if there is no such joint.
    #[must_use]
    pub fn of(&self, joint: usize) -> Option<usize> {
        self.new.get(joint).copied()
    }
}

impl Deref for JointOrder {
    type Target = [usize];

    fn deref(&self) -> &[usize] {
        &self.old
    }
}

brief!([] Skeleton: Skeleton |it| { joints: it.parents.len(), names: it.names.len() });

impl Skeleton {
    /// Makes a skeleton of parents that come before their children.
    ///
    /// # Errors
    /// The errors of [`Hierarchy::new`]. Use [`sorted`](Self::sorted) for parents in any other
    /// order.
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

    /// Makes a skeleton of parents in any order, and returns it with the [order](JointOrder) of its
    /// joints: joint `j` of the skeleton is joint `order[j]` of `parents`. Everything else that a
    /// file lists for its joints (names, inverse bind poses, the rest pose, tracks, joints of
    /// vertices) is still in the order of the file; [`JointOrder::gather`] and [`JointOrder::of`]
    /// convert it. Each joint is followed by its descendants, so that every
    /// [`subtree`](Self::subtree) is a range; siblings keep their order.
    ///
    /// # Errors
    /// If a parent is not a joint, a joint is its own ancestor, or there are more joints than a
    /// `u32` can count.
    ///
    /// # Panics
    /// If the memory cannot be allocated, as for any `Vec`.
    ///
    /// ```
    /// use dq8::{Skeleton, hierarchy::HierarchyError};
    /// let (skeleton, order) = Skeleton::sorted(&[Some(2_u32), Some(0), None])?;
    /// assert_eq!((skeleton.parents(), &order[..]), (&[u32::MAX, 0, 1][..], &[2, 0, 1][..]));
    /// assert_eq!(Skeleton::sorted(&[1, 0]).unwrap_err(), HierarchyError::Cycle { joint: 0 });
    /// # Ok::<(), HierarchyError>(())
    /// ```
    pub fn sorted<P: ParentIndex>(parents: &[P]) -> Result<(Self, JointOrder), HierarchyError> {
        const NONE: u32 = Hierarchy::ROOT;
        let joints = parents.len();
        if joints > NONE as usize {
            return Err(HierarchyError::TooManyJoints { joints });
        }
        let old: Vec<u32> = parents.iter().map(|&parent| index(parent)).collect();
        // `child` has the first child of each joint, and `sibling` its next sibling, in the order
        // of the file. All indices here are those of the file.
        let (mut child, mut sibling) = (vec![NONE; joints], vec![NONE; joints]);
        let mut root = NONE;
        for (joint, &parent) in old.iter().enumerate().rev() {
            let first = if parent == NONE {
                &mut root
            } else {
                let error =
                    HierarchyError::ParentOutOfRange { joint, parent: parent.into(), joints };
                child.get_mut(parent as usize).ok_or_else(|| as_written(error, parents))?
            };
            sibling[joint] = core::mem::replace(first, joint as u32);
        }
        let (mut order, mut sorted) = (Vec::with_capacity(joints), Vec::with_capacity(joints));
        // A stack of joints that are not in the skeleton yet. Each element is a joint's index in
        // the file and its parent's index in the skeleton.
        let mut waiting = vec![[root, NONE]];
        while let Some([joint, parent]) = waiting.pop() {
            if joint != NONE {
                waiting.push([sibling[joint as usize], parent]);
                waiting.push([child[joint as usize], order.len() as u32]);
                sorted.push(parent);
                order.push(joint as usize);
            }
        }
        if order.len() < joints {
            // A joint that was not reached is in a cycle, or a descendant of a cycle. From such a
            // joint, `joints` steps, each from a joint to its parent, certainly end in the cycle.
            let mut reached = vec![false; joints];
            order.iter().for_each(|&joint| reached[joint] = true);
            let lost = reached.iter().position(|reached| !reached).unwrap_or(0);
            let joint = (0..joints).fold(lost, |joint, _| old[joint] as usize);
            return Err(HierarchyError::Cycle { joint });
        }
        let mut new = vec![0; joints];
        for (joint, &old) in order.iter().enumerate() {
            new[old] = joint;
        }
        Ok((Self::new(&sorted)?, JointOrder { old: order, new }))
    }

    /// Makes a skeleton as [`sorted`](Self::sorted) does, with names in the order of `parents`.
    ///
    /// # Errors
    /// The errors of [`sorted`](Self::sorted) and of [`with_names`](Self::with_names). An error
    /// about names has the indices of joints in the skeleton.
    ///
    /// # Panics
    /// If the memory cannot be allocated, as for any `Vec`.
    ///
    /// ```
    /// use dq8::Skeleton;
    /// let (arm, order) = Skeleton::sorted_named(&[2, -1, 1], &["hand", "shoulder", "elbow"])?;
    /// assert_eq!((arm.joint("elbow"), arm.name(2)), (Some(1), Some("hand")));
    /// assert_eq!(order.of(0), Some(2)); // the hand
    /// # Ok::<(), dq8::hierarchy::HierarchyError>(())
    /// ```
    pub fn sorted_named<P: ParentIndex, N: Clone + Into<Box<str>>>(
        parents: &[P],
        names: &[N],
    ) -> Result<(Self, JointOrder), HierarchyError> {
        let (skeleton, order) = Self::sorted(parents)?;
        let joints = skeleton.joints();
        let wrong = |_| HierarchyError::Names { names: names.len(), joints };
        let names = order.gather(names).map_err(wrong)?;
        Ok((skeleton.with_names(names)?, order))
    }

    /// Gives each joint a name; a joint whose text is empty has no name.
    ///
    /// # Errors
    /// If there are not as many names as joints, or two joints have the same name.
    ///
    /// # Panics
    /// If the memory cannot be allocated, as for any `Vec`.
    ///
    /// ```
    /// use dq8::Skeleton;
    /// let arm = Skeleton::new(&[-1, 0, 1])?.with_names(["shoulder", "elbow", "hand"])?;
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

    /// Returns the name of a joint; `None` if it has no name or there is no such joint.
    #[must_use]
    pub fn name(&self, joint: usize) -> Option<&str> {
        self.names.get(joint).map(|name| &**name).filter(|name| !name.is_empty())
    }

    /// Lists the names of all joints, with `None` for each joint without a name.
    pub fn names(&self) -> impl ExactSizeIterator<Item = Option<&str>> {
        (0..self.joints()).map(|joint| self.name(joint))
    }

    /// Returns the joint with this name; `None` if there is no such joint.
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

    /// The parent of each joint; the parent of a root is [`Hierarchy::ROOT`].
    #[must_use]
    pub fn parents(&self) -> &[u32] {
        &self.parents
    }

    /// Returns the parent of a joint; see [`Hierarchy::parent`].
    #[must_use]
    pub fn parent(&self, joint: usize) -> Option<usize> {
        self.hierarchy().parent(joint)
    }

    /// Lists the joints without a parent; see [`Hierarchy::roots`].
    pub fn roots(&self) -> impl Iterator<Item = usize> + '_ {
        self.hierarchy().roots()
    }

    /// Lists the children of a joint; see [`Hierarchy::children`].
    pub fn children(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        self.hierarchy().children(joint)
    }

    /// Lists the ancestors of a joint; see [`Hierarchy::ancestors`].
    pub fn ancestors(&self, joint: usize) -> impl Iterator<Item = usize> + '_ {
        self.hierarchy().ancestors(joint)
    }

    /// Returns `true` if a joint has no children; see [`Hierarchy::is_leaf`].
    #[must_use]
    pub fn is_leaf(&self, joint: usize) -> bool {
        self.hierarchy().is_leaf(joint)
    }

    /// Returns the range of a joint and its descendants; see [`Hierarchy::subtree`].
    ///
    /// # Errors
    /// If there is no such joint, or the joint and its descendants are not in one range.
    pub fn subtree(&self, joint: usize) -> Result<Range<usize>, HierarchyError> {
        self.hierarchy().subtree(joint)
    }

    /// Returns this skeleton as a [`Hierarchy`], which borrows the parents.
    #[must_use]
    pub fn hierarchy(&self) -> Hierarchy<'_> {
        Hierarchy::of_checked(&self.parents)
    }

    /// Begins a run over this skeleton with its plan; methods of the job set options, such as a
    /// root.
    pub fn job(&self) -> Job<'_, NoRoot, Plan<'_>> {
        self.hierarchy().job().plan(&self.plan.borrowed(&self.parents))
    }

    /// Computes models from locals; see [`Hierarchy::local_to_model`].
    ///
    /// # Errors
    /// If the slices differ in length, or their length is not a multiple of the number of joints;
    /// `models` is untouched.
    #[doc(alias("forward_kinematics", "fk", "LocalToModelJob"))]
    pub fn local_to_model<E: Element<8>>(
        &self,
        locals: &[E],
        models: &mut [E],
    ) -> Result<(), ShapeError> {
        self.job().local_to_model(locals, models)
    }
}

/// Skeletons are equal if their parents and their names are equal.
impl PartialEq for Skeleton {
    fn eq(&self, other: &Self) -> bool {
        (&self.parents, &self.names) == (&other.parents, &other.names)
    }
}

impl Eq for Skeleton {}

/// Writes the joints as a [`Hierarchy`] does, with their names.
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

/// The checked order of a [`Plan`], which owns its memory.
#[derive(Clone, Debug)]
pub(super) struct OwnedPlan {
    roots: Box<[[u32; 2]]>,
    /// The joints that have a parent; `None` for a long chain, which is computed in segments.
    others: Option<CheckedSchedule<Box<[[u32; 2]]>>>,
}

impl OwnedPlan {
    pub(super) fn new(hierarchy: &Hierarchy<'_>) -> Self {
        let joints = hierarchy.joints();
        let mut order = vec![[0; 2]; joints];
        schedule(hierarchy, &mut order, &mut vec![PlanScratch::default(); joints]);
        if is_long_chain(&order) {
            return Self { roots: Box::default(), others: None };
        }
        let (roots, others) = split_roots(&order);
        let others = CheckedSchedule::new(others.into(), joints);
        let others = others.expect("a hierarchy's parents are among its joints");
        Self { roots: roots.into(), others: Some(others) }
    }

    /// Borrows the plan. It must have been made for `parents`.
    #[inline]
    pub(super) fn borrowed<'a>(&'a self, parents: &'a [u32]) -> Plan<'a> {
        let others = self.others.as_ref();
        let order = others.map(|others| Order { roots: &self.roots, others: others.borrowed() });
        Plan { parents, order }
    }
}

/// The type of the index of a parent, an integer. The parent of a root is −1, the largest value
/// of the type or, if the type is an `Option` of an integer, `None`. The trait is sealed.
pub trait ParentIndex: Copy + sealed::Sealed {
    /// Returns the index as the caller wrote it; `None` if there is no parent.
    fn number(self) -> Option<i128>;
}

mod sealed {
    pub trait Sealed {}
}

/// The index that stands for a parent whose index does not fit a `u32`. No joint has this index,
/// and it does not mark a root.
const BEYOND: u32 = u32::MAX - 1;

/// Converts a parent to its index in a [`Hierarchy`]; [`BEYOND`] if the index does not fit.
pub(super) fn index<P: ParentIndex>(parent: P) -> u32 {
    match parent.number() {
        None => Hierarchy::ROOT,
        Some(number) => u32::try_from(number).unwrap_or(BEYOND).min(BEYOND),
    }
}

/// Replaces the parent in an error by the parent as the caller wrote it, which may not fit a `u32`.
pub(super) fn as_written<P: ParentIndex>(error: HierarchyError, parents: &[P]) -> HierarchyError {
    match error {
        HierarchyError::ParentOutOfRange { joint, parent, joints } => {
            let written = parents.get(joint).and_then(|parent| parent.number());
            let parent = written.unwrap_or(parent);
            HierarchyError::ParentOutOfRange { joint, parent, joints }
        }
        _ => error,
    }
}

macro_rules! parent_indices {
    ($($number:ty)*) => {$(
        impl sealed::Sealed for $number {}
        impl ParentIndex for $number {
            fn number(self) -> Option<i128> {
                let number = self as i128;
                (number != -1 && self != Self::MAX).then_some(number)
            }
        }
        impl sealed::Sealed for Option<$number> {}
        impl ParentIndex for Option<$number> {
            fn number(self) -> Option<i128> {
                self.map(|parent| parent as i128)
            }
        }
    )*};
}
parent_indices! { u8 u16 u32 u64 usize i8 i16 i32 i64 isize }
