use super::error::HierarchyError;
use super::owned_plan::OwnedPlan;
use super::root::NoRoot;
use super::{Hierarchy, Job, Plan};
use crate::shape::ShapeError;
use crate::storage::Element;
use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;

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
#[derive(Clone, Debug)]
pub struct Skeleton {
    /// Checked: every parent comes before its children.
    parents: Box<[u32]>,
    plan: OwnedPlan,
}

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
        Ok(Self { parents: indices, plan })
    }

    /// Of parents in any order, and the order of its joints: joint `j` is number `order[j]` of
    /// `parents`. What comes after its parent already stays where it is.
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
        let joints = parents.len();
        if joints > Hierarchy::ROOT as usize {
            return Err(HierarchyError::TooManyJoints { joints });
        }
        let old: Vec<u32> = parents.iter().map(|&parent| index(parent)).collect();
        // Where each joint goes. While a joint waits for its ancestors it goes to `WAITS`.
        const UNKNOWN: u32 = u32::MAX;
        const WAITS: u32 = u32::MAX - 1;
        let mut place = vec![UNKNOWN; joints];
        let (mut order, mut sorted, mut waiting) = (Vec::new(), Vec::new(), Vec::new());
        for start in 0..joints {
            let mut joint = start;
            while place[joint] == UNKNOWN {
                place[joint] = WAITS;
                waiting.push(joint);
                let parent = old[joint];
                if parent == Hierarchy::ROOT {
                    break;
                }
                match place.get(parent as usize) {
                    Some(&WAITS) => {
                        return Err(HierarchyError::Cycle { joint: parent as usize });
                    }
                    Some(_) => joint = parent as usize,
                    None => {
                        let parent = parent.into();
                        let error = HierarchyError::ParentOutOfRange { joint, parent, joints };
                        return Err(as_written(error, parents));
                    }
                }
            }
            for joint in waiting.drain(..).rev() {
                place[joint] = order.len() as u32;
                sorted.push(place.get(old[joint] as usize).copied().unwrap_or(Hierarchy::ROOT));
                order.push(joint);
            }
        }
        Ok((Self::new(&sorted)?, order))
    }

    /// How many joints there are.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.parents.len()
    }

    /// The parent of each joint, [`Hierarchy::ROOT`] where there is none.
    #[must_use]
    pub fn parents(&self) -> &[u32] {
        &self.parents
    }

    /// The same, borrowed: for many instances, blocks, velocities and everything else.
    #[must_use]
    pub fn hierarchy(&self) -> Hierarchy<'_> {
        Hierarchy::of_checked(&self.parents)
    }

    /// A run with options: a root, a palette, any form of locals.
    #[must_use]
    pub fn job(&self) -> Job<'_, NoRoot, Plan<'_>> {
        self.hierarchy().job().plan(&self.plan.borrowed(&self.parents))
    }

    /// As [`Hierarchy::local_to_model`].
    ///
    /// # Errors
    /// If the slices differ in length or hold no whole number of instances; `models` is untouched.
    pub fn local_to_model<E: Element<8>>(
        &self,
        locals: &[E],
        models: &mut [E],
    ) -> Result<(), ShapeError> {
        self.job().local_to_model(locals, models)
    }
}

/// The same parents.
impl PartialEq for Skeleton {
    fn eq(&self, other: &Self) -> bool {
        self.parents == other.parents
    }
}

impl Eq for Skeleton {}

impl From<Hierarchy<'_>> for Skeleton {
    fn from(hierarchy: Hierarchy<'_>) -> Self {
        Self { parents: hierarchy.parents().into(), plan: OwnedPlan::new(&hierarchy) }
    }
}

/// A number that names a parent, or says that there is none: −1, the largest number of its type, or
/// `None`. Sealed.
pub trait ParentIndex: Copy + sealed::Sealed {
    /// The parent as it is written; `None` where there is none.
    fn number(self) -> Option<i128>;
}

mod sealed {
    pub trait Sealed {}
}

/// Not the number of a joint, and not the mark of a root.
const BEYOND: u32 = u32::MAX - 1;

/// What a hierarchy calls a parent; [`BEYOND`] if that is no joint.
fn index<P: ParentIndex>(parent: P) -> u32 {
    match parent.number() {
        None => Hierarchy::ROOT,
        Some(number) => u32::try_from(number).unwrap_or(BEYOND).min(BEYOND),
    }
}

/// The error for a parent that is no joint, which names it as it was written.
fn as_written<P: ParentIndex>(error: HierarchyError, parents: &[P]) -> HierarchyError {
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
