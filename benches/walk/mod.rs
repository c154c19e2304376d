//! Down a hierarchy, as users of other representations write it: model = parent's model · local.

use crate::representation::Product;
use dq8::Hierarchy;

/// `[instance][joint]`, or `[instance block][joint]` for lanes.
pub(crate) fn local_to_model<M: Product>(h: &Hierarchy, locals: &[M], models: &mut [M]) {
    let instances = locals.chunks_exact(h.joints()).zip(models.chunks_exact_mut(h.joints()));
    for (locals, models) in instances {
        for (joint, (&parent, local)) in h.parents().iter().zip(locals).enumerate() {
            // ROOT is beyond the last joint: one comparison checks the bound and finds roots.
            let model = match models.get(parent as usize) {
                Some(parent) => parent.product(local),
                None => *local,
            };
            models[joint] = model;
        }
    }
}

pub(crate) fn local_to_model_in_place<M: Product>(h: &Hierarchy, poses: &mut [M]) {
    for poses in poses.chunks_exact_mut(h.joints()) {
        for (joint, &parent) in h.parents().iter().enumerate() {
            if let Some(parent) = poses.get(parent as usize) {
                poses[joint] = parent.product(&poses[joint]);
            }
        }
    }
}
