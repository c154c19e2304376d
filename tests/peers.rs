//! What nalgebra's dual quaternions lose in `f32` and these keep, with the answer in `f64`.
//!
//! A peer that becomes better makes the first half of a test fail: then the claim is to be dropped.

use dq8::{
    DualQuat, Lanes, batch,
    simd::{Portable, f32x8},
};
use dq8_contract::bound::unit_roundoff;
use dq8_contract::ledger::{Ledger, line};
use nalgebra::{Quaternion, Translation3, UnitDualQuaternion, UnitQuaternion};

fn peer(motion: DualQuat<f32>) -> UnitDualQuaternion<f32> {
    let [x, y, z, w] = motion.rotation().to_array();
    let rotation = UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z));
    UnitDualQuaternion::from_parts(Translation3::from(motion.translation()), rotation)
}

fn from_peer(motion: UnitDualQuaternion<f32>) -> DualQuat<f64> {
    let [real, dual] = [motion.real, motion.dual].map(|q| [q.i, q.j, q.k, q.w]);
    let [[px, py, pz, pw], [qx, qy, qz, qw]] = [real, dual];
    DualQuat::from_array([px, py, pz, pw, qx, qy, qz, qw].map(f64::from))
}

fn exact(motion: DualQuat<f32>) -> DualQuat<f64> {
    motion.cast::<f64>().normalize()
}

fn pose(axis: [f64; 3], angle: f64, translation: [f64; 3]) -> DualQuat<f32> {
    let rotation = dq8::Quat::from_axis_angle(axis, angle);
    DualQuat::from_rotation_translation(rotation, translation).cast()
}

/// ScLERP by the scalar reference and by every lane.
fn ours(a: DualQuat<f32>, b: DualQuat<f32>, t: f32) -> Vec<DualQuat<f64>> {
    let lanes = |motion: DualQuat<f32>| batch::DualQuat::splat(Portable, motion);
    let mut records = [[0.0; 8]; 8];
    lanes(a).sclerp(lanes(b), <f32x8 as Lanes>::splat(Portable, t)).store_records(&mut records);
    let mut motions = vec![exact(a.sclerp(b, t))];
    motions.extend(records.map(|record| exact(DualQuat::from_array(record))));
    motions
}

const AXIS: [f64; 3] = [0.6, -0.48, 0.64];

fn small_rotations_that_nalgebra_freezes(ledger: &Ledger) {
    let start = DualQuat::<f32>::IDENTITY;
    let t = 0.5;
    for angle in [6.9e-4, 5e-4, 1e-4, 1e-5, 1e-7, 1e-12, 1e-20, 1e-35] {
        let end = pose(AXIS, angle, [1.0, 2.0, 3.0]);
        let truth = exact(start).sclerp(exact(end), f64::from(t));
        let turned = exact(start).angle_to(truth);
        assert!((turned / (0.5 * angle) - 1.0).abs() < 1e-6, "the truth is half of {angle}");

        let theirs = from_peer(peer(start).sclerp(&peer(end), t));
        assert_eq!(theirs.rotation(), exact(start).rotation(), "at {angle:e} nalgebra now turns");
        for motion in ours(start, end, t) {
            // Each component of the turn, relative to itself.
            for (ours, truth) in motion.rotation().xyz().into_iter().zip(truth.rotation().xyz()) {
                measure(ledger, "turn", (ours / truth - 1.0).abs(), angle);
            }
            let [x, y, z] = truth.translation();
            measure(ledger, "distance", motion.distance_to(truth) / x.hypot(y).hypot(z), angle);
        }
    }
}

fn close_poses_of_which_nalgebra_follows_one(ledger: &Ledger) {
    let t = 0.5;
    for angle in [5e-4, 2e-4, 1e-4, 5e-5] {
        let start = pose([0.0, 0.6, 0.8], 1.0, [1.0, 2.0, 3.0]);
        let end = start * pose(AXIS, angle, [0.0, 0.0, 0.1]);
        let truth = exact(start).sclerp(exact(end), f64::from(t));
        let theirs = from_peer(peer(start).sclerp(&peer(end), t)).normalize();
        let lost = theirs.angle_to(truth) / (0.5 * angle);
        assert!(lost > 0.9, "at {angle:e} nalgebra now loses only {lost}");
        for motion in ours(start, end, t) {
            measure(ledger, "angle", motion.angle_to(truth), angle);
        }
    }
}

fn measure(ledger: &Ledger, kind: &str, error: f64, angle: f64) {
    let units = error / unit_roundoff(true);
    ledger.measure("sclerp", kind, units, || format!("{angle:e}"));
}

#[test]
fn sclerp_keeps_what_nalgebra_loses() {
    let lines = &[
        line("sclerp", &["turn"], 2.0, "the vector part keeps its relative precision"),
        line("sclerp", &["distance"], 2.0, "the scale is |t| of the end"),
        line("sclerp", &["angle"], 1.5, "the angle between what is and what should be"),
    ];
    Ledger::keep("what nalgebra loses", lines, |ledger| {
        small_rotations_that_nalgebra_freezes(ledger);
        close_poses_of_which_nalgebra_follows_one(ledger);
    });
}

#[test]
fn sclerp_over_half_a_turn_has_an_answer_that_nalgebra_has_not() {
    let start = DualQuat::<f32>::IDENTITY;
    let end = DualQuat::from_rotation_translation(
        dq8::Quat::from_xyzw(0.0, 0.0, 1.0, 0.0),
        [0.0, 0.0, 4.0],
    );
    assert!(peer(start).try_sclerp(&peer(end), 0.5, f32::EPSILON).is_none());
    for motion in ours(start, end, 0.5) {
        let screw = motion.to_screw();
        assert!((screw.angle - std::f64::consts::FRAC_PI_2).abs() < 3e-7, "{}", screw.angle);
        assert!((screw.slide - 2.0).abs() < 1e-6, "{}", screw.slide);
    }
}
