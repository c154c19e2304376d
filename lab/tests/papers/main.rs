//! The worked examples of the papers that dq8 implements, and what they get wrong put right. One
//! module per paper; names of tests cite equation, slide or section. `claims` holds the list of all
//! claims, `docs/claims.md`, to the tests that exist.

mod arends;
mod arends_matrices;
mod arends_quaternions;
mod arends_scaling;
mod claims;
mod fabisch;
mod jia;
mod jia_screws;
mod kenwright;
mod kenwright_class;
mod kenwright_representations;
mod tarini;

use dq8::{DualQuat, Quat};
use dq8_fixtures::vector::{add, cross, dot, length};

/// w + xi + yj + zk, in the order of the papers.
fn quat(w: f64, x: f64, y: f64, z: f64) -> Quat<f64> {
    Quat::from_wxyz([w, x, y, z])
}

/// 0 + v
fn pure(vector: [f64; 3]) -> Quat<f64> {
    Quat::from_parts(vector, 0.0)
}

/// 1 + εv, a point.
fn point(vector: [f64; 3]) -> DualQuat<f64> {
    DualQuat::new(Quat::IDENTITY, pure(vector))
}

/// Jia's example 1: a third of a turn about (1,1,1), x to y to z to x, without rounding.
fn third_turn() -> Quat<f64> {
    quat(0.5, 0.5, 0.5, 0.5)
}

/// Two dual quaternions of small whole numbers, whose products are exact; neither is unit.
fn whole_numbers() -> [DualQuat<f64>; 2] {
    [
        DualQuat::from_wxyz([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]),
        DualQuat::from_wxyz([2.0, -1.0, 3.0, 1.0, -2.0, 4.0, 1.0, -3.0]),
    ]
}

/// A motion without any symmetry, and another one.
fn motions() -> [DualQuat<f64>; 2] {
    let a = Quat::from_axis_angle([0.6, 0.0, 0.8], 1.2);
    let b = Quat::from_axis_angle([2.0 / 7.0, 6.0 / 7.0, -3.0 / 7.0], -2.1);
    [
        DualQuat::from_rotation_translation(a, [1.0, -2.0, 0.5]),
        DualQuat::from_rotation_translation(b, [0.25, 3.0, -1.5]),
    ]
}

/// The largest difference of two lists of numbers; infinite where a number is NaN.
fn distance<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    let errors = a.into_iter().zip(b).map(|(a, b)| (a - b).abs());
    errors.fold(0.0, |worst, error| if error.is_nan() { f64::INFINITY } else { worst.max(error) })
}

#[track_caller]
fn assert_close<const N: usize>(got: [f64; N], wanted: [f64; N], tolerance: f64) {
    let error = distance(got, wanted);
    assert!(error <= tolerance, "{got:?} is off by {error:e} from {wanted:?}");
}

/// Two results that must differ plainly, not by rounding.
#[track_caller]
fn assert_far<const N: usize>(got: [f64; N], wrong: [f64; N]) {
    let error = distance(got, wrong);
    assert!(error > 0.1, "{got:?} is only {error:e} from {wrong:?}");
}
