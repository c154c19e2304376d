//! Axes, angles and directions at the edges.

use super::{Provable, exact, holds, lane, lanes, on_every_level, rounded, row};
use dq8::representation::EulerOrder;
use dq8::{Quat, batch};
use std::f64::consts::FRAC_1_SQRT_2;

fn axes_at_the_edges<L: Provable>() {
    let nan = f64::NAN;
    // No turn, of both signs, half a turn with w of either sign, and what is no rotation.
    for q in [
        [0.0, 0.0, 0.0, 1.0],
        [0.0, 0.0, 0.0, -1.0],
        [-0.0, -0.0, -0.0, 1.0],
        [0.0, 1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0, -0.0],
        [1e-40, 0.0, 0.0, 1.0],
        [0.0, -1e-40, 0.0, -1.0],
        [nan, 0.0, 0.0, 1.0],
        [0.0, 0.0, 0.0, nan],
    ] {
        let (axis, angle) = batch::Quat::from_array(q.map(|c| lanes::<L>(&[c]))).to_axis_angle();
        let by_the_book = Quat::<L::Real>::from_array(rounded(q)).to_axis_angle();
        let (by_axis, by_angle) = by_the_book;
        let (got, wanted): (f64, f64) = (lane(angle, 0), by_angle.into());
        if q.iter().any(|c| c.is_nan()) {
            assert!(got.is_nan() && wanted.is_nan(), "{q:?}");
        } else {
            assert_eq!(row(axis, 0), exact(by_axis), "{q:?}");
            assert!((got - wanted).abs() <= 4.0 * super::roundoff::<L>() * wanted, "{q:?}");
        }
    }
    for (from, to) in [([1.0, 0.0, 0.0], [-2.0, 0.0, 0.0]), ([0.0, 3.0, 0.0], [0.0, 3.0, 0.0])] {
        let turn =
            batch::Quat::from_rotation_arc(from.map(|c| lanes::<L>(&[c])), to.map(|c| lanes(&[c])));
        let wanted = Quat::<L::Real>::from_rotation_arc(rounded(from), rounded(to));
        assert_eq!(row(turn.to_array(), 0), exact(wanted.to_array()), "{from:?} {to:?}");
    }
    let none = batch::Quat::from_rotation_arc([lanes::<L>(&[0.0]); 3], [lanes(&[1.0]); 3]);
    assert!(row(none.to_array(), 0).iter().any(|c| c.is_nan()));
    let still = batch::Quat::from_scaled_axis([lanes::<L>(&[0.0]); 3]);
    assert_eq!(row(still.to_array(), 0), [0.0, 0.0, 0.0, 1.0]);
    for (forward, up) in [
        ([0.0; 3], [1.0; 3]),
        ([1.0; 3], [0.0; 3]),
        ([1.0; 3], [2.0; 3]),
        ([nan; 3], [1.0, 0.0, 0.0]),
    ] {
        let (look, failed) = batch::Quat::look_to_checked(
            forward.map(|c| lanes::<L>(&[c])),
            up.map(|c| lanes(&[c])),
        );
        assert!(Quat::<L::Real>::look_to(rounded(forward), rounded(up)).is_err());
        assert!(
            holds(failed, 0) && row(look.to_array(), 0).iter().all(|c| c.is_nan()),
            "{forward:?} {up:?}"
        );
    }
}

#[test]
fn axes_and_directions_at_the_edges_are_those_of_the_scalar_reference() {
    on_every_level!(axes_at_the_edges);
}

#[test]
fn euler_angles_of_what_is_no_number_are_none_on_lanes() {
    let nan = batch::Quat::from_array([f64::NAN, 0.0, 0.0, 1.0]).to_euler(EulerOrder::ALL[0]);
    assert!(nan.angles.angles.iter().all(|angle| angle.is_nan()) && !nan.gimbal_lock);
}

/// Half and quarter turns: zeros have signs, and the arctangent of a negative one may be −π instead of π.
fn signs_do_not_matter<L: Provable>() {
    let mut quats = Vec::new();
    for (at, sign) in [0, 1, 2, 3].into_iter().flat_map(|at| [(at, 1.0), (at, -1.0)]) {
        let (mut half, mut quarter) = ([0.0; 4], [0.0, 0.0, 0.0, FRAC_1_SQRT_2]);
        half[at] = sign;
        quarter[at % 3] = sign * FRAC_1_SQRT_2;
        quats.extend([half, quarter]);
    }
    for order in EulerOrder::ALL {
        for quat in &quats {
            let [one, other] = [1.0, -1.0].map(|sign| {
                let quat = batch::Quat::from_array(quat.map(|c| lanes::<L>(&[sign * c])));
                assert_eq!(row([quat.x(), quat.y(), quat.z()], 0), row(quat.xyz(), 0));
                row(quat.to_euler(order).angles.angles, 0).map(f64::to_bits)
            });
            assert_eq!(one, other, "{order:?} {quat:?}");
        }
    }
}

#[test]
fn a_quaternion_and_its_negative_have_the_same_euler_angles() {
    on_every_level!(signs_do_not_matter);
}
