//! The instances of one thread, by the loop for their layout.

use super::concatenate::Forward;
use super::locals::Locals;
use super::palette::{Epilogue, Palette};
use super::run::Run;
use super::transposed;
use super::unkept::Unkept;
use crate::backend::Backend;
use crate::palette_entry::PaletteEntry;
use crate::storage::{Element, Layout, Number};

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
        transposed::forward(backend, run, locals, models, &mut epilogue);
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
    if const { transposed::MANY && E::Layout::THINGS == 1 } {
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
