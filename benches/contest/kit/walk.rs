//! Down a hierarchy, as users of other representations write it: model = parent's model · local.

use crate::memory::Product;
use dq8::Hierarchy;
use dq8_fixtures::kinematics;

/// `[instance][joint]`, or `[instance block][joint]` for lanes.
pub fn local_to_model<M: Product>(h: &Hierarchy, locals: &[M], models: &mut [M]) {
    kinematics::walk(h.parents(), locals, models, M::product);
}

pub fn local_to_model_in_place<M: Product>(h: &Hierarchy, poses: &mut [M]) {
    kinematics::walk_in_place(h.parents(), poses, M::product);
}
