//! [`HierarchyPlan`]: how to compute one instance, found once and owned.

use super::Hierarchy;
use super::borrowed_plan::{BorrowedPlan, Order, SEGMENTS, is_chain, is_long_chain, split_roots};
use super::schedule::{PlanScratch, schedule};
use crate::dispatch::Backend;
use crate::real::Scalar;
use crate::scalar::DualQuat;
use crate::shape::ShapeError;
use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use dq8_simd::CheckedSchedule;

/// How to compute one instance of a hierarchy, found once.
///
/// [`Hierarchy`] fills its lanes with many instances. In a single instance joints wait for their parents, so the order
/// decides how much of the time something can be computed, and the best order depends on the parents alone. A plan
/// finds it once, and serves any number of poses. It computes
///
/// model(j) = model(parent(j)) · local(j)
///
/// as [`Hierarchy::local_to_model`] does, of plain slices in the joints' own order. Products and
/// their order are the same for a tree, so results differ by rounding only; of a long chain see
/// [`Backend::chain_products`].
///
/// Several instances are computed one after the other: for crowds, [`Block`] is faster. Motions that begin at a multiple of 32 bytes (`f32`) do not cross cache lines and take
/// about 5 % less time than others.
///
/// [`Block`]: crate::storage::Block
///
/// ```
/// use dq8::{DualQuat, Hierarchy, hierarchy::HierarchyPlan};
/// let parents = [Hierarchy::ROOT, 0, 1, 0];
/// let plan = HierarchyPlan::new(&Hierarchy::new(&parents)?);
/// let locals = [DualQuat::from_translation([0.0_f32, 2.0, 0.0]); 4];
/// let mut models = locals;
/// plan.local_to_model(&locals, &mut models)?;
/// assert_eq!(models[2].translation(), [0.0, 6.0, 0.0]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct HierarchyPlan {
    joints: usize,
    /// Joints without a parent, which come first.
    roots: Box<[[u32; 2]]>,
    /// The others, each with its parent. `None` for a chain in segments.
    others: Option<CheckedSchedule<Box<[[u32; 2]]>>>,
    backend: Option<Backend>,
}

/// How a [`HierarchyPlan`] uses lanes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Strategy {
    /// Joints one by one, the eight components of a motion in the lanes of one register, in an order
    /// in which few wait for their parents.
    Ordered,
    /// The hierarchy is one chain, and lanes are its segments: [`Backend::chain_products`].
    Chain,
}

impl HierarchyPlan {
    /// The plan with the strategy that measured best: [`Strategy::Chain`] for chains of 24 joints or
    /// more where there are instructions for it, [`Strategy::Ordered`] otherwise.
    ///
    /// # Panics
    /// If the memory cannot be allocated, as for any `Vec`.
    #[must_use]
    pub fn new(hierarchy: &Hierarchy<'_>) -> Self {
        let order = order(hierarchy);
        if is_long_chain(&order) { Self::in_segments(hierarchy) } else { Self::ordered(&order) }
    }

    /// The plan with this strategy: to measure it. `None` if the strategy needs a chain and the
    /// hierarchy is not one, or the target never has lanes for its segments.
    #[must_use]
    pub fn with_strategy(hierarchy: &Hierarchy<'_>, strategy: Strategy) -> Option<Self> {
        let order = order(hierarchy);
        match strategy {
            Strategy::Ordered => Some(Self::ordered(&order)),
            Strategy::Chain => (SEGMENTS && is_chain(&order)).then(|| Self::in_segments(hierarchy)),
        }
    }

    fn ordered(order: &[[u32; 2]]) -> Self {
        let (roots, others) = split_roots(order);
        let others = CheckedSchedule::new(others.into(), order.len());
        let others = others.expect("a hierarchy's parents are among its joints");
        Self { joints: order.len(), roots: roots.into(), others: Some(others), backend: None }
    }

    fn in_segments(hierarchy: &Hierarchy<'_>) -> Self {
        Self { joints: hierarchy.joints(), roots: Box::default(), others: None, backend: None }
    }

    /// The same plan, borrowed.
    #[inline]
    #[must_use]
    pub fn borrowed(&self) -> BorrowedPlan<'_> {
        let others = self.others.as_ref();
        let order = others.map(|others| Order { roots: &self.roots, others: others.borrowed() });
        let plan = BorrowedPlan::of(self.joints, order);
        self.backend.map_or(plan, |backend| plan.backend(backend))
    }

    /// How many joints there are.
    #[must_use]
    pub const fn joints(&self) -> usize {
        self.joints
    }

    /// How lanes are used.
    #[must_use]
    pub const fn strategy(&self) -> Strategy {
        match self.others {
            Some(_) => Strategy::Ordered,
            None => Strategy::Chain,
        }
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
        self.borrowed().local_to_model(locals, models)
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
        self.borrowed().local_to_model_in_place(poses)
    }
}

/// The joints in the order of computing, each with its parent.
fn order(hierarchy: &Hierarchy<'_>) -> Vec<[u32; 2]> {
    let mut order = vec![[0; 2]; hierarchy.joints()];
    let mut scratch = vec![PlanScratch::default(); hierarchy.joints()];
    schedule(hierarchy, &mut order, &mut scratch);
    order
}
