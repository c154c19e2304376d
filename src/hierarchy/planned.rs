//! One instance in the order of a plan, with every form of locals, a root and a palette.

use super::ahead::Ahead;
use super::locals::{Locals, motions};
use super::palette::Epilogue;
use super::plan::Plan;
use super::product::product;
use super::renormalize::Renormalize;
use super::run::Run;
use super::slot::JointSlot;
use crate::backend::{Backend, Kernel};
use crate::scalar::DualQuat;
use crate::storage::{Element, Layout, Number, Source};
use dq8_simd::Level;

/// `true` if the plan knows this run: one whole instance of single things, nothing normalized on
/// the way.
pub(super) fn applies<E: Element<8>>(run: &Run<'_, E>, models: usize) -> bool {
    E::Layout::THINGS == 1
        && models == run.parents.len()
        && run.joints == (0..models)
        && run.renormalize == Renormalize::Never
}

/// Locals as motions in place of the models, roots on what they stand on, the plan, the epilogue:
/// each joint is multiplied onto its parent by the product of all other runs, so a tree has the
/// same bits.
pub(super) fn forward<E: Element<8>, L: Locals<E>, X: Epilogue<E>>(
    backend: Backend,
    plan: Plan<'_>,
    run: &Run<'_, E>,
    locals: L,
    models: &mut [E],
    epilogue: &mut X,
) {
    let root = run.root_of(0);
    // Motions that lie in memory are read where they are. All else, and roots that stand on
    // something, is written to the models first and multiplied in place: the plan knows one form
    // only.
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
        backend.run(End { models, epilogue });
    }
}

/// Writes the locals, those of roots onto `root`.
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
            let mut ahead = Ahead::of(&locals);
            for start in (0..joints).step_by(E::Layout::records::<V>()) {
                let slot = JointSlot::of_joints(start, 0, joints, joints);
                let Some(local) = ahead.local(level, run, &locals, models, slot) else { return };
                E::store(locals.motion(local).to_array(), models, slot.own_tile());
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

/// The epilogue of all joints.
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
