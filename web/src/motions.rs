//! Arrays of motions and of points.

use crate::memory::{slice, slice_mut, status};
use crate::{Columns, Motion};
use dq8::hierarchy::MatrixOrder;
use dq8::{Backend, Quat};

/// `product[i] = a[i] * b[i]`.
///
/// # Safety
/// So many motions are there, and `product` lies apart.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_mul(
    a: *const Motion,
    a_count: usize,
    b: *const Motion,
    b_count: usize,
    product: *mut Motion,
    count: usize,
) -> u32 {
    // SAFETY: promised.
    let (a, b, product) =
        unsafe { (slice(a, a_count), slice(b, b_count), slice_mut(product, count)) };
    status(Backend::best().mul(a, b, product))
}

/// From `a[i]` to `b[i]`, `t[i]` of it, along one screw.
///
/// # Safety
/// So many are there, and `between` lies apart.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_sclerp_each(
    a: *const Motion,
    a_count: usize,
    b: *const Motion,
    b_count: usize,
    t: *const [f32; 1],
    t_count: usize,
    between: *mut Motion,
    count: usize,
) -> u32 {
    // SAFETY: promised.
    let (a, b, t, between) = unsafe {
        (slice(a, a_count), slice(b, b_count), slice(t, t_count), slice_mut(between, count))
    };
    status(Backend::best().sclerp_each(a, b, t, between))
}

/// Each point by its own motion.
///
/// # Safety
/// So many are there, and `moved` lies apart.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_transform_points_each(
    motions: *const Motion,
    motion_count: usize,
    points: *const [f32; 3],
    point_count: usize,
    moved: *mut [f32; 3],
    count: usize,
) -> u32 {
    // SAFETY: promised.
    let (motions, points, moved) = unsafe {
        (slice(motions, motion_count), slice(points, point_count), slice_mut(moved, count))
    };
    status(Backend::best().transform_points_each(motions, points, moved))
}

/// 4×4 matrices, column after column.
///
/// # Safety
/// So many are there, and `matrices` lies apart.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_matrices(
    motions: *const Motion,
    motion_count: usize,
    matrices: *mut Columns,
    count: usize,
) -> u32 {
    // SAFETY: promised.
    let (motions, matrices) = unsafe { (slice(motions, motion_count), slice_mut(matrices, count)) };
    status(Backend::best().matrices(motions, MatrixOrder::Columns, matrices))
}

/// Motions of rotations x, y, z, w and translations; rotations are normalized first.
///
/// # Safety
/// `count` are there of both, which lie apart.
#[unsafe(no_mangle)]
unsafe extern "C" fn dq8_from_rotations_translations(
    poses: *const [f32; 7],
    motions: *mut Motion,
    count: usize,
) {
    // SAFETY: promised.
    let (poses, motions) = unsafe { (slice(poses, count), slice_mut(motions, count)) };
    for (&[x, y, z, w, a, b, c], motion) in poses.iter().zip(motions) {
        let rotation = Quat::from_xyzw(x, y, z, w).normalize();
        *motion = Motion::from_rotation_translation(rotation, [a, b, c]);
    }
}
