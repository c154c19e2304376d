//! Axes, angles and directions.

use super::{Provable, lane, lanes, row};
use dq8::{Quat, batch};
use dq8_contract::bound::{exact, rounded, roundoff};
use dq8_contract::on_every_lane_type;

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
            assert!((got - wanted).abs() <= 4.0 * roundoff::<L::Real>() * wanted, "{q:?}");
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
}

#[test]
fn axes_and_directions_at_the_edges_are_those_of_the_scalar_reference() {
    on_every_lane_type!(axes_at_the_edges());
}
