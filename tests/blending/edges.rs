//! Where blends break: right angles, weights, what is not finite, tiny turns.

use super::{assert_same, dib, dlb, dlb_running, tolerance};
use dq8_contract::bound::apart;
use dq8_contract::implementation::{On, implementations, scalar_f64};
use dq8_contract::inputs::turn_and_move;
use dq8_contract::lanes::{Motions, Reals};
use dq8_contract::ledger::{Ledger, line};

/// Some units of the last place of 90 in `f32`.
const DEGREES: f64 = 2e-5;
/// And of 1.
const LENGTH: f64 = 5e-7;

/// The same influences in every lane.
fn everywhere<const N: usize>(on: On, poses: [([f64; 8], f64); N]) -> [(Motions, Reals); N] {
    poses.map(|(pose, weight)| (on.same(pose), on.splat(weight)))
}

fn turn(degrees: f64) -> [f64; 8] {
    turn_and_move([0.0, 0.0, 1.0], degrees.to_radians(), [0.0; 3])
}

/// The turn about z, degrees in (−180, 180], of the first lane.
fn degrees(motion: Motions) -> f64 {
    let [_, _, z, w, ..] = motion.canonical().scatter()[0];
    2.0 * z.atan2(w).to_degrees()
}

#[test]
fn without_influences_there_is_no_blend() {
    for on in implementations() {
        assert!(on.dlb(&[]).is_none(), "{on:?}");
        assert!(on.dlb_running(&[]).is_none(), "{on:?}");
        assert!(on.dib(&[], tolerance(on), 8).is_none(), "{on:?}");
    }
}

#[test]
fn the_running_sum_turns_what_the_first_influence_would_not() {
    for on in implementations() {
        let far = everywhere(on, [(turn(0.0), 1.0), (turn(120.0), 1.0), (turn(200.0), 1.0)]);
        assert!((degrees(dlb(&far)) + 8.12).abs() < 0.01, "{on:?}");
        assert!((degrees(dlb_running(&far)) - 108.74).abs() < 0.01, "{on:?}");
        // A first influence that weighs nothing has no say.
        let rest = [(turn(170.0), 1.0), (turn(190.0), 1.0)];
        let zero = everywhere(on, [(turn(0.0), 0.0), rest[0], rest[1]]);
        assert!(degrees(dlb(&zero)).abs() < 0.01, "{on:?}");
        assert!((degrees(dlb_running(&zero)).abs() - 180.0).abs() < 0.01, "{on:?}");
    }
}

#[test]
fn at_right_angles_the_sign_is_kept() {
    for on in implementations() {
        let half_turn = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        for sign in [1.0, -1.0] {
            let second = half_turn.map(|c| sign * c);
            let pair = everywhere(on, [(turn(0.0), 0.5), (second, 0.5)]);
            assert!((degrees(dlb_running(&pair)) - sign * 90.0).abs() < DEGREES, "{on:?}");
            assert!((degrees(dib(&pair)).abs() - 90.0).abs() < DEGREES, "{on:?}");
        }
    }
}

#[test]
fn weights_need_not_sum_to_one() {
    for on in implementations() {
        let poses = [turn_and_move([1.0, 2.0, 3.0], 0.7, [5.0, 0.0, 1.0]), turn(30.0), turn(80.0)];
        let blends = |factor: f64| {
            let weights = [0.5, 0.375, 0.125].map(|weight| factor * weight);
            let x: [_; 3] = everywhere(on, std::array::from_fn(|i| (poses[i], weights[i])));
            [dlb(&x), dlb_running(&x), dib(&x)]
        };
        let smallest = if on.single { 1e-39 } else { 1e-309 };
        for (factor, units) in [(0.125, 0.0), (2.0_f64.powi(90), 0.0), (3.0, 8.0)] {
            for (left, right) in blends(1.0).into_iter().zip(blends(factor)) {
                assert_same(&format!("{on:?}, times {factor}"), left, right, 10.0, units);
            }
        }
        // The running sum of negative weights points away from its motions.
        let ([first, _, mean], [first_, _, mean_]) = (blends(1.0), blends(-1.0));
        assert_same(&format!("{on:?}, negative"), first, first_, 1.0, 0.0);
        assert_same(&format!("{on:?}, negative"), mean, mean_, 1.0, 0.0);
        // Subnormal weights have few digits, but are weights.
        for (left, right) in blends(1.0).into_iter().zip(blends(smallest)) {
            assert_same(
                &format!("{on:?}, subnormal"),
                left,
                right,
                10.0,
                if on.single { 2e2 } else { 1e5 },
            );
        }
    }
}

#[test]
fn what_has_no_blend_is_nan_and_leaves_other_lanes_alone() {
    for on in implementations() {
        let good = [(turn(10.0), 0.75), (turn(50.0), 0.25)];
        let mut bad = vec![("zero", [([0.0; 8], 1.0), ([0.0; 8], 1.0)])];
        bad.push(("weights that cancel", [(turn(10.0), 1.0), (turn(10.0), -1.0)]));
        bad.push(("no weight", [(turn(10.0), 0.0), (turn(50.0), 0.0)]));
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            bad.push(("weight", [(turn(10.0), 1.0), (turn(50.0), value)]));
            for component in 0..8 {
                let mut pose = turn(50.0);
                pose[component] = value;
                bad.push(("component", [(turn(10.0), 1.0), (pose, 1.0)]));
                bad.push(("first component", [(pose, 1.0), (turn(10.0), 1.0)]));
            }
        }
        let wanted = everywhere(on, good);
        let wanted = [dlb(&wanted), dlb_running(&wanted), dib(&wanted)].map(|m| m.scatter());
        for (what, bad) in bad {
            let dealt: [(Motions, Reals); 2] = std::array::from_fn(|i| {
                let pick = |lane| if lane == 0 { bad[i] } else { good[i] };
                let (poses, weights): (Vec<_>, Vec<_>) = (0..on.lanes).map(pick).unzip();
                (on.gather(&poses), on.reals(&weights))
            });
            let mean = on.dib(&dealt, tolerance(on), 32).expect("there are influences");
            assert_eq!(mean.converged, (1 << on.lanes) - 2, "{on:?}, {what}: {bad:?}");
            assert!(mean.iterations.first() <= 1.0, "{on:?}, {what}: goes on for nothing");
            let blends = [dlb(&dealt), dlb_running(&dealt), mean.motion].map(|m| m.scatter());
            for (blend, wanted) in blends.iter().zip(&wanted) {
                assert!(blend[0].iter().any(|c| c.is_nan()), "{on:?}, {what}: {bad:?} {blend:?}");
                assert_eq!(blend[1..], wanted[1..], "{on:?}, {what}: {bad:?}");
            }
        }
        // A total of zero is no mean either, although the sum is no zero.
        let apart = everywhere(on, [(turn(10.0), 1.0), (turn(50.0), -1.0)]);
        let mean = on.dib(&apart, tolerance(on), 32).expect("there are influences");
        assert_eq!(mean.converged, 0, "{on:?}");
    }
}

#[test]
fn iterations_are_bounded_and_reported() {
    for on in implementations() {
        let spread = [turn(0.0), turn(40.0), turn_and_move([1.0, 0.0, 0.0], 1.0, [1.0, 2.0, 3.0])];
        let x = everywhere(on, spread.map(|pose| (pose, 1.0)));
        let all = (1 << on.lanes) - 1;
        for most in 0..2 {
            let mean = on.dib(&x, tolerance(on), most).expect("there are influences");
            assert_eq!(mean.converged, 0, "{on:?}");
            assert_eq!(mean.iterations.lanes(), vec![f64::from(most); on.lanes], "{on:?}");
        }
        let none = on.dib(&x, tolerance(on), 0).expect("there are influences").motion;
        assert_eq!(none.scatter(), dlb(&x).scatter(), "{on:?}");
        // A coarse tolerance takes fewer steps, and is kept for lengths as well as for angles.
        let fine = dib(&x);
        let coarse = on.dib(&x, on.splat(0.05), 8).expect("there are influences");
        assert_eq!(coarse.converged, all, "{on:?}");
        assert!(coarse.iterations.first() < 2.0, "{on:?}");
        assert!(apart(coarse.motion.scatter()[0], fine.scatter()[0], 1.0) < 0.1, "{on:?}");
        let alone = on.dib(&x[2..], tolerance(on), 8).expect("there is an influence");
        assert_eq!(alone.converged, all, "{on:?}");
        assert_eq!(alone.iterations.first().to_bits(), 0, "{on:?}");
    }
}

#[test]
fn tiny_turns_keep_their_precision() {
    fn check(on: On, ledger: &Ledger) {
        for exponent in 0..=37 {
            let angle = 10.0_f64.powi(-exponent);
            let pose = turn_and_move([1.0, 0.0, 0.0], angle, [0.0; 3]);
            let [start, end] = everywhere(on, [(turn(0.0), 1.0), (pose, 1.0)]);
            let (a, b) = (start.0, end.0);
            let close = |what: &str, motion: Motions, angle: f64| {
                let off = motion.scatter()[0][0] / (0.5 * angle).sin() - 1.0;
                let off = off.abs() / on.roundoff();
                ledger.measure(what, "", off, || format!("{on:?}: {angle:e}"));
            };
            close("slerp_lerp", a.slerp_lerp(b, on.splat(0.25)), 0.25 * angle);
            close("dlb_running", dlb_running(&[start, end]), 0.5 * angle);
            close("dib", dib(&[start, end]), 0.5 * angle);
        }
        // Below the normal numbers only the last place is lost, also where there is but one.
        for bits in 1..=3_u8 {
            let single = f64::from(f32::from_bits(bits.into()));
            let tiny = if on.single { single } else { f64::from_bits(bits.into()) };
            let pose = [tiny, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
            let [(a, _), (b, _)] = everywhere(on, [(turn(0.0), 1.0), (pose, 1.0)]);
            let [x, y, z, w, ..] = a.slerp_lerp(b, on.splat(0.5)).scatter()[0];
            assert_eq!([y, z, w], [0.0, 0.0, 1.0], "{on:?}: {tiny:e}");
            assert!((0.0..=tiny).contains(&x), "{on:?}: {x:e} is not half of {tiny:e}");
        }
    }
    let why = "no cancellation: the vector part keeps its relative precision";
    let lines = [("dlb_running", 4.5), ("dib", 4.5), ("slerp_lerp", 8.0)];
    let lines = lines.map(|(op, units)| line(op, &[], units, why));
    Ledger::keep("blends of tiny turns", &lines, |ledger| {
        implementations().into_iter().for_each(|on| check(on, ledger));
    });
}

#[test]
fn slerp_and_lerp_apart_go_straight_where_the_screw_goes_round() {
    for on in implementations() {
        let c = turn_and_move([0.0, 0.0, 1.0], 0.0, [1.0, 0.0, 0.0]);
        let [(a, _), (b, _), (c, _)] =
            everywhere(on, [(turn(0.0), 1.0), (turn(180.0), 1.0), (c, 1.0)]);
        let half = on.splat(0.5);
        let distance = |motion: Motions| {
            let [x, y, _] = motion.translation().map(|c| c.first());
            x.hypot(y)
        };
        // The same two poses of the body, with another point of it for the origin.
        assert!((distance((a * c).sclerp(b * c, half)) - 1.0).abs() < LENGTH, "{on:?}");
        assert!(distance((a * c).slerp_lerp(b * c, half)) < LENGTH, "{on:?}");
        assert!((distance(a.slerp_lerp(b, half) * c) - 1.0).abs() < LENGTH, "{on:?}");
        for (t, end) in [(0.0, a * c), (1.0, b * c)] {
            let at = (a * c).slerp_lerp(b * c, on.splat(t));
            assert_same(on.name, at, end, 1.0, 2.0);
        }
    }
}

#[test]
fn the_linear_blend_of_two_turns_away_by_eight_degrees_at_most() {
    let mut most = 0.0_f64;
    for step in 0..=1000 {
        let t = f64::from(step) / 1000.0;
        let pair = everywhere(scalar_f64(), [(turn(0.0), 1.0 - t), (turn(179.99), t)]);
        most = most.max((degrees(dlb(&pair)) - degrees(dib(&pair))).abs());
    }
    assert!((8.14..8.15).contains(&most), "{most}");
}
