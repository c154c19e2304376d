//! [`Plan`]: the order in which the joints of one instance are computed, in the caller's memory;
//! the loop in this order, for any form of locals, with a root and a palette; and the search for
//! the order.

use super::Hierarchy;
use super::chain::product;
use super::locals::{Locals, Pass};
use super::run::{Epilogue, Forward, JointSlot, Renormalize, Run};
use crate::backend::{Backend, Kernel};
use crate::macros::brief;
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{Element, Layout, Number, Source, motions};
use core::cmp::Reverse;
use dq8_simd::Level;
use dq8_simd::internal::CheckedSchedule;

/// The least number of joints of a chain that is divided into segments. It is the same on every
/// target, because the order of products, and so the bits of the results, depend on it. (With
/// AVX-512, chains of 16, 24 and 32 joints take 4.9, 5.6 and 6.0 nanoseconds per joint one by one,
/// and 6.7, 5.3 and 4.7 in segments. Without AVX2, segments are never faster.)
const MIN_CHAIN: usize = 24;

/// The order in which the joints of one instance are computed, found once and kept in the caller's
/// memory. A [`Skeleton`](super::Skeleton) has its own plan; this type is for programs without a
/// heap.
///
/// A [`Hierarchy`] fills its lanes with many instances. In a single instance a joint waits for its
/// parent's product, and the order decides how much of this time the products of other joints fill.
/// The best order depends on the parents alone. A [`Job`](super::Job) uses its plan for one whole
/// instance in a plain slice, with any form of locals, root and palette, and ignores it otherwise.
/// The model of each joint has the same bits as without a plan. The exceptions are chains of 24
/// joints and more, whose results differ in the last bits: see [`Backend::chain_products`].
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
    /// `None` for a long chain, which is computed in segments.
    pub(super) order: Option<Order<'a>>,
}

brief!([] Plan<'_>: Plan |it| { joints: it.parents.len() });

/// The absence of a plan in a [`Job`](super::Job). A program that uses no plans does not contain
/// their code.
#[derive(Clone, Copy, Debug)]
pub struct NoPlan;

/// The order in which a job computes one instance: the order of a [`Plan`], or with [`NoPlan`] the
/// order of the joint indices. The trait is sealed.
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

/// The joints of one instance in the order in which they are computed, each with its parent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Order<'a> {
    /// The joints without a parent, which come first.
    pub(super) roots: &'a [[u32; 2]],
    pub(super) others: CheckedSchedule<&'a [[u32; 2]]>,
}

impl<'a> Plan<'a> {
    /// Finds the order, writes it into `order`, and borrows it. `order` and `scratch` have one
    /// element for each joint; an element of `order` is a joint and its parent.
    ///
    /// # Errors
    /// If `order` or `scratch` has another length; both are untouched.
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

    /// Makes a plan of an order that [`new`](Self::new) wrote for the same parents. So a program
    /// can keep an order as a constant in flash memory, for example.
    ///
    /// The check has no memory in which to mark joints, so it does not find every fault. It accepts
    /// an order in which a child comes before its parent, or in which a joint is missing and
    /// another occurs twice; models are then wrong.
    ///
    /// # Errors
    /// If the number of pairs differs from that of joints, a pair is not a joint and its parent, or
    /// a root comes after a joint that has a parent.
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
        // The indices are checked once here, so that the loop over `others` has no bounds to check.
        let others = CheckedSchedule::new(others, order.len());
        let others = others.ok_or(ShapeError::NotOrder { place: roots.len() })?;
        Ok(Self { parents, order: Some(Order { roots, others }) })
    }

    /// Computes the models of one instance, whose lengths have been checked.
    #[inline]
    pub(super) fn run<R: Scalar>(
        &self,
        backend: Backend,
        locals: Source<'_, DualQuat<R>>,
        models: &mut [DualQuat<R>],
    ) {
        match self.order {
            Some(order) => backend.run(InOrder { order, locals, models }),
            None => backend.scan(locals, models),
        }
    }
}

/// Splits an order into the joints without a parent, which come first, and the other joints.
pub(super) fn split_roots(order: &[[u32; 2]]) -> (&[[u32; 2]], &[[u32; 2]]) {
    let roots = order.iter().take_while(|[_, parent]| *parent == Hierarchy::ROOT).count();
    order.split_at_checked(roots).unwrap_or_default()
}

/// Returns `true` if every joint is the child of the joint before it and the chain is long enough
/// for segments.
pub(super) fn is_long_chain(order: &[[u32; 2]]) -> bool {
    // Joint 0 satisfies the condition too: the parent of a root is `ROOT`, which is 0 − 1 in
    // wrapping arithmetic.
    let links = |(joint, &pair): (u32, &[u32; 2])| pair == [joint, joint.wrapping_sub(1)];
    order.len() >= MIN_CHAIN && (0..).zip(order).all(links)
}

struct InOrder<'p, 's, R> {
    order: Order<'p>,
    locals: Source<'s, DualQuat<R>>,
    models: &'s mut [DualQuat<R>],
}

impl<R: Scalar> Kernel for InOrder<'_, '_, R> {
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
            // In place, the model of a root is its local, which is already in the output.
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

impl<E: Element<8>, L: Locals<E>, X: Epilogue<E>> Forward<'_, '_, E, L, X> {
    /// `true` if a plan applies to this run: one whole instance in a plain slice, and no model is
    /// normalized.
    #[inline]
    pub(super) fn is_one_instance(&self) -> bool {
        let joints = self.models.len();
        E::Layout::THINGS == 1
            && joints == self.run.parents.len()
            && self.run.joints == (0..joints)
            && self.run.renormalize == Renormalize::Never
    }

    /// Computes the models in the order of the plan. It stores the locals, as motions, in the
    /// memory of the models, multiplies roots onto their base, then multiplies each joint onto its
    /// parent, and runs the epilogue. The product is the same as in all other runs, so the models
    /// of a tree have the same bits.
    #[inline]
    pub(super) fn in_order_of(self, plan: Plan<'_>) {
        let Self { run, locals, models, mut epilogue } = self;
        let (backend, root) = (run.backend, run.root_of(0));
        // The loop of a plan reads motions from a slice or in place, and copies the locals of
        // roots. So if the locals are motions in memory and roots have no base, the loop reads them
        // directly. Otherwise all locals are first written to the models, and the loop works in
        // place.
        let from = match locals.motions() {
            Some(Source::Slice(locals)) if root.is_none() => E::plain(locals),
            _ => {
                backend.run(Begin { run, locals, models: &mut *models, root });
                None
            }
        };
        if let Some(models) = E::plain_mut(models) {
            let models: &mut [DualQuat<Number<E, 8>>] = bytemuck::must_cast_slice_mut(models);
            let source = match from {
                Some(locals) => Source::Slice(bytemuck::must_cast_slice(locals)),
                None => Source::Output,
            };
            plan.run(backend, source, models);
        }
        if const { X::ACTIVE } {
            backend.run(End { models, epilogue: &mut epilogue });
        }
    }
}

/// The loop that writes the locals to the models, and multiplies the locals of root joints onto
/// `root`.
struct Begin<'r, 's, E: Element<8>, L> {
    run: &'r Run<'r, E>,
    locals: L,
    models: &'s mut [E],
    root: Option<[Number<E, 8>; 8]>,
}

impl<E: Element<8>, L: Locals<E>> Kernel for Begin<'_, '_, E, L> {
    type Output = ();
    const WIDE: bool = E::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { run, locals, models, root } = self;
        let joints = run.parents.len();
        // Locals that are already in `models` need no copy.
        if !matches!(locals.motions(), Some(Source::Output)) {
            let pass = Pass { level, run, locals };
            let mut batch = pass.batch();
            for start in (0..joints).step_by(E::Layout::records::<V>()) {
                let slot = JointSlot::of_joints(start, 0, joints, joints);
                if pass.write(&mut batch, models, slot).is_none() {
                    return;
                }
            }
        }
        // Each root is multiplied onto the root transform here, so that the plan needs no root
        // transform.
        let (Some(root), Some(models)) = (root, E::plain_mut(models)) else { return };
        for (model, &parent) in models.iter_mut().zip(run.parents) {
            if parent == super::Hierarchy::ROOT {
                *model = product(level, &root, model);
            }
        }
    }
}

/// The loop that runs the epilogue for all joints.
struct End<'s, E, X> {
    models: &'s [E],
    epilogue: &'s mut X,
}

impl<E: Element<8>, X: Epilogue<E>> Kernel for End<'_, E, X> {
    type Output = ();
    const WIDE: bool = E::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        // The epilogue runs after all models are computed, in the order of joints. Joints that
        // follow each other in the plan do not adjoin in memory, but loads into lanes need joints
        // that do.
        let Self { models, epilogue } = self;
        for start in (0..models.len()).step_by(E::Layout::records::<V>()) {
            let slot = JointSlot::of_joints(start, 0, models.len(), models.len());
            let Some(lanes) = motions(level, models, slot.own_tile()) else { return };
            epilogue.run(level, slot, lanes);
        }
    }
}

/// The number of products of other joints that begin between the product of a parent and the
/// product of its child. A product takes about four times as long as a time step, after which the
/// next independent product can begin.
///
/// Measured by `cargo bench --bench hierarchy -- one-instance` on skeletons of 21 and 64 joints,
/// with other values of this constant: 3 to 6 are the same within a few hundredths. Computing level
/// by level takes a twentieth longer, and depth first takes half as long again.
const BETWEEN: u32 = 4;

/// The value that marks the end of a list of children.
const NONE: u32 = Hierarchy::ROOT;

/// An element of the scratch memory of the search for an order. Its fields belong to several
/// arrays: facts about each joint (`height`, `first_child`, `next_sibling`), a heap (`ready`) and a
/// queue (`pending`, `ready_at`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct PlanScratch {
    /// The number of links from the joint down to its deepest descendant.
    height: u32,
    /// The first child of the joint, or [`NONE`]. The children are a linked list in rising order.
    first_child: u32,
    /// The next child of the joint's parent, or [`NONE`].
    next_sibling: u32,
    /// An element of a binary heap of joints whose parents are done. The joint at the top begins
    /// next.
    ready: u32,
    /// An element of a queue of joints whose parents have begun, but are not done.
    pending: u32,
    /// The time step at which the product of the parent of `pending` is done.
    ready_at: u32,
}

impl Default for PlanScratch {
    fn default() -> Self {
        Self {
            height: 0,
            first_child: NONE,
            next_sibling: NONE,
            ready: NONE,
            pending: NONE,
            ready_at: 0,
        }
    }
}

/// Writes the joints of a hierarchy into `order`, each with its parent: first the joints without a
/// parent, then the other joints in the order in which to compute them. Both slices have one
/// element for each joint.
///
/// Among the joints whose parents are done, the joint with the longest path down to a descendant
/// comes first, because this path decides how long the whole computation takes. The other joints
/// fill the time in which the joints of the path wait.
///
/// This is list scheduling by the critical path, for a unit that begins one product per time step
/// and returns its result [`BETWEEN`] steps later:
///
/// ```text
/// ready = roots
/// at each time step:
///     ready += those of `pending` whose time has come
///     begin the joint of `ready` with the greatest height (the first, among equals)
///     pending += its children, BETWEEN steps from now
/// ```
///
/// Children enter `pending` in the order of their times, so it is a queue that needs no sorting. A
/// time step at which no joint can begin is skipped. All memory is the caller's, so that
/// microcontrollers can have plans; nothing here can panic.
pub(super) fn schedule(
    hierarchy: &Hierarchy<'_>,
    order: &mut [[u32; 2]],
    scratch: &mut [PlanScratch],
) {
    scratch.fill(PlanScratch::default());
    let mut search = Search { of: scratch, ready: 0, begin: 0, end: 0 };
    let mut roots = 0;
    // Parents come before their children, so one pass from the last joint to the first finds all
    // heights.
    for (joint, &parent) in hierarchy.parents().iter().enumerate().rev() {
        // Each joint is inserted at the front of its parent's list. The pass goes from the last
        // joint to the first, so each list is in rising order at the end. The parent of a root is
        // `ROOT`, which is beyond `scratch`: `change` then does nothing.
        let (of, above) = (search.at(joint), search.at(parent as usize));
        search.change(joint, |of| of.next_sibling = above.first_child);
        search.change(parent as usize, |above| {
            above.height = above.height.max(of.height + 1);
            above.first_child = joint as u32;
        });
        if parent == NONE {
            search.push(joint as u32);
            roots += 1;
        }
    }
    let (to_roots, to_others) = order.split_at_mut_checked(roots).unwrap_or_default();
    let (mut to_roots, mut to_others) = (to_roots.iter_mut(), to_others.iter_mut());
    let mut time = 0_u32;
    // Each joint is pushed to the heap once and popped once. Roots were pushed above; any other
    // joint is pushed when the product of its parent is done.
    while search.ready > 0 || search.begin < search.end {
        if search.ready == 0 {
            // All remaining joints wait for their parents, so the time skips to the step at which
            // the first of these parents is done.
            time = time.max(search.at(search.begin).ready_at);
        }
        while search.begin < search.end && search.at(search.begin).ready_at <= time {
            search.push(search.at(search.begin).pending);
            search.begin += 1;
        }
        let joint = search.pop();
        // The children of this joint may begin when its product is done.
        let mut child = search.at(joint as usize).first_child;
        while child != NONE {
            let ready_at = time.saturating_add(BETWEEN);
            search.change(search.end, |of| (of.pending, of.ready_at) = (child, ready_at));
            search.end += 1;
            child = search.at(child as usize).next_sibling;
        }
        let parent = hierarchy.parents().get(joint as usize).copied().unwrap_or(NONE);
        // The models of roots are copies and not products. They come before all products, so roots
        // come first in `order`.
        let place = if parent == NONE { to_roots.next() } else { to_others.next() };
        if let Some(place) = place {
            *place = [joint, parent];
        }
        time = time.saturating_add(1);
    }
}

/// The state of [`schedule`]: the scratch memory with its heap and its queue.
struct Search<'s> {
    of: &'s mut [PlanScratch],
    /// The number of joints in the heap.
    ready: usize,
    /// The index of the queue's first element.
    begin: usize,
    /// The index behind the queue's last element. Each joint enters the queue at most once, so the
    /// queue fits the scratch memory and never wraps around.
    end: usize,
}

impl Search<'_> {
    fn at(&self, index: usize) -> PlanScratch {
        self.of.get(index).copied().unwrap_or_default()
    }

    fn change(&mut self, index: usize, change: impl FnOnce(&mut PlanScratch)) {
        if let Some(of) = self.of.get_mut(index) {
            change(of);
        }
    }

    /// Returns `true` if the joint at index `a` of the heap should begin before the joint at index
    /// `b`.
    fn before(&self, a: usize, b: usize) -> bool {
        let rank = |joint| (self.at(joint as usize).height, Reverse(joint));
        rank(self.at(a).ready) > rank(self.at(b).ready)
    }

    fn swap(&mut self, a: usize, b: usize) {
        let (of_a, of_b) = (self.at(a).ready, self.at(b).ready);
        self.change(a, |at| at.ready = of_b);
        self.change(b, |at| at.ready = of_a);
    }

    fn push(&mut self, joint: u32) {
        // The joint enters at the end of the heap, then rises past every joint that should begin
        // later.
        let mut at = self.ready;
        self.change(at, |last| last.ready = joint);
        self.ready += 1;
        while at > 0 && self.before(at, (at - 1) / 2) {
            self.swap(at, (at - 1) / 2);
            at = (at - 1) / 2;
        }
    }

    fn pop(&mut self) -> u32 {
        // The last joint of the heap replaces the top, then sinks below every joint that should
        // begin sooner.
        let top = self.at(0).ready;
        self.ready = self.ready.saturating_sub(1);
        self.swap(0, self.ready);
        let mut at = 0;
        loop {
            let (left, right) = (2 * at + 1, 2 * at + 2);
            let best = if right < self.ready && self.before(right, left) { right } else { left };
            if best >= self.ready || !self.before(best, at) {
                return top;
            }
            self.swap(at, best);
            at = best;
        }
    }
}
