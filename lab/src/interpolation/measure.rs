use super::method::Method;
use crate::matrix::{self, Matrix};
use dq8::{DualQuat, Quat};

/// Two poses.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    /// What is special about them.
    pub name: &'static str,
    /// At 0.
    pub from: DualQuat<f64>,
    /// At 1.
    pub to: DualQuat<f64>,
}

/// Steps on the way.
const STEPS: usize = 500;
/// The point of the body that is watched.
pub const POINT: [f64; 3] = [0.5, 0.2, -0.3];

/// Pairs of poses, from easy to hard.
pub fn pairs() -> [Pair; 5] {
    let turn = |axis: [f64; 3], degrees: f64| Quat::from_axis_angle(axis, degrees.to_radians());
    let pose = |axis, degrees, t| DualQuat::from_rotation_translation(turn(axis, degrees), t);
    let start = pose([0.6, 0.0, 0.8], 40.0, [1.0, -2.0, 0.5]);
    [
        Pair {
            name: "translation",
            from: start,
            to: DualQuat::from_translation([2.0, 1.0, 0.0]) * start,
        },
        Pair {
            name: "10⁻⁶ rad",
            from: start,
            to: start * pose([0.0, 0.6, 0.8], 1e-6_f64.to_degrees(), [3e-6, 0.0, 1e-6]),
        },
        Pair {
            name: "90° on a circle",
            from: DualQuat::from_translation([1.0, 0.0, 0.0]),
            to: pose([0.0, 0.0, 1.0], 90.0, [0.0, 1.0, 0.0]),
        },
        Pair {
            name: "150° screw",
            from: start,
            to: start * pose([0.48, 0.6, 0.64], 150.0, [1.0, 2.0, -1.0]),
        },
        Pair {
            name: "179°",
            from: start,
            to: start * pose([0.64, 0.48, -0.6], 179.0, [0.0, 1.0, 2.0]),
        },
    ]
}

/// What a way is like.
#[derive(Clone, Copy, Debug)]
pub struct Facts {
    /// The length of the way of [`POINT`].
    pub path: f64,
    /// The largest speed of that point over the smallest.
    pub speed: f64,
    /// The largest speed of turning over the smallest; NaN where nothing turns.
    pub turning: f64,
    /// The angle turned on the way from a to b, or from a to −b if that is more, over the angle
    /// between the poses; NaN where nothing turns.
    pub detour: f64,
    /// The largest element of AᵀA − 1 on the way.
    pub distortion: f64,
    /// The largest difference between the way from ca to cb and c times that from a to b: another
    /// frame of the world.
    pub left: f64,
    /// The same for ac and bc: another frame of the body.
    pub right: f64,
    /// The same for −b, which is the same pose.
    pub sign: f64,
}

/// The parameter at step `i`.
fn parameter(i: usize) -> f64 {
    i as f64 / STEPS as f64
}

/// How fast a way is at a parameter, per unit of it.
#[derive(Clone, Copy, Debug)]
pub struct Speed {
    /// The parameter.
    pub t: f64,
    /// Of [`POINT`].
    pub point: f64,
    /// Of turning, radians.
    pub turning: f64,
}

/// The speeds all along the way.
pub fn speeds(method: Method, pair: Pair) -> Vec<Speed> {
    let way: Vec<_> = (0..=STEPS).map(|i| (method.at)(pair.from, pair.to, parameter(i))).collect();
    let between = way.windows(2).enumerate().map(|(i, ends)| {
        let [from, to] = [ends[0], ends[1]];
        let [p, q] = [from, to].map(|pose| matrix::affine_apply(pose, POINT));
        let distance = (0..3).map(|axis| (p[axis] - q[axis]).powi(2)).sum::<f64>().sqrt();
        let angle = rotation(from).angle_to(rotation(to));
        let steps = STEPS as f64;
        Speed { t: parameter(i) + 0.5 / steps, point: distance * steps, turning: angle * steps }
    });
    between.collect()
}

/// The rotation that is nearest at hand to a matrix that may be none.
fn rotation(pose: Matrix<f64, 3, 4>) -> DualQuat<f64> {
    let [x, y, z] = matrix::gram_schmidt(matrix::left(pose));
    DualQuat::from_matrix3x4([x, y, z].map(|[p, q, r]| [p, q, r, 0.0]))
}

/// Measures a way.
pub fn facts(method: Method, pair: Pair) -> Facts {
    let Pair { from, to, .. } = pair;
    let c = DualQuat::from_rotation_translation(
        Quat::from_axis_angle([0.36, 0.48, 0.8], 1.1),
        [3.0, -1.0, 2.0],
    );
    let frame = c.to_matrix3x4();
    let way = speeds(method, pair);
    let to_other_sign = speeds(method, Pair { to: -to, ..pair });
    let ratio = |pick: fn(&Speed) -> f64| {
        let largest = way.iter().map(pick).fold(0.0, f64::max);
        largest / way.iter().map(pick).fold(f64::INFINITY, f64::min)
    };
    let mean =
        |of: &[Speed], pick: fn(&Speed) -> f64| of.iter().map(pick).sum::<f64>() / of.len() as f64;
    let [turned, turned_to_other_sign] =
        [&way, &to_other_sign].map(|way| mean(way, |speed| speed.turning));
    let worst =
        |error: &dyn Fn(f64) -> f64| (0..=STEPS).map(|i| error(parameter(i))).fold(0.0, f64::max);
    let angle = from.angle_to(to);
    let turns = angle > 1e-12;
    let at = |t| (method.at)(from, to, t);
    Facts {
        path: mean(&way, |speed| speed.point),
        speed: ratio(|speed| speed.point),
        turning: if turns { ratio(|speed| speed.turning) } else { f64::NAN },
        detour: if turns { turned.max(turned_to_other_sign) / angle } else { f64::NAN },
        distortion: worst(&|t| {
            let linear = matrix::left(at(t));
            matrix::skew(linear).max(matrix::stretch(linear))
        }),
        left: worst(&|t| {
            difference((method.at)(c * from, c * to, t), matrix::affine_product(frame, at(t)))
        }),
        right: worst(&|t| {
            difference((method.at)(from * c, to * c, t), matrix::affine_product(at(t), frame))
        }),
        sign: worst(&|t| difference((method.at)(from, -to, t), at(t))),
    }
}

/// The largest difference of elements; infinite where there is no answer.
fn difference(a: Matrix<f64, 3, 4>, b: Matrix<f64, 3, 4>) -> f64 {
    let pairs = a.as_flattened().iter().zip(b.as_flattened());
    let differences = pairs.map(|(a, b)| (a - b).abs());
    differences.fold(0.0, |worst, d| if d.is_nan() { f64::INFINITY } else { worst.max(d) })
}
