//! The instances of a run, by the loop for their layout, on one thread or on several.

use super::blocks::Forward;
use super::locals::Locals;
use super::plain::{self, Unkept};
use super::run::{Epilogue, Palette, Run};
use crate::backend::Backend;
use crate::storage::{Element, Layout, Number, PaletteEntry};

/// Models, and what the epilogue makes of them.
#[inline]
pub(super) fn forward<E: Element<8>, L: Locals<E>, X: Epilogue<E>>(
    backend: Backend,
    run: &Run<'_, E>,
    locals: L,
    models: &mut [E],
    mut epilogue: X,
) {
    // Decided before there is code of the other loops: half of what a program would compile.
    if const { E::Layout::THINGS > 1 } {
        backend.run(Forward { run, locals, models, epilogue });
    } else {
        plain::forward(backend, run, locals, models, &mut epilogue);
    }
}

/// A palette whose models go through `scratch`.
pub(super) fn palette<E: Element<8>, L: Locals<E>, M, const C: usize>(
    backend: Backend,
    run: &Run<'_, E>,
    locals: L,
    scratch: &mut [E],
    palette: Palette<'_, Number<E, 8>, M, C>,
) where
    M: PaletteEntry<C, Layout = E::Layout>,
{
    let Palette { inverse_binds, order, entries: palette } = palette;
    let joints = run.parents.len();
    let mut done = 0;
    if const { plain::MANY && E::Layout::THINGS == 1 } {
        let instances = palette.len() / joints.max(1);
        let epilogue = Palette { inverse_binds, order, entries: &mut *palette };
        done = joints * backend.run(Unkept { run, locals, instances, scratch, epilogue });
    }
    let rest = palette.get_mut(done..).unwrap_or_default();
    for entries in rest.chunks_mut(scratch.len().max(1)) {
        let instances = done / joints.max(1)..(done + entries.len()) / joints.max(1);
        let models = scratch.get_mut(..entries.len()).unwrap_or_default();
        done += models.len();
        let (run, locals) = (run.part(instances.clone()), locals.part(joints, instances));
        forward(backend, &run, locals, models, Palette { inverse_binds, order, entries });
    }
}

/// Whole instances to each task, on several threads.
#[cfg(feature = "rayon")]
pub(super) mod parallel {
    use super::super::backward::{Backward, Write};
    use super::super::forward;
    use super::super::run::grain;
    use super::{Backend, Element, Epilogue, Layout, Locals, Number, Palette, PaletteEntry, Run};
    use crate::backend::Outputs;
    use crate::storage::Source;

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

    pub(in super::super) fn forward<E: Element<8>, L: Locals<E>, X: Epilogue<E>>(
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

    pub(in super::super) fn backward<E: Element<8>>(
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

    pub(in super::super) fn write<E: Element<8>, L: Locals<E>>(
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
            let (scratch, other) =
                self.scratch.split_at_mut(owned * at / self.instances * self.joints);
            let of = |palette, instances, scratch| Self {
                palette,
                instances,
                joints: self.joints,
                scratch,
            };
            (of(palette, at, scratch), of(rest, self.instances - at, other))
        }
    }

    /// Each task has its part of `scratch`, so there are no more tasks than that serves well.
    pub(in super::super) fn palette<E: Element<8>, L: Locals<E>, M, const C: usize>(
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
}
