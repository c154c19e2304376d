//! Representations of rotations and motions: each into each, and what nalgebra and glam say.

mod affine;
mod axis_angle;
mod each_to_each;
mod euler;
mod gram_schmidt;
mod polar;

use dq8::{DualQuat, Quat, Real};
use dq8_contract::inputs::{for_all, unit_motion};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion};
use std::cell::Cell;

/// `check` for 1000 random motions, the same in every run.
fn for_random_motions(check: impl Fn(DualQuat<f64>)) {
    for_all(1000, &unit_motion(), |motion| check(DualQuat::from_array(motion)));
}

/// Numbers of f64, rounded.
fn round<R: Real, const N: usize>(numbers: [f64; N]) -> [R; N] {
    numbers.map(R::from_f64)
}

/// Numbers as f64, exact.
fn exact<R: Real, const N: usize>(numbers: [R; N]) -> [f64; N] {
    numbers.map(Into::into)
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

/// The angle between two rotations, radians: twice the chord of the quaternions, so small angles are
/// not lost.
fn between(a: UnitQuaternion<f64>, b: UnitQuaternion<f64>) -> f64 {
    let chord = (a.into_inner() - b.into_inner()).norm();
    2.0 * chord.min((a.into_inner() + b.into_inner()).norm())
}

/// The worst of many errors, in units of the last place of 1.
struct Worst {
    what: &'static str,
    epsilon: f64,
    bound: f64,
    seen: Cell<f64>,
}

impl Worst {
    fn new<R: Real>(what: &'static str, bound: f64) -> Self {
        Self { what, epsilon: R::EPSILON.into(), bound, seen: Cell::new(0.0) }
    }

    /// An error, which must be within the bound; NaN never is.
    fn see(&self, error: f64, case: &dyn std::fmt::Debug) {
        let units = error / self.epsilon;
        assert!(units <= self.bound, "{}: {units:.2} units off for {case:?}", self.what);
        self.seen.set(self.seen.get().max(units));
    }
}

/// A bound that is never neared checks nothing.
impl Drop for Worst {
    fn drop(&mut self) {
        let (seen, bound) = (self.seen.get(), self.bound);
        println!("{}: {seen:.2} of {bound}", self.what);
        if !std::thread::panicking() {
            assert!(4.0 * seen >= bound, "{}: {seen:.2} seen, {bound} allowed", self.what);
        }
    }
}
