//! The loops over a hierarchy, for any pose and any level. Lengths have been checked.

use super::Pose;
use super::job::{Job, Root};
use super::locals::{JointSlot, Locals};
use super::palette::Epilogue;
use crate::dispatch::Kernel;
use crate::motion::Motion;
use core::sync::atomic::{Ordering, compiler_fence};
use dq8_simd::Level;

/// Whether instructions that wait do not keep others from running. Microcontrollers execute one after the
/// other, and have little room for code.
const OVERLAPS: bool =
    cfg!(not(all(target_os = "none", any(target_arch = "arm", target_arch = "riscv32"))));

/// Bytes of the first cache, or less, that instances side by side may fill.
const CACHE: usize = 32 << 10;

/// So many joints ahead the next ones are fetched. Crowds of 64 joints in place by 1024 take a tenth less
/// time for it with AVX2 and a twentieth less with AVX-512; one block of 16, which never leaves the first
/// cache, a twentieth more. Farther ahead is no faster, and from 8 on slower.
const AHEAD: usize = 2;

/// model(j) = model(parent(j)) · local(j), parents first.
pub(super) struct Forward<'j, 'h, 's, P: Pose, L, F> {
    pub(super) job: &'j Job<'h, P>,
    pub(super) locals: L,
    pub(super) models: &'s mut [P],
    pub(super) finish: F,
}

impl<P: Pose, L: Locals<P>, F: Epilogue<P>> Kernel for Forward<'_, '_, '_, P, L, F> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { job, locals, models, mut finish } = self;
        let joints = job.hierarchy.joints();
        // Parts of one instance are side by side already.
        let alone = P::parts::<V>() > 1 || joints > CACHE / 2 / size_of::<P>();
        let side_by_side = if OVERLAPS && !alone { 2 } else { 1 };
        // There are joints where there is anything to do, and no part of an instance. The compiler does not
        // know: `chunks_mut(0)` or a plain `split_at_mut` would be a path to a panic in the machine code.
        let sets = models.chunks_mut(joints.saturating_mul(side_by_side).max(1));
        for (first, models) in (0..).step_by(side_by_side).zip(sets) {
            let Some((a, b)) = models.split_at_mut_checked(joints) else { return };
            if side_by_side == 1 || b.is_empty() {
                forward(level, job, locals, &mut finish, [(first, a)]);
            } else {
                forward(level, job, locals, &mut finish, [(first, a), (first + 1, b)]);
            }
        }
    }
}

/// Instances side by side: a child waits for its parent, and while one waits, the other is computed.
#[inline(always)]
fn forward<P: Pose, L: Locals<P>, F: Epilogue<P>, V: Level, const K: usize>(
    level: V,
    job: &Job<'_, P>,
    locals: L,
    finish: &mut F,
    mut instances: [(usize, &mut [P]); K],
) {
    let parents = job.hierarchy.parents();
    for joint in job.joints.clone() {
        // ROOT is beyond the last joint: there is no such model.
        let Some(&parent) = parents.get(joint) else { return };
        let renormalize = job.renormalize.applies_to(joint);
        for (instance, models) in &mut instances {
            if P::INSTANCES > 1
                && let Some(soon) = models.get(joint.saturating_add(AHEAD))
            {
                level.prefetch(soon);
            }
            let index = *instance * parents.len() + joint;
            for part in 0..P::parts::<V>() {
                let spot = JointSlot { index, joint, part };
                if let Some(parent) = models.get(parent as usize) {
                    let model = locals.onto(level, parent, models, spot);
                    let (Some(model), Some(slot)) = (model, models.get_mut(joint)) else { return };
                    slot.store(level, part, model);
                } else {
                    root(level, job, locals, models, spot);
                }
                // The next part, or instance, is none of this one's business: a compiler that mixes
                // them has not enough registers.
                compiler_fence(Ordering::SeqCst);
                let Some(slot) = models.get_mut(joint) else { return };
                if renormalize {
                    slot.store(level, part, slot.load(level, part).normalize());
                }
                finish.finish(level, spot, slot);
            }
        }
    }
}

/// The model of a joint without a parent. Not inlined: its registers would be missing where the work
/// is.
#[cold]
#[inline(never)]
fn root<P: Pose, L: Locals<P>, V: Level>(
    level: V,
    job: &Job<'_, P>,
    locals: L,
    models: &mut [P],
    spot: JointSlot,
) {
    level.run(
        #[inline(always)]
        || {
            let JointSlot { index, joint, part } = spot;
            let instance = index / job.hierarchy.joints().max(1);
            let local = locals.alone(level, models, spot);
            let model = local.map(|local| match root_of(job, level, instance, part) {
                Some(root) => root * local,
                None => local,
            });
            if let (Some(model), Some(slot)) = (model, models.get_mut(joint)) {
                slot.store(level, part, model);
            }
        },
    );
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
