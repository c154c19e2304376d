//! glam: a rotation and a translation, or a 3×4 matrix.

use crate::job::job;
use crate::poses::{Pose, Poses};
use dq8_fixtures::turns::Job;
use glam::{Affine3A, DAffine3, DQuat, DVec3, Quat, Vec3A};

/// glam's types of the two precisions have no trait in common.
macro_rules! lineup {
    ($name:ident, $real:ident, $quat:ident, $vector:ident, $affine:ident, $point:ident, $moved:ident,
        $rotation:ident, $parts:literal, $matrix:literal) => {
        pub(crate) fn $name(operation: &str, poses: &Poses) -> Vec<Job<'static>> {
            let pose = |pose: Pose| {
                let [x, y, z] = pose.translation.map(|c| c as $real);
                let turn = $quat::from_array(pose.rotation.to_array().map(|c| c as $real));
                (turn, $vector::new(x, y, z))
            };
            let affine = move |at: Pose| {
                let (turn, t) = pose(at);
                $affine::from_rotation_translation(turn, t.into())
            };
            let rows = || poses.rows.iter();
            let pairs = || rows().map(|row| (pose(row.a), pose(row.b)));
            let steps = || rows().map(|row| (pose(row.a), pose(row.b), row.t as $real));
            let points = || rows().map(|row| $vector::from(row.point.map(|c| c as $real)));
            match operation {
                "product" => vec![
                    job($parts, pairs().collect(), |&((r, t), (s, u))| (r * s, r * u + t)),
                    job(
                        $matrix,
                        rows().map(|row| (affine(row.a), affine(row.b))).collect(),
                        |&(a, b)| a * b,
                    ),
                ],
                "nlerp" => {
                    vec![job($parts, steps().collect(), |&((r, t), (s, u), at)| {
                        (r.lerp(s, at), t.lerp(u, at))
                    })]
                }
                "sclerp" => {
                    vec![job($parts, steps().collect(), |&((r, t), (s, u), at)| {
                        (r.slerp(s, at), t.lerp(u, at))
                    })]
                }
                "slerp" => vec![job(
                    $parts,
                    steps().map(|((r, _), (s, _), at)| (r, s, at)).collect(),
                    |&(r, s, at)| r.slerp(s, at),
                )],
                "point" => vec![
                    job(
                        $parts,
                        rows().map(|row| pose(row.a)).zip(points()).collect(),
                        |&((r, t), v)| r * v + t,
                    ),
                    job(
                        $matrix,
                        rows().map(|row| affine(row.a)).zip(points()).collect(),
                        |&(a, v)| a.$point(v),
                    ),
                ],
                "vector" => vec![
                    job(
                        $parts,
                        rows().map(|row| pose(row.a).0).zip(points()).collect(),
                        |&(r, v)| r * v,
                    ),
                    job(
                        $matrix,
                        rows().map(|row| affine(row.a)).zip(points()).collect(),
                        |&(a, v)| a.$moved(v),
                    ),
                ],
                "to matrix" => {
                    vec![job($matrix, rows().map(|row| pose(row.a)).collect(), |&(r, t)| {
                        $affine::from_rotation_translation(r, t.into())
                    })]
                }
                "from matrix" | "from rigid matrix" => vec![job(
                    concat!($matrix, ", unchecked"),
                    rows().map(|row| affine(row.a)).collect(),
                    |a| ($quat::$rotation(&a.matrix3), a.translation),
                )],
                "inverse" => vec![
                    job($parts, rows().map(|row| pose(row.a)).collect(), |&(r, t)| {
                        (r.inverse(), -(r.inverse() * t))
                    }),
                    job($matrix, rows().map(|row| affine(row.a)).collect(), |a| a.inverse()),
                ],
                "log" => vec![job(
                    concat!($parts, ", no translation"),
                    rows().map(|row| pose(row.a).0).collect(),
                    |r| r.to_scaled_axis(),
                )],
                "exp" => vec![job(
                    concat!($parts, ", no translation"),
                    rows().map(|row| pose(row.a).0.to_scaled_axis()).collect(),
                    |&axis| $quat::from_scaled_axis(axis),
                )],
                _ => Vec::new(),
            }
        }
    };
}

lineup! {
    single, f32, Quat, Vec3A, Affine3A, transform_point3a, transform_vector3a, from_mat3a,
    "glam `Quat` + `Vec3A`", "`Affine3A`"
}
lineup! {
    double, f64, DQuat, DVec3, DAffine3, transform_point3, transform_vector3, from_mat3,
    "glam `DQuat` + `DVec3`", "`DAffine3`"
}
