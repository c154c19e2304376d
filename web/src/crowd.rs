//! Crowds: poses in blocks of four instances, the quickest form where nothing else wants them
//! plain.

use crate::Motion;
use crate::memory::{exports, frees, status};
use crate::skeleton::Rig;
use dq8::Crowd;

type Blocks = Crowd<f32, 4>;

frees!(dq8_crowd_free: Blocks);
exports! {
    fn dq8_crowd(rig: &Rig, instances: usize;;) -> *mut Blocks {
        Box::into_raw(Box::new(Crowd::new(rig.skeleton.joints(), instances)))
    }

    fn dq8_crowd_set(crowd: &mut Blocks; poses[count]: Motion;) -> u32 {
        status(dq8::storage::pack(crowd.joints(), poses, crowd.blocks_mut()))
    }

    fn dq8_crowd_copy_to(crowd: &Blocks;; poses[count]: Motion) -> u32 {
        status(crowd.copy_to_slice(poses))
    }

    /// In place.
    fn dq8_crowd_local_to_model(crowd: &mut Blocks, rig: &Rig;;) -> u32 {
        status(rig.skeleton.job().local_to_model_in_place(crowd.blocks_mut()))
    }
}
