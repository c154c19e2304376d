//! dq8, as a user calls it.

use crate::job::job;
use crate::poses::{Pose, Poses};
use dq8::{DualQuat, Real};
use dq8_fixtures::turns::Job;

pub(crate) fn contenders<R: Real>(operation: &str, poses: &Poses) -> Vec<Job<'static>> {
    let rows = || poses.rows.iter();
    let a = || rows().map(|row| motion::<R>(row.a));
    let pairs = || rows().map(|row| (motion::<R>(row.a), motion::<R>(row.b)));
    let steps = || rows().map(|row| (motion(row.a), motion(row.b), R::from_f64(row.t)));
    let moved = || rows().map(|row| (motion::<R>(row.a), row.point.map(R::from_f64)));
    let name = "dq8";
    vec![match operation {
        "product" => job(name, pairs().collect(), |&(a, b)| a * b),
        "normalize" => {
            let three = R::from_f64(3.0);
            let long = a().map(|a| a.scale(three)).collect();
            job(name, long, |a: &DualQuat<R>| a.normalize())
        }
        "nlerp" => job(name, steps().collect(), |&(a, b, t)| a.nlerp(b, t)),
        "sclerp" => job(name, steps().collect(), |&(a, b, t)| a.sclerp(b, t)),
        "point" => job(name, moved().collect(), |&(a, v)| a.transform_point(v)),
        "vector" => job(name, moved().collect(), |&(a, v)| a.transform_vector(v)),
        "to matrix" => job(name, a().collect(), |a| a.to_matrix3x4()),
        "slerp" => {
            let turns = steps().map(|(a, b, t)| (a.rotation(), b.rotation(), t));
            job(name, turns.collect(), |&(a, b, t)| a.slerp(b, t))
        }
        "from matrix" => {
            let matrices = a().map(|a| a.to_matrix3x4()).collect();
            let near = R::from_f64(1e-4);
            job(name, matrices, move |&matrix| {
                DualQuat::try_from_matrix3x4(matrix, near).unwrap_or_default()
            })
        }
        "from rigid matrix" => {
            let matrices = a().map(|a| a.to_matrix3x4()).collect();
            job(name, matrices, |&matrix| DualQuat::from_matrix3x4(matrix))
        }
        "dlb of 4" => {
            let quarter = R::from_f64(0.25);
            let cluster =
                pairs().map(|(a, b)| [(a, quarter), (b, quarter), (-a, quarter), (b * a, quarter)]);
            job(name, cluster.collect(), |influences| DualQuat::dlb(influences).unwrap_or_default())
        }
        "log" => job(name, a().collect(), |a| a.log()),
        "exp" => {
            let logs = a().map(|a| a.log()).collect();
            job(name, logs, |&log| DualQuat::exp(log))
        }
        "pow" => job(name, steps().collect(), |&(a, _, t)| a.pow(t)),
        "inverse" => job(name, a().collect(), |a| a.inverse()),
        "from rotation, translation" => {
            let parts = a().map(|a| (a.rotation(), a.translation())).collect();
            job(name, parts, |&(r, t)| DualQuat::from_rotation_translation(r, t))
        }
        _ => return Vec::new(),
    }]
}

fn motion<R: Real>(pose: Pose) -> DualQuat<R> {
    DualQuat::from(pose).cast()
}
