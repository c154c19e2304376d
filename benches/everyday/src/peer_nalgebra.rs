//! nalgebra: `UnitDualQuaternion`, `DualQuaternion` and `Isometry3`.

use crate::job::job;
use crate::poses::{Pose, Poses};
use dq8_fixtures::turns::Job;
use nalgebra::{
    DualQuaternion, Isometry3, Matrix3, Point3, Quaternion, RealField, Rotation3, Translation3,
    UnitDualQuaternion, UnitQuaternion, Vector3,
};

/// The same without shortest ways and checks: what nalgebra has.
pub(crate) fn contenders<R: RealField + Copy>(operation: &str, poses: &Poses) -> Vec<Job<'static>> {
    let rows = || poses.rows.iter();
    let a = || rows().map(|row| motion::<R>(row.a));
    let isometry = || rows().map(|row| isometry::<R>(row.a));
    let pairs = || rows().map(|row| (motion::<R>(row.a), motion::<R>(row.b)));
    let steps = || rows().map(|row| (motion(row.a), motion(row.b), real::<R>(row.t)));
    let (dual, iso) = ("nalgebra `UnitDualQuaternion`", "`Isometry3`");
    match operation {
        "product" => vec![
            job(dual, pairs().collect(), |&(a, b)| a * b),
            job(
                iso,
                rows().map(|row| (self::isometry::<R>(row.a), self::isometry(row.b))).collect(),
                |&(a, b)| a * b,
            ),
        ],
        "normalize" => {
            let long = a().map(|a| a.into_inner() * real::<R>(3.0)).collect();
            vec![job("nalgebra `DualQuaternion`, inexact", long, |a| DualQuaternion::normalize(a))]
        }
        "nlerp" => vec![job(dual, steps().collect(), |(a, b, t)| a.nlerp(b, *t))],
        "sclerp" => vec![job(dual, steps().collect(), |(a, b, t)| a.sclerp(b, *t))],
        "point" => {
            let points = || rows().map(|row| Point3::from(row.point.map(real::<R>)));
            vec![
                job(dual, a().zip(points()).collect(), |(a, v)| a.transform_point(v)),
                job(iso, isometry().zip(points()).collect(), |(a, v)| a * v),
            ]
        }
        "vector" => {
            let vectors = || rows().map(|row| Vector3::from(row.point.map(real::<R>)));
            vec![
                job(dual, a().zip(vectors()).collect(), |(a, v)| a.transform_vector(v)),
                job(iso, isometry().zip(vectors()).collect(), |(a, v)| a * v),
            ]
        }
        "to matrix" => vec![
            job(dual, a().collect(), |a| a.to_homogeneous()),
            job(iso, isometry().collect(), |a| a.to_homogeneous()),
        ],
        "slerp" => {
            let turns = steps().map(|(a, b, t)| (a.rotation(), b.rotation(), t)).collect();
            vec![job("nalgebra `UnitQuaternion`", turns, |(a, b, t)| a.slerp(b, *t))]
        }
        "from matrix" | "from rigid matrix" => {
            let matrices: Vec<(Matrix3<R>, Vector3<R>)> = isometry()
                .map(|a| (a.rotation.to_rotation_matrix().into_inner(), a.translation.vector))
                .collect();
            vec![job("nalgebra, unchecked", matrices, |&(matrix, t)| {
                let matrix = Rotation3::from_matrix_unchecked(matrix);
                let rotation = UnitQuaternion::from_rotation_matrix(&matrix);
                UnitDualQuaternion::from_parts(Translation3::from(t), rotation)
            })]
        }
        "inverse" => vec![
            job(
                "nalgebra `DualQuaternion`",
                a().map(UnitDualQuaternion::into_inner).collect(),
                |a: &DualQuaternion<R>| a.try_inverse().unwrap_or_default(),
            ),
            job(iso, isometry().collect(), |a| a.inverse()),
        ],
        "log" => vec![job(
            "nalgebra `UnitQuaternion`, no translation",
            isometry().map(|a| a.rotation).collect(),
            |a| a.scaled_axis(),
        )],
        "exp" => vec![job(
            "nalgebra `UnitQuaternion`, no translation",
            isometry().map(|a| a.rotation.scaled_axis()).collect(),
            |&axis| UnitQuaternion::from_scaled_axis(axis),
        )],
        "pow" => vec![job(
            "nalgebra `UnitQuaternion`, no translation",
            isometry().zip(rows()).map(|(a, row)| (a.rotation, real::<R>(row.t))).collect(),
            |(a, t)| a.powf(*t),
        )],
        "from rotation, translation" => {
            vec![job(dual, isometry().map(|a| (a.translation, a.rotation)).collect(), |&(t, r)| {
                UnitDualQuaternion::from_parts(t, r)
            })]
        }
        _ => Vec::new(),
    }
}

fn real<R: RealField>(number: f64) -> R {
    nalgebra::convert(number)
}

fn isometry<R: RealField + Copy>(pose: Pose) -> Isometry3<R> {
    let [x, y, z, w] = pose.rotation.to_array().map(real::<R>);
    let rotation = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
    Isometry3::from_parts(Translation3::from(pose.translation.map(real::<R>)), rotation)
}

fn motion<R: RealField + Copy>(pose: Pose) -> UnitDualQuaternion<R> {
    UnitDualQuaternion::from_isometry(&isometry(pose))
}
