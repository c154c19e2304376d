//! [`Plan`]: the order in which one instance is computed, in memory of the caller's; the loop in
//! that order, with any form of locals, a root and a palette; and the search for the order.

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

/// The number of joints from which a chain is cut into segments: on every target, because that
/// decides the order of products. (Nanoseconds per joint, AVX-512, of 16, 24 and 32 joints: one by
/// one 4.9, 5.6, 6.0; in segments 6.7, 5.3, 4.7. Without AVX2 segments never win.)
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

/// A [`Job`](super::Job) without a plan. A program that has no memory for plans links no code of
/// them.
#[derive(Clone, Copy, Debug)]
pub struct NoPlan;

/// The order in which a job computes one instance: that of a [`Plan`], or [the order of
/// joints](NoPlan). Sealed.
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
    /// Without memory of its own this cannot see all that may be wrong: an order in which joints
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
            Some(order) => backend.run(InOrder { order, locals, models }),
            None => backend.scan(locals, models),
        }
    }
}

/// The joints without a parent, which come first, and the others.
pub(super) fn split_roots(order: &[[u32; 2]]) -> (&[[u32; 2]], &[[u32; 2]]) {
    let roots = order.iter().take_while(|[_, parent]| *parent == Hierarchy::ROOT).count();
    order.split_at_checked(roots).unwrap_or_default()
}

/// `true` if every joint hangs from the one before it, and the chain is long.
pub(super) fn is_long_chain(order: &[[u32; 2]]) -> bool {
    // `ROOT` is 0 − 1.
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

impl<E: Element<8>, L: Locals<E>, X: Epilogue<E>> Forward<'_, '_, E, L, X> {
    /// `true` if a plan can order this: one whole instance of single things, nothing normalized on
    /// the way.
    #[inline]
    pub(super) fn is_one_instance(&self) -> bool {
        let joints = self.models.len();
        E::Layout::THINGS == 1
            && joints == self.run.parents.len()
            && self.run.joints == (0..joints)
            && self.run.renormalize == Renormalize::Never
    }

    /// Stores the locals as motions in place of the models, multiplies roots onto their base, then
    /// each joint onto its parent in the order of the plan, and runs the epilogue. The product is
    /// that of all other runs, so a tree has the same bits.
    #[inline]
    pub(super) fn in_order_of(self, plan: Plan<'_>) {
        let Self { run, locals, models, mut epilogue } = self;
        let (backend, root) = (run.backend, run.root_of(0));
        // Motions that lie in memory are read where they are. All else, and roots that stand on
        // something, is written to the models first and multiplied in place: the plan knows one
        // form only.
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

/// The loop that writes the locals, those of roots multiplied onto `root`.
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
        // What lies there already stays.
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
        // Then a root is the root transform times its local, and the plan needs none.
        let (Some(root), Some(models)) = (root, E::plain_mut(models)) else { return };
        for (model, &parent) in models.iter_mut().zip(run.parents) {
            if parent == super::Hierarchy::ROOT {
                *model = product(level, &root, model);
            }
        }
    }
}

/// The loop that runs the epilogue of all joints.
struct End<'s, E, X> {
    models: &'s [E],
    epilogue: &'s mut X,
}

impl<E: Element<8>, X: Epilogue<E>> Kernel for End<'_, E, X> {
    type Output = ();
    const WIDE: bool = E::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        // After all models, in their own order: the plan's order is not one that lanes could take
        // together.
        let Self { models, epilogue } = self;
        for start in (0..models.len()).step_by(E::Layout::records::<V>()) {
            let slot = JointSlot::of_joints(start, 0, models.len(), models.len());
            let Some(lanes) = motions(level, models, slot.own_tile()) else { return };
            epilogue.run(level, slot, lanes);
        }
    }
}

/// The number of other products that begin between that of a parent and that of its child. A
/// product of a plan takes about four times as long as until the next one can begin.
///
/// Measured on skeletons of 21 and 64 joints, with other values here, by
/// `cargo bench --bench hierarchy -- one-instance`: 3 to 6 are the same within a few hundredths,
/// plain level order takes a twentieth longer, depth first half as long again.
const BETWEEN: u32 = 4;

/// The end of a list of children.
const NONE: u32 = Hierarchy::ROOT;

/// The facts about one joint, and one place in each of two queues, while an order is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct PlanScratch {
    /// The longest way from the joint down.
    height: u32,
    /// A list of its children, in their order.
    first_child: u32,
    next_sibling: u32,
    /// Place in a binary heap of joints whose parents are done: the one to begin first is on top.
    ready: u32,
    /// Place in a queue of joints whose parents have begun, each with the time from which it may.
    pending: u32,
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

/// Writes the joints of a hierarchy into `order`, each with its parent: first those that have none,
/// and then the others, as they should be computed. Both slices have an element per joint.
///
/// Among joints whose parents are done, the one with the longest way down comes first: it decides
/// how long the whole takes. The others fill the time in which it waits for its parent.
///
/// This is list scheduling by the critical path, for one unit that begins a product per time step
/// and returns it [`BETWEEN`] steps later:
///
/// ```text
/// ready = roots
/// at each time step:
///     ready += those of `pending` whose time has come
///     begin the joint of `ready` with the greatest height (the first, among equals)
///     pending += its children, BETWEEN steps from now
/// ```
///
/// Times only rise, so `pending` is a queue and needs no sorting; a step with nothing to begin is
/// skipped. All memory is the caller's, so that a microcontroller can have plans; nothing here can
/// panic.
pub(super) fn schedule(
    hierarchy: &Hierarchy<'_>,
    order: &mut [[u32; 2]],
    scratch: &mut [PlanScratch],
) {
    scratch.fill(PlanScratch::default());
    let mut search = Search { of: scratch, ready: 0, begin: 0, end: 0 };
    let mut roots = 0;
    // Parents come before their children, so one sweep from the last joint finds all heights.
    for (joint, &parent) in hierarchy.parents().iter().enumerate().rev() {
        // Each goes to the front of its parent's list, so going backwards leaves the children in
        // their order. A root's parent is no place in memory, and `change` does nothing there.
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
    // Each joint is pushed once and popped once: as a root above, or when the time of its parent's
    // product has come.
    while search.ready > 0 || search.begin < search.end {
        if search.ready == 0 {
            // All there is waits for its parent.
            time = time.max(search.at(search.begin).ready_at);
        }
        while search.begin < search.end && search.at(search.begin).ready_at <= time {
            search.push(search.at(search.begin).pending);
            search.begin += 1;
        }
        let joint = search.pop();
        // Its children may begin when its product is done.
        let mut child = search.at(joint as usize).first_child;
        while child != NONE {
            let ready_at = time.saturating_add(BETWEEN);
            search.change(search.end, |of| (of.pending, of.ready_at) = (child, ready_at));
            search.end += 1;
            child = search.at(child as usize).next_sibling;
        }
        let parent = hierarchy.parents().get(joint as usize).copied().unwrap_or(NONE);
        // Roots have no product and are copied before everything else, whatever their turn was.
        let place = if parent == NONE { to_roots.next() } else { to_others.next() };
        if let Some(place) = place {
            *place = [joint, parent];
        }
        time = time.saturating_add(1);
    }
}

/// The state of [`schedule`], and its two queues.
struct Search<'s> {
    of: &'s mut [PlanScratch],
    /// The number in the heap.
    ready: usize,
    /// The begin and the end of the queue. Each joint is in it once, so it never begins again at 0.
    begin: usize,
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

    /// `true` if the joint at `a` of the heap begins before that at `b`.
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
        // At the end of the heap, then up past every joint that begins later.
        let mut at = self.ready;
        self.change(at, |last| last.ready = joint);
        self.ready += 1;
        while at > 0 && self.before(at, (at - 1) / 2) {
            self.swap(at, (at - 1) / 2);
            at = (at - 1) / 2;
        }
    }

    fn pop(&mut self) -> u32 {
        // The last joint takes the place of the first, then sinks below every one that begins
        // sooner.
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
