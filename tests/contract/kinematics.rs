//! Forward kinematics as it is defined: one product of the scalar reference after the other.
//!
//! `Hierarchy` computes plain slices in registers too, so that is not what lanes are held against.

use dq8::{DualQuat, Real};

/// model(j) = model(parent(j)) · local(j), `[instance][joint]`. A parent that is no joint is none;
/// parents come before their children.
///
/// # Panics
/// If `models` is shorter than `locals`.
pub fn local_to_model<R: Real>(
    parents: &[u32],
    locals: &[DualQuat<R>],
    models: &mut [DualQuat<R>],
) {
    walk(parents, locals, models, |&parent, &local| parent * local);
}

/// The same for any motions: `product` lets its second argument act first.
///
/// # Panics
/// If `models` is shorter than `locals`.
pub fn walk<M: Copy>(
    parents: &[u32],
    locals: &[M],
    models: &mut [M],
    product: impl Fn(&M, &M) -> M,
) {
    let joints = parents.len().max(1);
    for (locals, models) in locals.chunks_exact(joints).zip(models.chunks_exact_mut(joints)) {
        for (joint, (&parent, local)) in parents.iter().zip(locals).enumerate() {
            // A root's parent is beyond the last joint: one comparison checks the bound and finds roots.
            models[joint] = match models.get(parent as usize) {
                Some(parent) => product(parent, local),
                None => *local,
            };
        }
    }
}

/// Models over locals.
pub fn walk_in_place<M: Copy>(parents: &[u32], poses: &mut [M], product: impl Fn(&M, &M) -> M) {
    for poses in poses.chunks_exact_mut(parents.len().max(1)) {
        for (joint, &parent) in parents.iter().enumerate() {
            if let Some(parent) = poses.get(parent as usize) {
                poses[joint] = product(parent, &poses[joint]);
            }
        }
    }
}

/// One motion after the other, from `start`: the product of all, the last one first.
#[must_use]
pub fn after<R: Real>(start: DualQuat<R>, steps: &[DualQuat<R>]) -> DualQuat<R> {
    steps.iter().fold(start, |pose, &step| step * pose)
}
