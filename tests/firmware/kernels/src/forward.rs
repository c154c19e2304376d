//! Forward kinematics.

use dq8::{DualQuat, Hierarchy};

/// Checks the parents and takes every joint from its parent to the model, in place.
#[unsafe(no_mangle)]
fn forward_kinematics(parents: &[u32], poses: &mut [DualQuat<f32>]) -> bool {
    Hierarchy::new(parents)
        .is_ok_and(|hierarchy| hierarchy.job().local_to_model_in_place(poses).is_ok())
}
