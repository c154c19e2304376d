//! Interpolation between close poses, beyond both of them.

use crate::{allowed, only};
use dq8::DualQuat;
use dq8_contract::bound::within;
use dq8_contract::implementation::implementations;
use dq8_contract::inputs::turn_and_move;

#[test]
fn interpolation_between_close_poses_goes_on_straight_beyond_both() {
    for on in implementations() {
        let relative = allowed(on, within(2.5, "as pow; the scale is the angle itself"));
        let a = on.same(DualQuat::<f64>::IDENTITY.to_array());
        let b = on.same(turn_and_move([0.0, 0.0, 1.0], 1e-4, [0.0, 0.0, 1e-4]));
        for t in [-1e4, -1.0, 0.5, 2.0, 1e4] {
            let half = 0.5 * 1e-4 * t;
            let got = only(a.sclerp(b, on.splat(t)));
            let error = (got[2] - half.sin()).abs();
            assert!(error <= relative * half.abs(), "{on:?}, t = {t}: {} {}", got[2], half.sin());
            let error = (got[6] - half * half.cos()).abs();
            assert!(error <= relative * half.abs(), "{on:?}, t = {t}: {}", got[6]);
        }
    }
}

/// Where an angle is its own sine, a multiple of it need not be.
#[test]
fn rotations_that_are_close_go_on_turning_beyond_both() {
    for on in implementations() {
        let relative = allowed(on, within(3.0, "the angle and t are rounded; a multiple, a sine"));
        let a = on.same(DualQuat::<f64>::IDENTITY.to_array());
        for angle in [1e-4, 1e-9] {
            let b = on.same(turn_and_move([0.0, 0.0, 1.0], angle, [angle, 0.0, 0.0]));
            for turned in [-3.0, -1.0, 0.5 * angle, 2.0 * angle, 1.0, 3.0] {
                let t = turned / angle;
                let [_, _, z, w, ..] = only(a.slerp_lerp(b, on.splat(t)));
                let (sin, cos) = (0.5 * turned).sin_cos();
                let error = (z - sin).abs();
                assert!(error <= relative * turned.abs(), "{on:?}, {angle:e}, {t:e}: {z} {sin}");
                let error = (w - cos).abs();
                // Lanes, and floats that go by them, turn in the plane of the ends as they are.
                let by_the_book = on.name.starts_with("textbook");
                let size = if by_the_book { turned.abs().max(1.0) } else { 1.0 + t.abs() };
                assert!(error <= relative * size, "{on:?}, {angle:e}, {t:e}: {w} {cos}");
            }
        }
    }
}
