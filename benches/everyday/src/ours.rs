//! dq8, as a user calls it.

use crate::contender::Contender;
use crate::poses::{Pose, Poses};
use dq8::{DualQuat, Quat, Real};

pub(crate) fn contenders<R: Real>(operation: &str, poses: &Poses) -> Vec<Contender> {
    let rows = || poses.rows.iter();
    let a = || rows().map(|row| motion::<R>(row.a));
    let pairs = || rows().map(|row| (motion::<R>(row.a), motion::<R>(row.b)));
    let steps = || rows().map(|row| (motion(row.a), motion(row.b), R::from_f64(row.t)));
    let moved = || rows().map(|row| (motion::<R>(row.a), row.point.map(R::from_f64)));
    let name = "dq8";
    vec![match operation {
        "product" => Contender::new(name, pairs().collect(), |&(a, b)| a * b),
        "normalize" => {
            let three = R::from_f64(3.0);
            let long = a().map(|a| a.scale(three)).collect();
            Contender::new(name, long, |a: &DualQuat<R>| a.normalize())
        }
        "nlerp" => Contender::new(name, steps().collect(), |&(a, b, t)| a.nlerp(b, t)),
        "sclerp" => Contender::new(name, steps().collect(), |&(a, b, t)| a.sclerp(b, t)),
        "point" => Contender::new(name, moved().collect(), |&(a, v)| a.transform_point(v)),
        "vector" => Contender::new(name, moved().collect(), |&(a, v)| a.transform_vector(v)),
        "to matrix" => Contender::new(name, a().collect(), |a| a.to_matrix3x4()),
        "slerp" => {
            let turns = steps().map(|(a, b, t)| (a.rotation(), b.rotation(), t));
            Contender::new(name, turns.collect(), |&(a, b, t)| a.slerp(b, t))
        }
        "from matrix" => {
            let matrices = a().map(|a| a.to_matrix3x4()).collect();
            let near = R::from_f64(1e-4);
            Contender::new(name, matrices, move |&matrix| {
                DualQuat::try_from_matrix3x4(matrix, near).unwrap_or_default()
            })
        }
        "from rigid matrix" => {
            let matrices = a().map(|a| a.to_matrix3x4()).collect();
            Contender::new(name, matrices, |&matrix| DualQuat::from_matrix3x4(matrix))
        }
        "dlb of 4" => {
            let quarter = R::from_f64(0.25);
            let cluster =
                pairs().map(|(a, b)| [(a, quarter), (b, quarter), (-a, quarter), (b * a, quarter)]);
            Contender::new(name, cluster.collect(), |influences| {
                DualQuat::dlb(influences).unwrap_or_default()
            })
        }
        "log" => Contender::new(name, a().collect(), |a| a.log()),
        "exp" => {
            let logs = a().map(|a| a.log()).collect();
            Contender::new(name, logs, |&log| DualQuat::exp(log))
        }
        "pow" => Contender::new(name, steps().collect(), |&(a, _, t)| a.pow(t)),
        "inverse" => Contender::new(name, a().collect(), |a| a.inverse()),
        "from rotation, translation" => {
            let parts = a().map(|a| (a.rotation(), a.translation())).collect();
            Contender::new(name, parts, |&(r, t)| DualQuat::from_rotation_translation(r, t))
        }
        _ => return Vec::new(),
    }]
}

fn motion<R: Real>(pose: Pose) -> DualQuat<R> {
    let rotation = Quat::from_array(pose.rotation.map(R::from_f64));
    DualQuat::from_rotation_translation(rotation, pose.translation.map(R::from_f64))
}
