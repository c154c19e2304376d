//! The loops over a hierarchy, for any pose and any level. Lengths have been checked.

use super::Pose;
use super::job::{Job, Root};
use super::locals::Locals;
use crate::dispatch::{Backend, Kernel};
use crate::motion::Motion;
use dq8_simd::{Level, Portable};

/// Runs a kernel over poses `P`: single motions gain nothing from wider instructions, and would only
/// be compiled several times.
#[inline]
pub(super) fn run<P: Pose, K: Kernel>(backend: Backend, kernel: K) -> K::Output {
    if P::INSTANCES == 1 { Portable.run(|| kernel.run(Portable)) } else { backend.run(kernel) }
}

/// model(j) = model(parent(j)) · local(j), parents first.
pub(super) struct Forward<'j, 'h, 's, P: Pose, L> {
    pub(super) job: &'j Job<'h, P>,
    pub(super) locals: L,
    pub(super) models: &'s mut [P],
}

impl<P: Pose, L: Locals<P>> Kernel for Forward<'_, '_, '_, P, L> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { job, locals, models } = self;
        // The joints are not 0 where there is anything to do.
        let joints = job.hierarchy.joints().max(1);
        for (pair, models) in models.chunks_mut(joints.saturating_mul(2)).enumerate() {
            let first = pair * 2;
            let (a, b) = models.split_at_mut(joints);
            if b.is_empty() {
                forward(level, job, locals, [(first, a)]);
            } else {
                forward(level, job, locals, [(first, a), (first + 1, b)]);
            }
        }
    }
}

/// Instances side by side: a child waits for its parent, and while one waits, the other is computed.
#[inline(always)]
fn forward<P: Pose, L: Locals<P>, V: Level, const K: usize>(
    level: V,
    job: &Job<'_, P>,
    locals: L,
    mut instances: [(usize, &mut [P]); K],
) {
    let parents = job.hierarchy.parents();
    for joint in job.joints.clone() {
        for (instance, models) in &mut instances {
            let place = (*instance * parents.len() + joint, joint);
            // ROOT is beyond the last joint, so the check of the bound tells roots apart.
            let parent = parents.get(joint).and_then(|&parent| models.get(parent as usize));
            let parent = match parent {
                Some(parent) => Some(parent.load(level)),
                None => root_of(job, level, *instance),
            };
            let Some(mut model) = locals.onto(level, parent, models, place) else { break };
            if job.renormalise.applies_to(joint) {
                model = model.normalize();
            }
            if let Some(slot) = models.get_mut(joint) {
                slot.store(level, model);
            }
        }
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
            let root = root_of(job, level, instance);
            for joint in job.joints.clone().rev() {
                let models = models.unwrap_or(locals);
                let Some(model) = models.get(joint) else { break };
                let mut local = model.load(level);
                match parents.get(joint).and_then(|&parent| models.get(parent as usize)) {
                    Some(parent) => local = parent.load(level).conjugate() * local,
                    None => {
                        if let Some(root) = root {
                            local = root.conjugate() * local;
                        }
                    }
                }
                if let Some(slot) = locals.get_mut(joint) {
                    slot.store(level, local);
                }
            }
        }
    }
}

#[inline(always)]
fn root_of<P: Pose, V: Level>(job: &Job<'_, P>, level: V, instance: usize) -> Option<P::Motion<V>> {
    match job.root {
        Root::None => None,
        Root::Same(root) => Some(P::splat(level, root)),
        Root::Each(roots) => roots.get(instance).map(|root| root.load(level)),
    }
}
