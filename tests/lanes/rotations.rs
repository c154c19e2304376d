//! Axes, angles and directions.

use super::scene::{cases, quat, quats};
use super::{Provable, columns, exact, lane, lanes, measure, rounded, row};
use dq8::{Quat, batch};
use dq8_contract::ledger::{Ledger, line};
use dq8_contract::on_every_lane_type;

fn rotations_agree<L: Provable>(ledger: &Ledger) {
    for chunk in cases().chunks(L::LANES) {
        let q = quats::<L>(chunk, |case| case.a);
        let (v, w) = (columns::<L, _, 3>(chunk, |case| case.v), columns(chunk, |case| case.w));
        let (axis, angle) = q.to_axis_angle();
        let scaled = q.to_scaled_axis();
        let (arc, turn) = (batch::Quat::from_rotation_arc(v, w), batch::Quat::from_scaled_axis(v));
        let about = [
            batch::Quat::from_rotation_x(v[0]),
            batch::Quat::from_rotation_y(v[0]),
            batch::Quat::from_rotation_z(v[0]),
        ];
        for (index, case) in chunk.iter().enumerate() {
            let (q, v, w) = (quat(case.a), rounded(case.v), rounded(case.w));
            let (by_axis, by_angle): ([L::Real; 3], _) = q.to_axis_angle();
            let see = |name: &str, got: [f64; 4], wanted: [f64; 4], scale: f64| {
                measure::<L, 4>(ledger, (name, ""), got, wanted, scale, case);
            };
            let vector = |[x, y, z]: [f64; 3]| [x, y, z, 0.0];
            see("axis", vector(row(axis, index)), vector(exact(by_axis)), 1.0);
            // An angle keeps its relative precision, however small it is.
            let wanted: f64 = by_angle.into();
            see("angle", [lane(angle, index), 0.0, 0.0, 0.0], [wanted, 0.0, 0.0, 0.0], wanted);
            let wanted = vector(exact(q.to_scaled_axis()));
            see("to_scaled_axis", vector(row(scaled, index)), wanted, by_angle.into());
            let wanted = exact(Quat::<L::Real>::from_scaled_axis(v).to_array());
            see("from_scaled_axis", row(turn.to_array(), index), wanted, 1.0);
            let wanted = exact(Quat::<L::Real>::from_rotation_arc(v, w).to_array());
            see("from_rotation_arc", row(arc.to_array(), index), wanted, 1.0);
            let wanted = [
                Quat::from_rotation_x(v[0]),
                Quat::from_rotation_y(v[0]),
                Quat::from_rotation_z(v[0]),
            ];
            for (got, wanted) in about.into_iter().zip(wanted) {
                see(
                    "from_rotation_x, y, z",
                    row(got.to_array(), index),
                    exact(wanted.to_array()),
                    1.0,
                );
            }
        }
    }
}

#[test]
fn axes_angles_and_directions_on_lanes_are_those_of_the_scalar_reference() {
    #[rustfmt::skip]
    let bounds = [
        line("axis", &[], 2.0, "another length"),
        line("angle", &[], 6.5, "a polynomial, where scalar asks for an arctangent"),
        line("to_scaled_axis", &[], 4.5, "as the angle"),
        line("from_scaled_axis", &[], 5.0, "polynomials, where scalar asks the library"),
        line("from_rotation_arc", &[], 5.0, "three lengths and a normalization"),
        line("from_rotation_x, y, z", &[], 2.0, "polynomials, where scalar asks the library"),
    ];
    Ledger::keep("rotations", &bounds, |ledger| on_every_lane_type!(rotations_agree(ledger)));
}

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
}

#[test]
fn axes_and_directions_at_the_edges_are_those_of_the_scalar_reference() {
    on_every_lane_type!(axes_at_the_edges());
}
