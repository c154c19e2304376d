//! Alexa's keyframes, as he means them and as Arends reads them, and the logarithm of matrices that
//! they stand on.

mod alexa;
mod elements;
mod logarithm;

use dq8::{DualQuat, Twist};
use nalgebra::Matrix4;

/// [ω]× and v: the matrix whose exponential is the motion of the twist.
fn of_twist(twist: Twist<f64>) -> Matrix4<f64> {
    let [x, y, z, a, b, c] = twist.to_array();
    Matrix4::new(0.0, -z, y, a, z, 0.0, -x, b, -y, x, 0.0, c, 0.0, 0.0, 0.0, 0.0)
}

/// A turn about z through (1, 0, 0), with a slide, by `degrees`.
fn about_z(degrees: f64) -> DualQuat<f64> {
    let twist = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0, -1.0, 0.25] };
    DualQuat::from_twist(twist.scale(degrees.to_radians()))
}

/// Every element within `tolerance` of the wanted one.
#[track_caller]
fn assert_same(found: &Matrix4<f64>, wanted: &Matrix4<f64>, tolerance: f64) {
    let error = (found - wanted).amax();
    // The largest of elements with NaN among them need not be NaN.
    assert!(found.iter().all(|element| element.is_finite()), "{found}");
    assert!(error <= tolerance, "off by {error:e}:{found}for{wanted}");
}

/// At least one element further than `tolerance` from the other.
#[track_caller]
fn assert_differ(a: &Matrix4<f64>, b: &Matrix4<f64>, tolerance: f64) {
    let distance = (a - b).amax();
    assert!(distance > tolerance, "apart by no more than {distance:e}:{a}and{b}");
}

#[test]
fn the_experiment_is_written_up_with_tables_and_charts() {
    let section = lab::keyframing::section().unwrap();
    assert_eq!(section.body.matches("<table>").count(), 4);
    assert_eq!(section.body.matches("<svg").count(), 2);
    assert!(section.body.contains("no principal logarithm: the eigenvalue -1"));
    assert!(!section.body.contains("NaN"));
    let detour =
        "Keys 2° apart on both sides of half a turn: C turns 358° on the way between them.";
    assert!(section.found.iter().any(|line| line == detour), "{:?}", section.found);
}
