//! Axis and angle, as a pair and as a product.

use super::{between, opinion, worst};
use core::f64::consts::PI;
use dq8::{Dual, Quat, Real};
use dq8_contract::bound::{exact, rounded, roundoff};
use nalgebra::{UnitQuaternion, Vector3};

const AXES: [[f64; 3]; 4] =
    [[0.6, -0.48, 0.64], [1.0, 0.0, 0.0], [0.0, -0.8, 0.6], [1e-9, 0.0, -1.0]];

/// From tiny ones to a whole half turn, and close to it.
fn angles() -> impl Iterator<Item = f64> {
    let tiny = (0..=36).map(|decade| 10_f64.powi(-decade));
    let near_half = (0..=16).map(|decade| PI - 10_f64.powi(-decade));
    tiny.chain(near_half).chain((1..=24).map(|i| f64::from(i) * PI / 24.0))
}

#[test]
fn the_axis_and_the_angle_come_back_with_all_their_digits() {
    fn check<R: Real>() {
        let axes = worst("axis", 3.0, "sine and axis are rounded, and a root and a division");
        let turns = worst("angle", 4.0, "sine and cosine are rounded, and an arctangent");
        let products = worst("axis times angle", 4.0, "that of the angle, and a product");
        for axis in AXES {
            for angle in angles().map(R::from_f64) {
                let case = (axis, angle);
                let quat = Quat::from_axis_angle(rounded(axis), angle);
                for quat in [quat, -quat] {
                    let (found, turn) = quat.to_axis_angle();
                    // At half a turn both of ±axis are right, and rounding chooses.
                    let sign = if Into::<f64>::into(angle) < PI - 1e-6 {
                        1.0
                    } else {
                        (0..3).map(|i| Into::<f64>::into(found[i]) * axis[i]).sum::<f64>().signum()
                    };
                    let (turn, angle): (f64, f64) = (turn.into(), angle.into());
                    let off = Vector3::from(exact(found)) * sign - Vector3::from(axis);
                    axes.see(off.norm(), roundoff::<R>(), &case);
                    turns.see(turn - angle, roundoff::<R>() * angle, &case);
                    let product = Vector3::from(exact(quat.to_scaled_axis())) * sign / angle;
                    products.see((product - Vector3::from(axis)).norm(), roundoff::<R>(), &case);
                }
            }
        }
    }
    check::<f32>();
    check::<f64>();
}

#[test]
fn the_turn_by_a_vector_is_that_of_nalgebra() {
    fn check<R: Real>(allowed: f64) {
        let why = "half an angle of up to 3.2, of a sum of squares and a root, has the error of that angle";
        let worst = worst("turn by a vector", allowed, why);
        for axis in AXES {
            for angle in angles().chain([4.0, 6.0, 2.0 * PI]) {
                let v = rounded::<R, 3>(axis.map(|c| c * angle));
                let wanted = UnitQuaternion::from_scaled_axis(Vector3::from(exact(v)));
                let got = Quat::from_scaled_axis(v);
                worst.see(between(opinion(got), wanted), roundoff::<R>(), &(axis, angle));
                let length: f64 = (got.norm() - R::ONE).into();
                assert!(length.abs() <= 2.0 * R::EPSILON.into(), "{got:?} is not unit");
            }
        }
    }
    check::<f32>(4.0);
    check::<f64>(8.0);
}

#[test]
fn half_turns_are_by_pi_about_the_canonical_one_of_both_axes() {
    for axis in [[1.0_f32, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.6, 0.0, -0.8]] {
        for half in [0.0, -0.0].map(|w| Quat::from_parts(axis, w)).into_iter().flat_map(|q| [q, -q])
        {
            let turned = half.to_axis_angle();
            assert_eq!((turned.0, turned.1), (axis, core::f32::consts::PI));
            let scaled = half.to_scaled_axis();
            assert_eq!(scaled, axis.map(|c| c * core::f32::consts::PI));
        }
    }
}

#[test]
fn no_turn_is_by_zero_about_x() {
    for identity in [Quat::<f64>::IDENTITY, -Quat::IDENTITY] {
        assert_eq!(identity.to_axis_angle(), ([1.0, 0.0, 0.0], 0.0));
        assert_eq!(identity.to_scaled_axis(), [0.0; 3]);
    }
}

#[test]
fn subnormal_turns_are_neither_lost_nor_infinite() {
    let least = f32::from_bits(1);
    let turned = Quat::from_xyzw(0.0, least, 0.0, 1.0);
    assert_eq!(turned.to_axis_angle(), ([0.0, 1.0, 0.0], 2.0 * least));
    assert_eq!(turned.to_scaled_axis(), [0.0, 2.0 * least, 0.0]);
    let v = [2.0 * least, 0.0, 4000.0 * least];
    assert_eq!(Quat::from_scaled_axis(v).to_scaled_axis(), v);
}

/// The length of so short a vector has but a few digits; its direction has them all.
#[test]
fn the_axis_of_a_subnormal_turn_is_unit() {
    for places in [1, 2, 5, 40, 700, 100_000] {
        let c = |factor: f32| factor * places as f32 * f32::from_bits(1);
        let (axis, angle) = Quat::from_xyzw(c(3.0), c(-5.0), c(4.0), 1.0).to_axis_angle();
        let length = 50.0_f64.sqrt();
        for (got, wanted) in axis.into_iter().zip([3.0, -5.0, 4.0]) {
            assert!(
                (f64::from(got) - wanted / length).abs() < 0.75 * f64::from(f32::EPSILON),
                "{places}: {axis:?}"
            );
        }
        assert!(angle > 0.0);
    }
}

#[test]
fn what_is_not_finite_becomes_nan() {
    for bad in [f32::NAN, f32::INFINITY] {
        let quat = Quat::from_scaled_axis([1.0, bad, 0.0]);
        assert!(quat.to_array().iter().any(|c| c.is_nan()), "{quat:?}");
        let (axis, angle) = Quat::from_xyzw(0.0, bad, 0.0, bad).to_axis_angle();
        assert!(axis[1].is_nan() || angle.is_nan(), "{axis:?} {angle}");
        assert!(Quat::from_xyzw(0.0, bad, 0.0, bad).to_scaled_axis()[1].is_nan());
    }
}

/// Where the length has none: d/dv of exp(v/2) at 0 is ½, of the way back 2.
#[test]
fn both_ways_have_a_derivative_at_no_turn() {
    let v = [0.0, 1.0, 2.0].map(|slope| Dual::new(0.0_f64, slope));
    let quat = Quat::from_scaled_axis(v);
    assert_eq!(quat.to_array().map(|c| c.dual), [0.0, 0.5, 1.0, 0.0]);
    assert_eq!(quat.to_scaled_axis().map(|c| c.dual), [0.0, 1.0, 2.0]);
}
