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
    let joints = parents.len().max(1);
    for (locals, models) in locals.chunks_exact(joints).zip(models.chunks_exact_mut(joints)) {
        for (joint, (&parent, &local)) in parents.iter().zip(locals).enumerate() {
            models[joint] = match models.get(parent as usize) {
                Some(&parent) => parent * local,
                None => local,
            };
        }
    }
}
