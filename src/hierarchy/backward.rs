//! local(j) = model(parent(j))* · model(j). Children first, so that in place every parent is still
//! a model when its children need it.

use super::locals::motions;
use super::run::Run;
use crate::backend::Kernel;
use crate::batch;
use crate::storage::{Element, Layout, Register, Source, Tile, identity};
use dq8_simd::{Level, MAX_LANES, Records};

pub(super) struct Backward<'r, 's, E: Element<8>> {
    pub(super) run: &'r Run<'r, E>,
    pub(super) models: Source<'s, E>,
    pub(super) locals: &'s mut [E],
}

impl<E: Element<8>> Kernel for Backward<'_, '_, E> {
    type Output = ();
    const WIDE: bool = E::Layout::WIDE;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn run<V: Level>(self, level: V) {
        let Self { run, models, locals } = self;
        let joints = run.parents.len().max(1);
        for (instance, locals) in locals.chunks_exact_mut(joints).enumerate() {
            let first = instance * joints;
            let models = models.part(first..first + joints);
            if E::Layout::transposes::<V>() {
                plain(level, run, models, locals, instance);
            } else {
                block(level, run, models, locals, instance);
            }
        }
    }
}

/// Lanes are instances, or there is one.
#[cfg_attr(not(opt_level_0), inline(always))]
fn block<E: Element<8>, V: Level>(
    level: V,
    run: &Run<'_, E>,
    models: Source<'_, E>,
    locals: &mut [E],
    instance: usize,
) {
    for joint in run.joints.clone().rev() {
        for register in 0..E::Layout::registers::<V>() {
            let tile = Tile::at(joint, register);
            let models = models.or(locals);
            let Some(&parent) = run.parents.get(joint) else { return };
            let Some(mut local) = motions(level, models, tile) else { return };
            // ROOT is beyond the last joint: there is no such model.
            let parent = motions(level, models, Tile::at(parent as usize, register));
            let parent = match parent {
                Some(parent) => Some(parent),
                None => run.root.load(level, instance, register),
            };
            if let Some(parent) = parent {
                local = parent.conjugate() * local;
            }
            E::store(local.to_array(), locals, tile);
        }
    }
}

/// Lanes are joints of one instance, their parents gathered one by one.
#[cfg_attr(not(opt_level_0), inline(always))]
fn plain<E: Element<8>, V: Level>(
    level: V,
    run: &Run<'_, E>,
    models: Source<'_, E>,
    locals: &mut [E],
    instance: usize,
) {
    let root = run.root_of(instance);
    let lanes = E::Layout::records::<V>();
    let nothing = root.unwrap_or(identity());
    // One array of both: of two that begin alike, the compiler would copy one from the other by a
    // call.
    let mut both = [nothing; 2 * MAX_LANES];
    let (own, parents) = both.split_at_mut(MAX_LANES);
    let mut end = run.joints.end;
    while end > run.joints.start {
        let start = end.saturating_sub(lanes).max(run.joints.start);
        // Both are copied before anything is written: a parent may be among these joints.
        let Some(from) = E::plain(models.or(locals)) else { return };
        for (joint, (own, parent)) in (start..end).zip(own.iter_mut().zip(&mut *parents)) {
            let (Some(model), Some(&of)) = (from.get(joint), run.parents.get(joint)) else {
                return;
            };
            *own = *model;
            *parent = *from.get(of as usize).unwrap_or(&nothing);
        }
        let model = batch::DualQuat::<Register<E, V, 8>>::load_records(level, own);
        let parent = batch::DualQuat::load_records(level, parents);
        let local = (parent.conjugate() * model).to_array();
        Register::<E, V, 8>::store_records(local, own);
        let Some(locals) = E::plain_mut(locals) else { return };
        for (local, own) in locals.get_mut(start..end).unwrap_or_default().iter_mut().zip(&*own) {
            *local = *own;
        }
        end = start;
    }
}
