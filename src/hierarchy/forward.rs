//! The computation of the models of whole instances: the choice of the loop for their layout, and
//! of the threads that run it.

use super::blocks::Blocks;
use super::locals::Locals;
use super::plain::{MANY, PaletteInstances};
use super::plan::Plans;
#[cfg(feature = "rayon")]
use super::run::grain;
use super::run::{Epilogue, Forward, PaletteOnly};
#[cfg(feature = "rayon")]
use crate::backend::Outputs;
use crate::storage::{Element, Layout};

impl<E: Element<8>, L: Locals<E>, X: Epilogue<E>> Forward<'_, '_, E, L, X> {
    /// Computes the models. If `plan` has an order and the run has one whole instance, it computes
    /// them in this order.
    #[inline]
    pub(super) fn run<P: Plans>(self, plan: &P) {
        match plan.plan() {
            Some(plan) if self.is_one_instance() => self.in_order_of(plan),
            #[cfg(feature = "rayon")]
            _ if self.run.many() => self.on_threads(),
            _ => self.on_this_thread(),
        }
    }

    #[inline]
    fn on_this_thread(self) {
        // The condition is a constant, so only the loops for the layout `E::Layout` are compiled.
        // That is half of the code.
        if const { E::Layout::THINGS > 1 } {
            self.run.backend.run(Blocks(self));
        } else {
            self.plain();
        }
    }

    #[cfg(feature = "rayon")]
    fn on_threads(self) {
        let Self { run, locals, models, epilogue } = self;
        let joints = run.parents.len();
        let all = Models { models, joints, epilogue };
        run.backend.share(grain(joints), all, &|first, Models { models, epilogue, .. }| {
            let instances = first..first + models.len() / joints;
            let (run, locals) = (&run.part(instances.clone()), locals.part(joints, instances));
            Forward { run, locals, models, epilogue }.on_this_thread();
        });
    }
}

impl<E: Element<8>, L: Locals<E>, X: Epilogue<E>> PaletteOnly<'_, '_, E, L, X> {
    /// Computes the palette.
    pub(super) fn run(self) {
        #[cfg(feature = "rayon")]
        if self.run.many() {
            return self.on_threads();
        }
        self.on_this_thread();
    }

    fn on_this_thread(mut self) {
        let backend = self.run.backend;
        let mut done = 0;
        if const { MANY && E::Layout::THINGS == 1 } {
            done = backend.run(PaletteInstances(&mut self));
        }
        let Self { run, locals, instances, scratch, epilogue } = self;
        let joints = run.parents.len();
        let most = scratch.len().checked_div(joints).unwrap_or(0).max(1);
        let (_, mut rest) = epilogue.split(done * joints);
        while done < instances {
            let count = most.min(instances - done);
            let (epilogue, after) = rest.split(count * joints);
            rest = after;
            let range = done..done + count;
            done += count;
            let (run, locals) = (&run.part(range.clone()), locals.part(joints, range));
            let models = scratch.get_mut(..count * joints).unwrap_or_default();
            Forward { run, locals, models, epilogue }.on_this_thread();
        }
    }

    /// Computes the palette of all instances. Each task gets a part of `scratch` that holds the
    /// models of at least one group of instances. So the size of `scratch` limits the number of
    /// tasks.
    #[cfg(feature = "rayon")]
    fn on_threads(self) {
        let Self { run, locals, instances, scratch, epilogue } = self;
        let joints = run.parents.len();
        let group = if E::Layout::THINGS == 1 { dq8_simd::MAX_LANES } else { 1 };
        let tasks = (scratch.len() / joints / group).max(1);
        let threads = run.backend.threads.get().min(rayon::current_num_threads()).min(tasks);
        let grain = instances.div_ceil(threads).max(grain(joints));
        let all = Entries { epilogue, instances, joints, scratch };
        run.backend.share(grain, all, &|first, Entries { epilogue, instances, scratch, .. }| {
            let range = first..first + instances;
            let (run, locals) = (&run.part(range.clone()), locals.part(joints, range));
            PaletteOnly { run, locals, instances, scratch, epilogue }.on_this_thread();
        });
    }
}

/// The models of whole instances, and the epilogue that computes an output, such as a palette, from
/// them.
#[cfg(feature = "rayon")]
struct Models<'s, E, X> {
    models: &'s mut [E],
    joints: usize,
    epilogue: X,
}

#[cfg(feature = "rayon")]
impl<E: Element<8>, X: Epilogue<E>> Outputs for Models<'_, E, X> {
    fn things(&self) -> usize {
        self.models.len() / self.joints
    }
    fn split(self, at: usize) -> (Self, Self) {
        let at = (at * self.joints).min(self.models.len());
        let (begin, end) = self.models.split_at_mut(at);
        let (first, second) = self.epilogue.split(at);
        let of = |models, epilogue| Self { models, joints: self.joints, epilogue };
        (of(begin, first), of(end, second))
    }
}

/// A palette, and the scratch memory for the models from which its entries are computed.
#[cfg(feature = "rayon")]
struct Entries<'s, E, X> {
    epilogue: X,
    instances: usize,
    joints: usize,
    scratch: &'s mut [E],
}

#[cfg(feature = "rayon")]
impl<E: Element<8>, X: Epilogue<E>> Outputs for Entries<'_, E, X> {
    fn things(&self) -> usize {
        self.instances
    }
    fn split(self, at: usize) -> (Self, Self) {
        let (epilogue, rest) = self.epilogue.split(at * self.joints);
        // Each half has scratch memory for whole instances, in proportion to its number of
        // instances.
        let owned = self.scratch.len() / self.joints;
        let (scratch, other) = self.scratch.split_at_mut(owned * at / self.instances * self.joints);
        let of = |epilogue, instances, scratch| Self {
            epilogue,
            instances,
            joints: self.joints,
            scratch,
        };
        (of(epilogue, at, scratch), of(rest, self.instances - at, other))
    }
}
