//! [`Plan`]: the order in which one instance is computed, in memory of the caller's.

use super::Hierarchy;
use super::product::product;
use super::schedule::{PlanScratch, schedule};
use crate::backend::{Backend, Kernel};
use crate::brief::brief;
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::Source;
use crate::storage::shape::{ShapeError, same_length};
use dq8_simd::Level;
use dq8_simd::internal::CheckedSchedule;

/// From this many joints on, a chain is cut into segments: on every target, because that decides
/// the order of products. (Nanoseconds per joint, AVX-512, of 16, 24 and 32 joints: one by one 4.9,
/// 5.6, 6.0; in segments 6.7, 5.3, 4.7. Without AVX2 segments never win.)
const MIN_CHAIN: usize = 24;

/// The order in which one instance of a hierarchy is computed, found once, in memory of the
/// caller's: what a [`Skeleton`](super::Skeleton) keeps for itself, for those without a heap.
///
/// A [`Hierarchy`] fills its lanes with many instances. In a single one joints wait for their
/// parents, so the order decides how much of the time something can be computed, and the best order
/// depends on the parents alone. A [`Job`](super::Job) takes it for one whole instance in a plain
/// slice, with any form of locals, root and palette, and leaves it alone otherwise. Products are
/// the same as without a plan, in the same order, but for chains of 24 joints and more, whose
/// results differ in the last bits: see [`Backend::chain_products`].
///
/// ```
/// use dq8::{DualQuat, Hierarchy, hierarchy::{Plan, PlanScratch}};
/// let parents = [Hierarchy::ROOT, 0, 1, 0];
/// let leg = Hierarchy::new(&parents)?;
/// let mut order = [[0; 2]; 4];
/// let mut scratch = [PlanScratch::default(); 4]; // no longer needed when the plan is found
/// let plan = Plan::new(&leg, &mut order, &mut scratch)?;
/// let locals = [DualQuat::from_translation([0.0_f32, 2.0, 0.0]); 4];
/// let mut models = locals;
/// leg.job().plan(&plan).local_to_model(&locals, &mut models)?;
/// assert_eq!(models[2].translation(), [0.0, 6.0, 0.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct Plan<'a> {
    pub(super) parents: &'a [u32],
    /// `None` for a chain in segments.
    pub(super) order: Option<Order<'a>>,
}

brief!([] Plan<'_>: Plan |it| { joints: it.parents.len() });

/// A [`Job`](super::Job) without a plan: whoever has no memory for one links no code of plans.
#[derive(Clone, Copy, Debug)]
pub struct NoPlan;

/// What a job knows of the order in which one instance is computed: a [`Plan`], or
/// [nothing](NoPlan). Sealed.
pub trait Plans: sealed::Sealed {
    #[doc(hidden)]
    fn plan(&self) -> Option<Plan<'_>>;
}

impl Plans for NoPlan {
    fn plan(&self) -> Option<Plan<'_>> {
        None
    }
}

impl Plans for Plan<'_> {
    fn plan(&self) -> Option<Plan<'_>> {
        Some(*self)
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::NoPlan {}
    impl Sealed for super::Plan<'_> {}
}

/// The joints of one instance in the order of computing, each with its parent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Order<'a> {
    /// Joints without a parent, which come first.
    pub(super) roots: &'a [[u32; 2]],
    pub(super) others: CheckedSchedule<&'a [[u32; 2]]>,
}

impl<'a> Plan<'a> {
    /// Writes the order into `order`, and borrows it. `order` and `scratch` have an element per
    /// joint.
    ///
    /// # Errors
    /// If one of them is of another length; both are untouched.
    pub fn new(
        hierarchy: &Hierarchy<'a>,
        order: &'a mut [[u32; 2]],
        scratch: &mut [PlanScratch],
    ) -> Result<Self, ShapeError> {
        let joints = hierarchy.joints();
        same_length("order", order.len(), joints)?;
        same_length("scratch", scratch.len(), joints)?;
        schedule(hierarchy, order, scratch);
        Self::of_order(hierarchy, order)
    }

    /// The plan of an order that [`new`](Self::new) wrote for the same parents: to keep an order
    /// where a plan cannot borrow it, such as a constant in flash.
    ///
    /// What has no memory of its own cannot see all that may be wrong: an order in which joints
    /// have changed places, or one stands for another, is taken, and models are then wrong.
    ///
    /// # Errors
    /// If there are not as many pairs as joints, or a pair is not a joint and its parent, or a root
    /// comes after a joint that has a parent.
    pub fn of_order(hierarchy: &Hierarchy<'a>, order: &'a [[u32; 2]]) -> Result<Self, ShapeError> {
        let parents = hierarchy.parents();
        same_length("order", order.len(), parents.len())?;
        let (roots, others) = split_roots(order);
        let is_pair = |[joint, parent]: &[u32; 2]| parents.get(*joint as usize) == Some(parent);
        if let Some(place) = order.iter().position(|pair| !is_pair(pair)) {
            return Err(ShapeError::NotOrder { place });
        }
        if is_long_chain(order) {
            return Ok(Self { parents, order: None });
        }
        // Checked once, here, so that the loop over the others has no bounds to check.
        let others = CheckedSchedule::new(others, order.len());
        let others = others.ok_or(ShapeError::NotOrder { place: roots.len() })?;
        Ok(Self { parents, order: Some(Order { roots, others }) })
    }

    /// The models of one instance. Lengths have been checked.
    #[inline]
    pub(super) fn run<R: Scalar>(
        &self,
        backend: Backend,
        locals: Source<'_, DualQuat<R>>,
        models: &mut [DualQuat<R>],
    ) {
        match self.order {
            Some(order) => backend.run(Walk { order, locals, models }),
            None => backend.scan(locals, models),
        }
    }
}

/// The joints without a parent, which come first, and the others.
pub(super) fn split_roots(order: &[[u32; 2]]) -> (&[[u32; 2]], &[[u32; 2]]) {
    let roots = order.iter().take_while(|[_, parent]| *parent == Hierarchy::ROOT).count();
    order.split_at_checked(roots).unwrap_or_default()
}

/// Whether every joint hangs from the one before it, and the chain is long.
pub(super) fn is_long_chain(order: &[[u32; 2]]) -> bool {
    // The mark of the root is what comes before 0.
    let links = |(joint, &pair): (u32, &[u32; 2])| pair == [joint, joint.wrapping_sub(1)];
    order.len() >= MIN_CHAIN && (0..).zip(order).all(links)
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
        let models: &mut [[R; 8]] = bytemuck::must_cast_slice_mut(models);
        match locals {
            Source::Slice(locals) => {
                let locals: &[[R; 8]] = bytemuck::must_cast_slice(locals);
                for &[root, _] in order.roots {
                    let root = root as usize;
                    if let (Some(local), Some(model)) = (locals.get(root), models.get_mut(root)) {
                        *model = *local;
                    }
                }
                order.others.run(
                    locals,
                    models,
                    #[cfg_attr(not(opt_level_0), inline(always))]
                    |parent, local| product(level, parent, local),
                );
            }
            // A root stays as it is.
            Source::Output => {
                order.others.run_in_place(
                    models,
                    #[cfg_attr(not(opt_level_0), inline(always))]
                    |parent, local| product(level, parent, local),
                );
            }
        }
    }
}
