//! Representations of rotations and motions: each into each, and what nalgebra and glam say.

mod affine;
mod axis_angle;
mod each_to_each;
mod euler;
mod gram_schmidt;
mod polar;

use dq8::{DualQuat, Quat, Real};
use dq8_contract::{
    bound::{exact, within},
    inputs::{for_all, unit_motion},
    worst::Worst,
};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion};

/// `check` for 1000 random motions, the same in every run.
fn for_random_motions(check: impl Fn(DualQuat<f64>)) {
    for_all(1000, &unit_motion(), |motion| check(DualQuat::from_array(motion)));
}

fn round_rows<R: Real>(rows: Matrix3<f64>) -> [[R; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| R::from_f64(rows[(i, j)])))
}

fn exact_rows<R: Real>(rows: [[R; 3]; 3]) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| rows[i][j].into())
}

/// What nalgebra makes of the components.
fn opinion<R: Real>(quat: Quat<R>) -> UnitQuaternion<f64> {
    let [w, x, y, z] = exact(quat.to_wxyz());
    UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z))
}

/// The angle between two rotations, radians: twice the chord of the quaternions, so small angles
/// are not lost.
fn between(a: UnitQuaternion<f64>, b: UnitQuaternion<f64>) -> f64 {
    let chord = (a.into_inner() - b.into_inner()).norm();
    2.0 * chord.min((a.into_inner() + b.into_inner()).norm())
}

/// The largest error allowed, in units of the roundoff of the type, and why.
fn worst(name: &'static str, units: f64, reason: &'static str) -> Worst {
    Worst::of(name, within(units, reason))
}
