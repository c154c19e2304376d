//! Distances of motions: metric axioms, precision, edges, and lanes against the scalar reference.

use dq8::DualQuat;
use dq8_contract::implementation::{On, implementations};
use dq8_contract::inputs::{proptest_config, turn_and_move, unit_motion, vector};
use dq8_contract::lanes::{Motions, Reals};
use dq8_contract::ledger::{Ledger, line};
use dq8_contract::scale::farthest as length;
use proptest::prelude::*;
use std::f64::consts::PI;

/// Half a unit of the last place of 13 in `f32`.
const IN_SINGLE: f64 = 0.5e-6;

/// For points and shells, in units of which the body is a few large.
const RADIUS: f64 = 5.0;
const POINT: [f64; 3] = [3.0, -2.4, 3.2];

/// The five distances, by name.
fn distances(on: On, a: Motions, b: Motions) -> [(&'static str, Reals); 5] {
    [
        ("angle_to", a.angle_to(b)),
        ("distance_to", a.distance_to(b)),
        ("distance_weighted", a.distance_weighted(b, on.splat(0.75))),
        ("point_error", a.point_error(b, POINT.map(|c| on.splat(c)))),
        ("shell_error", a.shell_error(b, on.splat(RADIUS))),
    ]
}

fn axioms(on: On, poses: [[f64; 8]; 3], common: [f64; 8]) {
    let [a, b, c] = poses.map(|pose| on.same(pose));
    let slack = 64.0 * on.roundoff() * (length(&poses) + length(&[common]) + RADIUS);
    let ab = distances(on, a, b).map(|(_, d)| d.first());
    let ba = distances(on, b, a).map(|(_, d)| d.first());
    let bc = distances(on, b, c).map(|(_, d)| d.first());
    let named = distances(on, a, c);
    for (i, (what, ac)) in named.into_iter().enumerate() {
        let ac = ac.first();
        assert!(ac >= 0.0, "{on:?}, {what} is negative: {ac}");
        assert!(ac <= ab[i] + bc[i] + slack, "{on:?}, {what}: {ac} > {} + {}", ab[i], bc[i]);
        // The products of the two orders differ in signs only, but not in the order of their sums.
        assert!((ab[i] - ba[i]).abs() <= slack, "{on:?}, {what}: {} and {}", ab[i], ba[i]);
    }
    for ((what, plain), (_, flipped)) in distances(on, a, b).into_iter().zip(distances(on, a, -b)) {
        assert_eq!(plain.lanes(), flipped.lanes(), "{on:?}, {what}: the sign of σ matters");
    }
    for (what, none) in distances(on, a, -a) {
        let none = none.first();
        assert!(none <= slack, "{on:?}, {what}: a pose is {none} from itself");
    }
    let common = on.same(common);
    for (i, (what, moved)) in distances(on, common * a, common * b).into_iter().enumerate() {
        let moved = moved.first();
        assert!((moved - ab[i]).abs() <= slack, "{on:?}, {what}: {moved} after a common motion");
    }
}

fn shell(on: On, [a, b]: [[f64; 8]; 2], direction: [f64; 3], share: f64) {
    let length_of = direction.iter().map(|c| c * c).sum::<f64>().sqrt();
    let point = direction.map(|c| on.splat(c / length_of * share * RADIUS));
    let slack = 64.0 * on.roundoff() * (length(&[a, b]) + RADIUS);
    let (a, b) = (on.same(a), on.same(b));
    let error = a.point_error(b, point).first();
    let bound = a.shell_error(b, on.splat(RADIUS)).first();
    assert!(error <= bound + slack, "{on:?}: {error} at a point, {bound} at most");
}

proptest! {
    #![proptest_config(proptest_config(64))]

    #[test]
    fn distances_are_metrics(
        poses in prop::array::uniform3(unit_motion()),
        common in unit_motion(),
    ) {
        implementations().into_iter().for_each(|on| axioms(on, poses, common));
    }

    #[test]
    fn the_shell_bounds_every_point_within(
        poses in prop::array::uniform2(unit_motion()),
        direction in vector().prop_filter("it has one", |v| v.iter().any(|c| c.abs() > 0.1)),
        share in 0.0..=1.0_f64,
    ) {
        implementations().into_iter().for_each(|on| shell(on, poses, direction, share));
    }
}

#[test]
fn the_bound_of_the_shell_is_reached_across_the_axis() {
    for on in implementations() {
        // Half a turn about z takes (−5,0,0) to (5,0,0), and then on by 3.
        let [a, b] = [0.0, PI]
            .map(|angle| turn_and_move([0.0, 0.0, 1.0], angle, [3.0 * angle / PI, 0.0, 0.0]));
        let (a, b) = (on.same(a), on.same(b));
        let far = a.point_error(b, [-RADIUS, 0.0, 0.0].map(|c| on.splat(c))).first();
        assert!((far - 13.0).abs() < IN_SINGLE, "{on:?}: {far}");
        let bound = a.shell_error(b, on.splat(RADIUS)).first();
        assert!((bound - 13.0).abs() < IN_SINGLE, "{on:?}: {bound}");
    }
}

#[test]
fn angles_are_precise_from_the_smallest_to_half_a_turn() {
    fn check(on: On, ledger: &Ledger) {
        let u = on.roundoff();
        let axis = [0.6, -0.48, 0.64];
        let none = on.same(turn_and_move(axis, 0.0, [1.0, 2.0, 3.0]));
        let measure = |angle: f64| {
            let pose = on.same(turn_and_move(axis, angle, [0.0; 3]));
            let [there, back] = [none.angle_to(pose), (-pose).angle_to(none)].map(|d| d.first());
            assert_eq!(there.to_bits(), back.to_bits(), "{on:?}: {angle:e}");
            there
        };
        assert_eq!(measure(0.0).to_bits(), 0, "{on:?}");
        for exponent in 1..=if on.single { 37 } else { 300 } {
            let angle = 10.0_f64.powi(-exponent);
            let off = (measure(angle) / angle - 1.0).abs() / u;
            ledger.measure("angle_to", "tiny", off, || format!("{on:?}: {angle:e}"));
        }
        let compare = |measured: f64, angle: f64, place: &dyn Fn() -> String| {
            ledger.measure("angle_to", "", (measured - angle).abs() / u, place);
        };
        for step in 0..=64 {
            let angle = PI * f64::from(step) / 64.0;
            compare(measure(angle), angle, &|| format!("{on:?}: {angle}"));
        }
        for exponent in 1..=16 {
            let angle = PI - 10.0_f64.powi(-exponent);
            let measured = measure(angle);
            compare(measured, angle, &|| format!("{on:?}: {angle}"));
            assert!(measured <= if on.single { f64::from(std::f32::consts::PI) } else { PI });
        }
        // Half a turn about any axis, though |p| is rounded up for some.
        for step in 0..500 {
            let (latitude, longitude) = (0.01 * f64::from(step), 2.4 * f64::from(step));
            let (level, up) = (latitude.cos(), latitude.sin());
            let axis = [level * longitude.cos(), level * longitude.sin(), up];
            let pose = on.same(turn_and_move(axis, PI, [0.0; 3]));
            let measured = none.angle_to(pose).first();
            compare(measured, PI, &|| format!("{on:?}: half a turn about {axis:?}"));
            assert!(measured <= if on.single { f64::from(std::f32::consts::PI) } else { PI });
        }
        // Subnormal, beside the identity.
        let least = if on.single { f64::from(f32::from_bits(3)) } else { f64::from_bits(3) };
        let one = on.same([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
        let tiny = on.same([0.0, 0.0, least, 1.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(one.angle_to(tiny).first().to_bits(), (2.0 * least).to_bits(), "{on:?}");
    }
    let lines = [
        line(
            "angle_to",
            &["tiny"],
            6.0,
            "the scale is the angle itself: nothing cancels beside no turn",
        ),
        line("angle_to", &[], 13.0, "angles are up to π, of which 1 ulp is 4 u"),
    ];
    Ledger::keep("angles", &lines, |ledger| {
        implementations().into_iter().for_each(|on| check(on, ledger));
    });
}

#[test]
fn lengths_neither_overflow_nor_vanish_on_the_way() {
    fn check(on: On, ledger: &Ledger) {
        let exponents = if on.single { [-36, -25, 25, 36] } else { [-300, -200, 200, 300] };
        let at = |t: [f64; 3]| on.same(DualQuat::from_translation(t).to_array());
        for size in exponents.map(|e| 10.0_f64.powi(e)) {
            let (a, b) = (at([size, 0.0, -size]), at([-2.0 * size, 0.0, 3.0 * size]));
            let close = |what: &str, got: Reals| {
                let off = (got.first() / size / 5.0 - 1.0).abs();
                let off = off / on.roundoff();
                ledger.measure(what, "", off, || format!("{on:?}: {size:e}"));
            };
            close("distance_to", a.distance_to(b));
            close("point_error", a.point_error(b, [0.0; 3].map(|c| on.splat(c))));
            close("shell_error", a.shell_error(b, on.splat(1.0)));
            close("distance_weighted", a.distance_weighted(b, on.splat(1.0)));
        }
    }
    let why = "lengths neither overflow nor vanish on the way";
    let distances = ["distance_to", "distance_weighted", "point_error", "shell_error"];
    Ledger::keep("lengths of any size", &distances.map(|op| line(op, &[], 3.0, why)), |ledger| {
        implementations().into_iter().for_each(|on| check(on, ledger));
    });
}

#[test]
fn drift_needs_renormalization() {
    for on in implementations() {
        let motion = DualQuat::from_array(turn_and_move([1.0, 2.0, 2.0], 0.5, [40.0, 2.0, 3.0]));
        let tolerance = on.splat(1e-3);
        let needs = |motion: DualQuat<f64>| {
            let bits = on.same(motion.to_array()).needs_renormalization(tolerance);
            assert!(bits == 0 || bits == (1 << on.lanes) - 1, "{on:?}: lanes differ");
            bits != 0
        };
        assert!(!needs(motion) && !needs(-motion) && !needs(motion.scale(1.0005)), "{on:?}");
        assert!(needs(motion.scale(1.002)) && needs(motion.scale(0.998)), "{on:?}");
        assert!(needs(motion.scale(0.0)), "{on:?}: zero is no motion");
        // A dual part along the real one is no translation (Fabisch); it is measured against |q|.
        let along = |by: f64| DualQuat::new(motion.real(), motion.dual() + motion.real().scale(by));
        assert!(needs(along(0.1)) && !needs(along(0.01)), "{on:?}");
        assert!(!needs(along(0.1).normalize()), "{on:?}");
    }
}
