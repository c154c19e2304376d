//! The functions that pose a mesh in arrays, as one.

use dq8_capi::Status;
use dq8_capi::skin::Skin;
use dq8_capi::skinning::single as c;

/// Which of them.
#[derive(Clone, Copy, Debug)]
pub(crate) enum How {
    Linear,
    Dual,
    Stretched,
    Mixed,
}

impl How {
    pub(crate) const ALL: [Self; 4] = [Self::Linear, Self::Dual, Self::Stretched, Self::Mixed];
}

/// What they read: a skin, palettes, shares, and positions, normals and tangents at rest.
#[derive(Clone, Copy)]
pub(crate) struct Pointers {
    pub(crate) skin: *const Skin<f32>,
    pub(crate) matrices: *const f32,
    pub(crate) motions: *const f32,
    pub(crate) stretches: *const f32,
    pub(crate) shares: *const f32,
    pub(crate) rest: [*const f32; 3],
}

/// # Safety
/// As for the C functions.
pub(crate) unsafe fn pose(
    how: How,
    joints: usize,
    of: Pointers,
    to: [*mut f32; 3],
    vertices: usize,
) -> Status {
    let Pointers { skin, matrices, motions, stretches, shares, rest: [p, n, t] } = of;
    let [to_p, to_n, to_t] = to;
    // SAFETY: promised.
    unsafe {
        match how {
            How::Linear => c::linear(skin, matrices, joints, p, n, t, to_p, to_n, to_t, vertices),
            How::Dual => c::dual(skin, motions, joints, p, n, t, to_p, to_n, to_t, vertices),
            How::Stretched => {
                c::stretched(skin, motions, stretches, joints, p, n, t, to_p, to_n, to_t, vertices)
            }
            How::Mixed => c::mixed(
                skin, matrices, motions, shares, joints, p, n, t, to_p, to_n, to_t, vertices,
            ),
        }
    }
}
