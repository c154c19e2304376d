//! Crowds: poses in blocks of four instances, the quickest form where nothing else wants them plain.

use crate::Motion;
use crate::memory::{slice, slice_mut, status};
use crate::skeleton::Rig;
use dq8::Crowd;

type Blocks = Crowd<f32, 4>;

#[unsafe(no_mangle)]
extern "C" fn dq8_crowd(rig: &Rig, instances: usize) -> *mut Blocks {
    Box::into_raw(Box::new(Crowd::new(rig.skeleton.joints(), instances)))
}

/// # Safety
/// It has been made, and is not used any more.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_crowd_free(crowd: *mut Blocks) {
    // SAFETY: promised.
    drop(unsafe { Box::from_raw(crowd) });
}

/// # Safety
/// So many poses are there.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_crowd_set(crowd: &mut Blocks, poses: *const Motion, count: usize) -> u32 {
    // SAFETY: promised.
    let poses = unsafe { slice(poses, count) };
    status(dq8::storage::pack(crowd.joints(), poses, crowd.blocks_mut()))
}

/// # Safety
/// So many poses are there.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_crowd_copy_to(crowd: &Blocks, poses: *mut Motion, count: usize) -> u32 {
    // SAFETY: promised.
    status(crowd.copy_to_slice(unsafe { slice_mut(poses, count) }))
}

/// In place.
#[unsafe(no_mangle)]
extern "C" fn dq8_crowd_local_to_model(crowd: &mut Blocks, rig: &Rig) -> u32 {
    status(rig.skeleton.job().local_to_model_in_place(crowd.blocks_mut()))
}
