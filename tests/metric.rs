//! Distances of motions: metric axioms, precision, edges, and lanes against the scalar reference.

use dq8::DualQuat;
use dq8_contract::cluster::{Cluster, Dealt, cluster, length};
use dq8_contract::inputs::{for_all, proptest_config, turn_and_move, unit_motion, vector};
use dq8_contract::ledger::Ledger;
use dq8_contract::tolerance::unit_roundoff;
use dq8_contract::{for_every_implementation, sample::Sample};
use proptest::collection::vec;
use proptest::prelude::*;
use std::f64::consts::PI;

/// As many as the most lanes there are.
const CASES: usize = 16;
/// For points and shells, in units of which the body is a few large.
const RADIUS: f64 = 5.0;
const POINT: [f64; 3] = [3.0, -2.4, 3.2];

fn number<M: Sample>(real: M::Real) -> f64 {
    M::lanes(real)[0]
}

fn all_lanes<M: Sample>(pose: [f64; 8]) -> M {
    M::gather(&vec![pose; M::LANES])
}

/// The five distances, by name.
fn distances<M: Sample>(a: M, b: M) -> [(&'static str, M::Real); 5] {
    [
        ("angle_to", a.angle_to(b)),
        ("distance_to", a.distance_to(b)),
        ("distance_weighted", a.distance_weighted(b, M::splat(0.75))),
        ("point_error", a.point_error(b, POINT.map(M::splat))),
        ("shell_error", a.shell_error(b, M::splat(RADIUS))),
    ]
}

fn reference<M: Sample>(name: &str, clusters: &[Cluster], ledger: &Ledger) {
    let x = Dealt::<M>::new(clusters);
    let [a, b, ..] = x.poses;
    for ((what, plain), (_, flipped)) in distances(a, b).into_iter().zip(distances(a, -b)) {
        assert_eq!(M::lanes(plain), M::lanes(flipped), "{name}, {what}: the sign of σ matters");
        for (lane, got) in M::lanes(plain).into_iter().enumerate() {
            let exact = x.lane(lane);
            let [a, b, ..] = exact.poses;
            let wanted = distances(a, b).into_iter().find(|(other, _)| *other == what);
            let wanted = wanted.expect("the names are the same").1;
            let scale = match what {
                "angle_to" => PI,
                "distance_to" | "distance_weighted" => length(&[a.to_array(), b.to_array()]),
                _ => length(&[a.to_array(), b.to_array()]) + RADIUS,
            };
            let off = (got - wanted).abs() / scale / unit_roundoff(M::SINGLE);
            ledger.measure(what, "", off, || format!("{name}: {a:?} {b:?}"));
        }
    }
}

fn axioms<M: Sample>(name: &str, poses: [[f64; 8]; 3], common: [f64; 8]) {
    let [a, b, c] = poses.map(all_lanes::<M>);
    let slack = 64.0 * unit_roundoff(M::SINGLE) * (length(&poses) + length(&[common]) + RADIUS);
    let ab = distances(a, b).map(|(_, d)| number::<M>(d));
    let ba = distances(b, a).map(|(_, d)| number::<M>(d));
    let bc = distances(b, c).map(|(_, d)| number::<M>(d));
    let named = distances(a, c);
    for (i, (what, ac)) in named.into_iter().enumerate() {
        let ac = number::<M>(ac);
        assert!(ac >= 0.0, "{name}, {what} is negative: {ac}");
        assert!(ac <= ab[i] + bc[i] + slack, "{name}, {what}: {ac} > {} + {}", ab[i], bc[i]);
        // The products of the two orders differ in signs only, but not in the order of their sums.
        assert!((ab[i] - ba[i]).abs() <= slack, "{name}, {what}: {} and {}", ab[i], ba[i]);
    }
    for (what, none) in distances(a, -a) {
        let none = number::<M>(none);
        assert!(none <= slack, "{name}, {what}: a pose is {none} from itself");
    }
    let common = all_lanes::<M>(common);
    for (i, (what, moved)) in distances(common * a, common * b).into_iter().enumerate() {
        let moved = number::<M>(moved);
        assert!((moved - ab[i]).abs() <= slack, "{name}, {what}: {moved} after a common motion");
    }
}

fn shell<M: Sample>(name: &str, [a, b]: [[f64; 8]; 2], direction: [f64; 3], share: f64) {
    let length_of = direction.iter().map(|c| c * c).sum::<f64>().sqrt();
    let point = direction.map(|c| M::splat(c / length_of * share * RADIUS));
    let slack = 64.0 * unit_roundoff(M::SINGLE) * (length(&[a, b]) + RADIUS);
    let (a, b) = (all_lanes::<M>(a), all_lanes::<M>(b));
    let error = number::<M>(a.point_error(b, point));
    let bound = number::<M>(a.shell_error(b, M::splat(RADIUS)));
    assert!(error <= bound + slack, "{name}: {error} at a point, {bound} at most");
}

proptest! {
    #![proptest_config(proptest_config(64))]

    #[test]
    fn distances_are_metrics(
        poses in prop::array::uniform3(unit_motion()),
        common in unit_motion(),
    ) {
        for_every_implementation!(|name, M| axioms::<M>(name, poses, common));
    }

    #[test]
    fn the_shell_bounds_every_point_within(
        poses in prop::array::uniform2(unit_motion()),
        direction in vector().prop_filter("it has one", |v| v.iter().any(|c| c.abs() > 0.1)),
        share in 0.0..=1.0_f64,
    ) {
        for_every_implementation!(|name, M| shell::<M>(name, poses, direction, share));
    }
}

#[test]
fn lanes_measure_as_the_scalar_reference_does() {
    Ledger::keep("distances", |ledger| {
        for_all(64, &vec(cluster(), CASES), |clusters| {
            for_every_implementation!(|name, M| {
                for chunk in clusters.chunks_exact(<M as Sample>::LANES) {
                    reference::<M>(name, chunk, ledger);
                }
            });
        });
    });
}

#[test]
fn the_bound_of_the_shell_is_reached_across_the_axis() {
    fn check<M: Sample>(name: &str) {
        // Half a turn about z takes (−5,0,0) to (5,0,0), and then on by 3.
        let [a, b] = [0.0, PI]
            .map(|angle| turn_and_move([0.0, 0.0, 1.0], angle, [3.0 * angle / PI, 0.0, 0.0]));
        let (a, b) = (all_lanes::<M>(a), all_lanes::<M>(b));
        let far = number::<M>(a.point_error(b, [-RADIUS, 0.0, 0.0].map(M::splat)));
        assert!((far - 13.0).abs() < 1e-5, "{name}: {far}");
        let bound = number::<M>(a.shell_error(b, M::splat(RADIUS)));
        assert!((bound - 13.0).abs() < 1e-5, "{name}: {bound}");
    }
    for_every_implementation!(|name, M| check::<M>(name));
}

#[test]
fn angles_are_precise_from_the_smallest_to_half_a_turn() {
    fn check<M: Sample>(name: &str, ledger: &Ledger) {
        let u = unit_roundoff(M::SINGLE);
        let axis = [0.6, -0.48, 0.64];
        let none = all_lanes::<M>(turn_and_move(axis, 0.0, [1.0, 2.0, 3.0]));
        let measure = |angle: f64| {
            let pose = all_lanes::<M>(turn_and_move(axis, angle, [0.0; 3]));
            let [there, back] = [none.angle_to(pose), (-pose).angle_to(none)].map(number::<M>);
            assert_eq!(there.to_bits(), back.to_bits(), "{name}: {angle:e}");
            there
        };
        assert_eq!(measure(0.0).to_bits(), 0, "{name}");
        for exponent in 1..=if M::SINGLE { 37 } else { 300 } {
            let angle = 10.0_f64.powi(-exponent);
            let off = (measure(angle) / angle - 1.0).abs() / u;
            ledger.measure("angle_to", "tiny", off, || format!("{name}: {angle:e}"));
        }
        let compare = |measured: f64, angle: f64, place: &dyn Fn() -> String| {
            ledger.measure("angle_to", "", (measured - angle).abs() / u, place);
        };
        for step in 0..=64 {
            let angle = PI * f64::from(step) / 64.0;
            compare(measure(angle), angle, &|| format!("{name}: {angle}"));
        }
        for exponent in 1..=16 {
            let angle = PI - 10.0_f64.powi(-exponent);
            let measured = measure(angle);
            compare(measured, angle, &|| format!("{name}: {angle}"));
            assert!(measured <= if M::SINGLE { f64::from(std::f32::consts::PI) } else { PI });
        }
        // Half a turn about any axis, though |p| is rounded up for some.
        for step in 0..500 {
            let (latitude, longitude) = (0.01 * f64::from(step), 2.4 * f64::from(step));
            let (level, up) = (latitude.cos(), latitude.sin());
            let axis = [level * longitude.cos(), level * longitude.sin(), up];
            let pose = all_lanes::<M>(turn_and_move(axis, PI, [0.0; 3]));
            let measured = number::<M>(none.angle_to(pose));
            compare(measured, PI, &|| format!("{name}: half a turn about {axis:?}"));
            assert!(measured <= if M::SINGLE { f64::from(std::f32::consts::PI) } else { PI });
        }
        // Subnormal, beside the identity.
        let least = if M::SINGLE { f64::from(f32::from_bits(3)) } else { f64::from_bits(3) };
        let one = all_lanes::<M>([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
        let tiny = all_lanes::<M>([0.0, 0.0, least, 1.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(number::<M>(one.angle_to(tiny)).to_bits(), (2.0 * least).to_bits(), "{name}");
    }
    Ledger::keep("angles", |ledger| {
        for_every_implementation!(|name, M| check::<M>(name, ledger));
    });
}

#[test]
fn lengths_neither_overflow_nor_vanish_on_the_way() {
    fn check<M: Sample>(name: &str, ledger: &Ledger) {
        let exponents = if M::SINGLE { [-36, -25, 25, 36] } else { [-300, -200, 200, 300] };
        let at = |t: [f64; 3]| all_lanes::<M>(DualQuat::from_translation(t).to_array());
        for size in exponents.map(|e| 10.0_f64.powi(e)) {
            let (a, b) = (at([size, 0.0, -size]), at([-2.0 * size, 0.0, 3.0 * size]));
            let close = |what: &str, got: M::Real| {
                let off = (number::<M>(got) / size / 5.0 - 1.0).abs();
                let off = off / unit_roundoff(M::SINGLE);
                ledger.measure(what, "", off, || format!("{name}: {size:e}"));
            };
            close("distance_to", a.distance_to(b));
            close("point_error", a.point_error(b, [0.0; 3].map(M::splat)));
            close("shell_error", a.shell_error(b, M::splat(1.0)));
            close("distance_weighted", a.distance_weighted(b, M::splat(1.0)));
        }
    }
    Ledger::keep("lengths of any size", |ledger| {
        for_every_implementation!(|name, M| check::<M>(name, ledger));
    });
}

#[test]
fn what_is_not_finite_is_no_distance_and_leaves_other_lanes_alone() {
    fn check<M: Sample>(name: &str) {
        let (a, b) = (
            turn_and_move([1.0, 2.0, 2.0], 0.5, [1.0, 2.0, 3.0]),
            turn_and_move([0.0, 0.0, 1.0], 1.0, [0.0; 3]),
        );
        let wanted = distances(all_lanes::<M>(a), all_lanes::<M>(b));
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for component in 0..8 {
                let mut lanes = vec![b; M::LANES];
                lanes[0][component] = value;
                let spoilt = M::gather(&lanes);
                let got = distances(all_lanes::<M>(a), spoilt);
                for ((what, got), (_, wanted)) in got.into_iter().zip(wanted) {
                    let (got, wanted) = (M::lanes(got), M::lanes(wanted));
                    if what == "angle_to" && component > 3 {
                        assert_eq!(got, wanted, "{name}: translations have no angle");
                        continue;
                    }
                    let what = format!("{name}, {what} with {value} in {component}: {}", got[0]);
                    assert!(got[0].is_nan() || got[0] == f64::INFINITY, "{what}");
                    assert_eq!(got[1..], wanted[1..], "{what}");
                }
                let needs = M::bits(spoilt.needs_renormalization(M::splat(1e-3)));
                assert_eq!(needs, 1, "{name}: {value} in {component}");
            }
        }
    }
    for_every_implementation!(|name, M| check::<M>(name));
}

#[test]
fn drift_needs_renormalization() {
    fn check<M: Sample>(name: &str) {
        let motion = DualQuat::from_array(turn_and_move([1.0, 2.0, 2.0], 0.5, [40.0, 2.0, 3.0]));
        let tolerance = M::splat(1e-3);
        let needs = |motion: DualQuat<f64>| {
            let bits = M::bits(all_lanes::<M>(motion.to_array()).needs_renormalization(tolerance));
            assert!(bits == 0 || bits == (1 << M::LANES) - 1, "{name}: lanes differ");
            bits != 0
        };
        assert!(!needs(motion) && !needs(-motion) && !needs(motion.scale(1.0005)), "{name}");
        assert!(needs(motion.scale(1.002)) && needs(motion.scale(0.998)), "{name}");
        assert!(needs(motion.scale(0.0)), "{name}: zero is no motion");
        // A dual part along the real one is no translation (Fabisch); it is measured against |q|.
        let along = |by: f64| DualQuat::new(motion.real(), motion.dual() + motion.real().scale(by));
        assert!(needs(along(0.1)) && !needs(along(0.01)), "{name}");
        assert!(!needs(along(0.1).normalize()), "{name}");
    }
    for_every_implementation!(|name, M| check::<M>(name));
}
