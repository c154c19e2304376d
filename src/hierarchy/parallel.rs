//! Whole instances to each task, on several threads (feature `rayon`).

use super::backward::Backward;
use super::forward;
use super::locals::Locals;
use super::palette::{Epilogue, Palette};
use super::run::{Run, grain};
use super::write::Write;
use crate::backend::Backend;
use crate::backend::Outputs;
use crate::palette_entry::PaletteEntry;
use crate::storage::{Element, Layout, Number, Source};

/// Models of whole instances, and what is computed from them.
struct Models<'s, E, X> {
    models: &'s mut [E],
    joints: usize,
    epilogue: X,
}

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

pub(super) fn forward<E: Element<8>, L: Locals<E>, X: Epilogue<E>>(
    backend: Backend,
    run: &Run<'_, E>,
    locals: L,
    models: &mut [E],
    epilogue: X,
) {
    let joints = run.parents.len();
    let all = Models { models, joints, epilogue };
    backend.share(grain(joints), all, &|first, Models { models, epilogue, .. }| {
        let instances = first..first + models.len() / joints;
        let (run, locals) = (run.part(instances.clone()), locals.part(joints, instances));
        forward::forward(backend, &run, locals, models, epilogue);
    });
}

pub(super) fn backward<E: Element<8>>(
    backend: Backend,
    run: &Run<'_, E>,
    models: Source<'_, E>,
    locals: &mut [E],
) {
    let joints = run.parents.len();
    backend.share(grain(joints), (locals, joints), &|first, (locals, _): (&mut [E], usize)| {
        let instances = first..first + locals.len() / joints;
        let models = models.part(instances.start * joints..instances.end * joints);
        backend.run(Backward { run: &run.part(instances), models, locals });
    });
}

pub(super) fn write<E: Element<8>, L: Locals<E>>(
    backend: Backend,
    run: &Run<'_, E>,
    locals: L,
    poses: &mut [E],
) {
    let joints = run.parents.len();
    backend.share(grain(joints), (poses, joints), &|first, (poses, _): (&mut [E], usize)| {
        let instances = first..first + poses.len() / joints;
        let locals = locals.part(joints, instances.clone());
        backend.run(Write { run: &run.part(instances), locals, poses });
    });
}

/// A palette, and the scratch memory that its models go through.
struct Entries<'s, E, X> {
    palette: X,
    instances: usize,
    joints: usize,
    scratch: &'s mut [E],
}

impl<E: Element<8>, X: Epilogue<E>> Outputs for Entries<'_, E, X> {
    fn things(&self) -> usize {
        self.instances
    }
    fn split(self, at: usize) -> (Self, Self) {
        let (palette, rest) = self.palette.split(at * self.joints);
        // Memory in proportion, whole instances of it.
        let owned = self.scratch.len() / self.joints;
        let (scratch, other) = self.scratch.split_at_mut(owned * at / self.instances * self.joints);
        let of =
            |palette, instances, scratch| Self { palette, instances, joints: self.joints, scratch };
        (of(palette, at, scratch), of(rest, self.instances - at, other))
    }
}

/// Each task has its part of `scratch`, so there are no more tasks than that serves well.
pub(super) fn palette<E: Element<8>, L: Locals<E>, M, const C: usize>(
    backend: Backend,
    run: &Run<'_, E>,
    locals: L,
    scratch: &mut [E],
    palette: Palette<'_, Number<E, 8>, M, C>,
) where
    M: PaletteEntry<C, Layout = E::Layout>,
{
    let joints = run.parents.len();
    let instances = palette.entries.len() / joints;
    let tasks =
        scratch.len() / joints / if E::Layout::THINGS == 1 { dq8_simd::MAX_LANES } else { 1 };
    let threads = backend.threads.get().min(rayon::current_num_threads()).min(tasks.max(1));
    let grain = instances.div_ceil(threads).max(grain(joints));
    let all = Entries { palette, instances, joints, scratch };
    backend.share(grain, all, &|first, Entries { palette, instances, scratch, .. }| {
        let instances = first..first + instances;
        let (run, locals) = (run.part(instances.clone()), locals.part(joints, instances));
        forward::palette(backend, &run, locals, scratch, palette);
    });
}
