//! [`BorrowedPlan`]: how to compute one instance, in memory of the caller's.

use super::Hierarchy;
use super::product::product;
use super::schedule::{PlanScratch, schedule};
use crate::dispatch::{Backend, Kernel};
use crate::real::Scalar;
use crate::scalar::DualQuat;
use crate::shape::{ShapeError, same_length, whole_instances};
use crate::storage::Source;
use dq8_simd::{CheckedSchedule, Level};

/// From this many joints on, a chain is cut into segments: `cargo bench --bench hierarchy --
/// one-instance/chain` shows both strategies around it. (Nanoseconds per joint, AVX-512, of 16, 24 and 32
/// joints: ordered 4.9, 5.6, 6.0; in segments 6.7, 5.3, 4.7. Without AVX2 segments never win.)
const MIN_CHAIN: usize = 24;

/// Whether chains are cut into segments at all: without AVX2 that never wins, and firmware counts the bytes.
pub(super) const SEGMENTS: bool = cfg!(target_arch = "x86_64");

/// The order in which to compute one instance of a hierarchy, in memory of the caller's: what
/// `HierarchyPlan` is, without the feature `alloc`.
///
/// ```
/// use dq8::{DualQuat, Hierarchy, hierarchy::{BorrowedPlan, PlanScratch}};
/// let parents = [Hierarchy::ROOT, 0, 1, 0];
/// let mut order = [[0; 2]; 4];
/// let mut scratch = [PlanScratch::default(); 4]; // no longer needed when the plan is found
/// let plan = BorrowedPlan::new(&Hierarchy::new(&parents)?, &mut order, &mut scratch)?;
/// let locals = [DualQuat::from_translation([0.0_f32, 2.0, 0.0]); 4];
/// let mut models = locals;
/// plan.local_to_model(&locals, &mut models)?;
/// assert_eq!(models[2].translation(), [0.0, 6.0, 0.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct BorrowedPlan<'a> {
    joints: usize,
    /// `None` for a chain in segments.
    order: Option<Order<'a>>,
    backend: Option<Backend>,
}

/// The joints of one instance in the order of computing, each with its parent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Order<'a> {
    /// Joints without a parent, which come first.
    pub(super) roots: &'a [[u32; 2]],
    pub(super) others: CheckedSchedule<&'a [[u32; 2]]>,
}

impl<'a> BorrowedPlan<'a> {
    /// Writes the order into `order`, and borrows it. `order` and `scratch` have an element per joint.
    ///
    /// # Errors
    /// If one of them is of another length; both are untouched.
    pub fn new(
        hierarchy: &Hierarchy<'_>,
        order: &'a mut [[u32; 2]],
        scratch: &mut [PlanScratch],
    ) -> Result<Self, ShapeError> {
        let joints = hierarchy.joints();
        same_length("order", order.len(), joints)?;
        same_length("scratch", scratch.len(), joints)?;
        schedule(hierarchy, order, scratch);
        // It has just been written, so it is one; a plan of no joints would refuse all poses.
        Ok(Self::of_order(order).unwrap_or(Self::of(0, None)))
    }

    /// The plan of an order that [`new`](Self::new) wrote; `None` if a number in it is no joint. To keep an order
    /// where a plan cannot borrow it, such as a constant in flash.
    #[must_use]
    pub fn of_order(order: &'a [[u32; 2]]) -> Option<Self> {
        if is_long_chain(order) {
            return Some(Self::of(order.len(), None));
        }
        // Checked once, here, so that the loop over the others has no bounds to check.
        let (roots, others) = split_roots(order);
        let others = CheckedSchedule::new(others, order.len())?;
        roots.iter().all(|[root, _]| (*root as usize) < order.len()).then_some(())?;
        Some(Self::of(order.len(), Some(Order { roots, others })))
    }

    pub(super) const fn of(joints: usize, order: Option<Order<'a>>) -> Self {
        Self { joints, order, backend: None }
    }

    /// How many joints there are.
    #[must_use]
    pub const fn joints(&self) -> usize {
        self.joints
    }

    /// Runs with these instructions; by default with the best that the CPU has.
    #[must_use]
    pub fn backend(mut self, backend: Backend) -> Self {
        self.backend = Some(backend);
        self
    }

    /// Model poses of all joints from local ones, both in the joints' own order; one instance, or
    /// several whole ones one after the other.
    ///
    /// # Errors
    /// If the slices differ in length or hold no whole number of instances; `models` is untouched.
    #[inline]
    pub fn local_to_model<R: Scalar>(
        &self,
        locals: &[DualQuat<R>],
        models: &mut [DualQuat<R>],
    ) -> Result<(), ShapeError> {
        whole_instances("locals", self.joints, locals.len())?;
        same_length("models", models.len(), locals.len())?;
        self.run(self.backend.unwrap_or_default(), Source::Slice(locals), models);
        Ok(())
    }

    /// [`local_to_model`](Self::local_to_model) over the locals themselves.
    ///
    /// # Errors
    /// If the slice holds no whole number of instances; it is untouched then.
    #[inline]
    pub fn local_to_model_in_place<R: Scalar>(
        &self,
        poses: &mut [DualQuat<R>],
    ) -> Result<(), ShapeError> {
        whole_instances("poses", self.joints, poses.len())?;
        self.run(self.backend.unwrap_or_default(), Source::Output, poses);
        Ok(())
    }

    /// Lengths have been checked.
    #[inline]
    pub(super) fn run<R: Scalar>(
        &self,
        backend: Backend,
        locals: Source<'_, DualQuat<R>>,
        models: &mut [DualQuat<R>],
    ) {
        match self.order {
            Some(order) => backend.run(Walk { order, locals, models }),
            None if SEGMENTS => self.scan(backend, locals, models),
            None => {}
        }
    }

    /// A chain in segments, instance by instance.
    fn scan<R: Scalar>(
        &self,
        backend: Backend,
        locals: Source<'_, DualQuat<R>>,
        models: &mut [DualQuat<R>],
    ) {
        // A chain of no joints has no instances either.
        let joints = self.joints.max(1);
        for (instance, models) in models.chunks_exact_mut(joints).enumerate() {
            let first = instance * joints;
            backend.scan(locals.part(first..first + joints), models);
        }
    }
}

/// The joints without a parent, which come first, and the others.
pub(super) fn split_roots(order: &[[u32; 2]]) -> (&[[u32; 2]], &[[u32; 2]]) {
    let roots = order.iter().take_while(|[_, parent]| *parent == Hierarchy::ROOT).count();
    order.split_at_checked(roots).unwrap_or_default()
}

/// Whether every joint hangs from the one before it, and the chain is so long that segments are faster.
pub(super) fn is_long_chain(order: &[[u32; 2]]) -> bool {
    SEGMENTS && order.len() >= MIN_CHAIN && is_chain(order) && Backend::best() != Backend::PORTABLE
}

/// Whether every joint hangs from the one before it. The mark of the root is what comes before 0.
pub(super) fn is_chain(order: &[[u32; 2]]) -> bool {
    (0_u32..).zip(order).all(|(joint, &pair)| pair == [joint, joint.wrapping_sub(1)])
}

struct Walk<'p, 's, R> {
    order: Order<'p>,
    locals: Source<'s, DualQuat<R>>,
    models: &'s mut [DualQuat<R>],
}

impl<R: Scalar> Kernel for Walk<'_, '_, R> {
    type Output = ();

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { order, locals, models } = self;
        let joints = order.others.bound();
        let mut models: &mut [[R; 8]] = bytemuck::must_cast_slice_mut(models);
        let mut locals: &[[R; 8]] = match locals {
            Source::Slice(locals) => bytemuck::must_cast_slice(locals),
            Source::Output => &[],
        };
        // An instance of no joints would come again for ever.
        while joints > 0
            && let Some((instance, others)) = models.split_at_mut_checked(joints)
        {
            match locals.split_at_checked(joints) {
                Some((of_instance, rest)) => {
                    for &[root, _] in order.roots {
                        let root = root as usize;
                        if let (Some(local), Some(model)) =
                            (of_instance.get(root), instance.get_mut(root))
                        {
                            *model = *local;
                        }
                    }
                    order.others.run(
                        of_instance,
                        instance,
                        #[cfg_attr(not(opt_level_0), inline(always))]
                        |parent, local| product(level, parent, local),
                    );
                    locals = rest;
                }
                // A root stays as it is.
                None => {
                    order.others.run_in_place(
                        instance,
                        #[cfg_attr(not(opt_level_0), inline(always))]
                        |parent, local| product(level, parent, local),
                    );
                }
            }
            models = others;
        }
    }
}
