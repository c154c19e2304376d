//! The loops over a hierarchy, for any pose and any level. Lengths have been checked.

use super::Pose;
use super::job::{Job, Root};
use super::locals::{Locals, Motions, Spot};
use super::palette::Finish;
use crate::dispatch::{Backend, Kernel};
use crate::motion::Motion;
use dq8_simd::{Level, Portable};

/// Runs a kernel over poses `P`: single motions gain nothing from wider instructions, and would only
/// be compiled several times.
#[inline]
pub(super) fn run<P: Pose, K: Kernel>(backend: Backend, kernel: K) -> K::Output {
    if P::INSTANCES == 1 { Portable.run(|| kernel.run(Portable)) } else { backend.run(kernel) }
}

/// model(j) = model(parent(j)) · local(j), parents first. Without `locals`, `models` holds them.
pub(super) struct Forward<'j, 'h, 's, P: Pose, L, F> {
    pub(super) job: &'j Job<'h, P>,
    pub(super) locals: Option<L>,
    pub(super) models: &'s mut [P],
    pub(super) finish: F,
}

impl<P: Pose, L: Locals<P>, F: Finish<P>> Kernel for Forward<'_, '_, '_, P, L, F> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { job, locals, models, mut finish } = self;
        // The joints are not 0 where there is anything to do.
        let joints = job.hierarchy.joints().max(1);
        // Parts of one instance are side by side already.
        let side_by_side = if P::parts::<V>() == 1 { 2 } else { 1 };
        let sets = models.chunks_mut(joints.saturating_mul(side_by_side));
        for (first, models) in (0..).step_by(side_by_side).zip(sets) {
            let (a, b) = models.split_at_mut(joints);
            if b.is_empty() {
                forward(level, job, locals, &mut finish, [(first, a)]);
            } else {
                forward(level, job, locals, &mut finish, [(first, a), (first + 1, b)]);
            }
        }
    }
}

/// Instances side by side: a child waits for its parent, and while one waits, the other is computed.
#[inline(always)]
fn forward<P: Pose, L: Locals<P>, F: Finish<P>, V: Level, const K: usize>(
    level: V,
    job: &Job<'_, P>,
    locals: Option<L>,
    finish: &mut F,
    mut instances: [(usize, &mut [P]); K],
) {
    let parents = job.hierarchy.parents();
    for joint in job.joints.clone() {
        // ROOT is beyond the last joint: there is no such model.
        let Some(&parent) = parents.get(joint) else { return };
        let renormalise = job.renormalise.applies_to(joint);
        for (instance, models) in &mut instances {
            let index = *instance * parents.len() + joint;
            for part in 0..P::parts::<V>() {
                let spot = Spot { index, joint, part };
                let in_place = Spot { index: joint, ..spot };
                // What is rare stands apart, or it would take registers from what is not.
                let model = if let Some(parent) = models.get(parent as usize) {
                    match locals {
                        Some(locals) => locals.onto(level, parent.load(level, part), spot),
                        None => Motions(models).onto(level, parent.load(level, part), in_place),
                    }
                } else {
                    root(level, job, locals, models, spot)
                };
                let (Some(model), Some(slot)) = (model, models.get_mut(joint)) else { return };
                slot.store(level, part, model);
                if renormalise {
                    slot.store(level, part, slot.load(level, part).normalize());
                }
                finish.finish(level, spot, slot);
            }
        }
    }
}

/// The model of a joint without a parent.
#[inline(always)]
fn root<P: Pose, L: Locals<P>, V: Level>(
    level: V,
    job: &Job<'_, P>,
    locals: Option<L>,
    models: &[P],
    spot: Spot,
) -> Option<P::Motion<V>> {
    let instance = spot.index / job.hierarchy.joints().max(1);
    let in_place = Spot { index: spot.joint, ..spot };
    match (root_of(job, level, instance, spot.part), locals) {
        (None, Some(locals)) => locals.alone(level, spot),
        (None, None) => Motions(models).alone(level, in_place),
        (Some(root), Some(locals)) => locals.onto(level, root, spot),
        (Some(root), None) => Motions(models).onto(level, root, in_place),
    }
}

/// local(j) = model(parent(j))* · model(j), children first, so that in place every parent is still
/// a model when its children need it.
pub(super) struct Backward<'j, 'h, 's, P: Pose> {
    pub(super) job: &'j Job<'h, P>,
    pub(super) models: Option<&'s [P]>,
    pub(super) locals: &'s mut [P],
}

impl<P: Pose> Kernel for Backward<'_, '_, '_, P> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { job, models, locals } = self;
        let parents = job.hierarchy.parents();
        let joints = parents.len().max(1);
        for (instance, locals) in locals.chunks_exact_mut(joints).enumerate() {
            let models = models.and_then(|all| all.chunks_exact(joints).nth(instance));
            for joint in job.joints.clone().rev() {
                for part in 0..P::parts::<V>() {
                    let models = models.unwrap_or(locals);
                    let Some(model) = models.get(joint) else { break };
                    let parent = parents.get(joint).and_then(|&parent| models.get(parent as usize));
                    let parent = match parent {
                        Some(parent) => Some(parent.load(level, part)),
                        None => root_of(job, level, instance, part),
                    };
                    let mut local = model.load(level, part);
                    if let Some(parent) = parent {
                        local = parent.conjugate() * local;
                    }
                    if let Some(slot) = locals.get_mut(joint) {
                        slot.store(level, part, local);
                    }
                }
            }
        }
    }
}

#[inline(always)]
fn root_of<P: Pose, V: Level>(
    job: &Job<'_, P>,
    level: V,
    instance: usize,
    part: usize,
) -> Option<P::Motion<V>> {
    match job.root {
        Root::None => None,
        Root::Same(root) => Some(P::splat(level, root)),
        Root::Each(roots) => roots.get(instance).map(|root| root.load(level, part)),
    }
}
