//! Arrays of motions and of points.

use crate::error::status;
use crate::memory::exports;
use crate::{Columns, Motion};
use dq8::hierarchy::MatrixOrder;
use dq8::{Backend, Quat, ShapeError};

exports! {
    /// `product[i] = a[i] * b[i]`, or `a[0] * b[i]` if `a` is one motion.
    fn dq8_mul(; a[a_count]: Motion, b[b_count]: Motion; product[count]: Motion) -> u32 {
        if let (&[left], true) = (a, count == b_count) {
            // In a loop: the kernel would add 250 compressed bytes.
            for (product, &b) in product.iter_mut().zip(b) {
                *product = left * b;
            }
            return 0;
        }
        status(Backend::best().mul(a, b, product))
    }

    /// From `a[i]` to `b[i]`, `t[i]` of it, along one screw.
    fn dq8_sclerp_each(
        ; a[a_count]: Motion, b[b_count]: Motion, t[t_count]: [f32; 1]; between[count]: Motion
    ) -> u32 {
        status(Backend::best().sclerp_each(a, b, t, between))
    }

    /// Each point by its own motion.
    fn dq8_transform_points_each(
        ; motions[motion_count]: Motion, points[point_count]: [f32; 3]; moved[count]: [f32; 3]
    ) -> u32 {
        status(Backend::best().transform_points_each(motions, points, moved))
    }

    /// All points by one motion.
    fn dq8_transform_points(; motion[ones]: Motion, points[point_count]: [f32; 3]; moved[count]: [f32; 3]) -> u32 {
        let &[motion] = motion else {
            return status(Err(ShapeError::Length { what: "motion", length: ones, expected: 1 }));
        };
        status(Backend::best().transform_points(motion, points, moved))
    }

    /// 4×4 matrices, column after column.
    fn dq8_matrices(; motions[motion_count]: Motion; matrices[count]: Columns) -> u32 {
        status(Backend::best().matrices(motions, MatrixOrder::Columns, matrices))
    }

    /// Motions of as many rotations x, y, z, w and translations; rotations are normalized first.
    fn dq8_from_rotations_translations(; poses[pose_count]: [f32; 7]; motions[count]: Motion) -> u32 {
        if count != pose_count {
            return status(Err(ShapeError::Length { what: "motions", length: count, expected: pose_count }));
        }
        for (&[x, y, z, w, a, b, c], motion) in poses.iter().zip(motions) {
            let rotation = Quat::from_xyzw(x, y, z, w).normalize();
            *motion = Motion::from_rotation_translation(rotation, [a, b, c]);
        }
        0
    }

    /// As many rotations x, y, z, w and translations of unit motions.
    fn dq8_to_rotations_translations(; motions[motion_count]: Motion; poses[count]: [f32; 7]) -> u32 {
        if count != motion_count {
            return status(Err(ShapeError::Length { what: "poses", length: count, expected: motion_count }));
        }
        to_rotations_translations(motions, poses);
        0
    }
}

/// Rotations and translations of unit motions.
pub(crate) fn to_rotations_translations(motions: &[Motion], poses: &mut [[f32; 7]]) {
    for (motion, pose) in motions.iter().zip(poses) {
        let ([x, y, z, w], [a, b, c]) = (motion.rotation().to_array(), motion.translation());
        *pose = [x, y, z, w, a, b, c];
    }
}
