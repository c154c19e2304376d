//! Smooth motion through key poses.

use dq8::DualQuat;
use dq8_contract::bound::apart;
use dq8_contract::case::{Arguments, Case};
use dq8_contract::implementation::{On, implementations};
use dq8_contract::inputs::{cluster, draw, proptest_config, turn_and_move, vector};
use dq8_contract::lanes::Motions;
use dq8_contract::ledger::{Ledger, line};
use dq8_contract::scale::farthest;
use proptest::prelude::*;

fn ends(on: On, clusters: &[Case], ledger: &Ledger) {
    let x = Arguments::new(on, clusters);
    let [a, b, c, d] = x.poses();
    let (path, control) = (a.squad(b, c, d, x.t), a.squad_control(b, c));
    let (flipped, control_flipped) = ((-a).squad(b, -c, -d, x.t), (-a).squad_control(b, -c));
    let (start, end) = (a.squad(b, c, d, on.splat(0.0)), a.squad(b, c, d, on.splat(1.0)));
    for (lane, case) in clusters.iter().enumerate() {
        let scale = farthest(&case.poses());
        for (kind, got, key) in [("start", start, a), ("end", end, d)] {
            let off = apart(got.lane(lane), key.lane(lane), scale) / on.roundoff();
            ledger.measure("squad", kind, off, || format!("{on:?}: {case:?}"));
        }
        for (plain, flipped) in [(path, flipped), (control, control_flipped)] {
            let off = apart(plain.lane(lane), flipped.lane(lane), 1.0);
            assert!(off == 0.0, "{on:?}: signs matter: {case:?}");
        }
    }
}

/// Keys evenly spaced along one screw.
fn even_screw(on: On, start: [f64; 8], step: [f64; 8], t: f64) {
    let step = DualQuat::from_array(step);
    let first = DualQuat::from_array(start);
    let keys = [first, first * step, first * step * step, first * step * step * step];
    let [k0, k1, k2, k3] = keys.map(|key| on.same(key.to_array()));
    let (s1, s2) = (k0.squad_control(k1, k2), k1.squad_control(k2, k3));
    let scale = farthest(&keys.map(DualQuat::to_array));
    let t = on.splat(t);
    let pairs = [("control", s1, k1), ("path", k1.squad(s1, s2, k2, t), k1.sclerp(k2, t))];
    for (what, left, right) in pairs {
        let off = apart(left.lane(0), right.lane(0), scale) / on.roundoff();
        // Two ways, each with the error of squad against the truth.
        assert!(off <= 15.0, "{on:?}, {what}: {off} u");
    }
}

proptest! {
    #![proptest_config(proptest_config(32))]

    #[test]
    fn keys_evenly_spaced_on_a_screw_are_joined_by_it(
        cluster in cluster(),
        axis in vector().prop_filter("an axis", |v| v.iter().map(|c| c * c).sum::<f64>() > 0.01),
        angle in -1.0..1.0_f64,
        translation in vector(),
    ) {
        let step = turn_and_move(axis, angle, translation);
        for on in implementations() {
            even_screw(on, cluster.a, step, cluster.t);
        }
    }
}

#[test]
fn paths_begin_and_end_at_their_keys_and_do_not_see_signs() {
    // Of 40,000 clusters the worst is off by 7.1 u; that of these is off by 6.6 u.
    let lines = [line("squad", &["start", "end"], 7.0, "interpolated with 0 or 1")];
    let clusters = draw(cluster(), 512);
    Ledger::keep("ends of paths", &lines, |ledger| {
        for on in implementations() {
            for chunk in clusters.chunks_exact(on.lanes) {
                ends(on, chunk, ledger);
            }
        }
    });
}

/// Keys that turn and move this way and that, half of them negated.
fn keys() -> [DualQuat<f64>; 6] {
    let turns = [
        ([1.0, 0.0, 0.0], 0.0, [0.0, 0.0, 0.0]),
        ([0.0, 1.0, 0.2], 0.9, [1.0, 2.0, 0.0]),
        ([0.3, 1.0, 0.0], -0.4, [2.5, 1.0, 1.0]),
        ([0.0, 0.3, 1.0], 1.1, [3.0, -1.0, 2.0]),
        ([0.0, 0.0, 1.0], 2.2, [5.0, 0.0, 0.0]),
        ([1.0, 0.0, 1.0], 1.7, [6.0, 2.0, -1.0]),
    ];
    std::array::from_fn(|i| {
        let (axis, angle, translation) = turns[i];
        let pose = DualQuat::from_array(turn_and_move(axis, angle, translation));
        if i % 2 == 0 { pose } else { -pose }
    })
}

#[test]
fn velocity_is_continuous_across_keys() {
    for on in implementations() {
        let keys = keys();
        let at = |i: usize| on.same(keys[i].to_array());
        let control = |i: usize| at(i - 1).squad_control(at(i), at(i + 1));
        let point = [3.0, -1.0, 2.0].map(|c| on.splat(c));
        let moved = |motion: Motions| motion.transform_point(point).map(|c| c.first());
        // One-sided differences of second order; what is left of them is the third derivative.
        let (step, tolerance) = if on.single { (1.0 / 128.0, 2e-2) } else { (1e-4, 1e-5) };
        for i in 2..=3 {
            let before = |t| moved(at(i - 1).squad(control(i - 1), control(i), at(i), on.splat(t)));
            let after = |t| moved(at(i).squad(control(i), control(i + 1), at(i + 1), on.splat(t)));
            let (b0, b1, b2) = (before(1.0), before(1.0 - step), before(1.0 - 2.0 * step));
            let (a0, a1, a2) = (after(0.0), after(step), after(2.0 * step));
            let mut speed = 0.0_f64;
            for c in 0..3 {
                let arrives = (3.0 * b0[c] - 4.0 * b1[c] + b2[c]) / (2.0 * step);
                let leaves = (4.0 * a1[c] - 3.0 * a0[c] - a2[c]) / (2.0 * step);
                // A point a few lengths away in `f32`.
                assert!((b0[c] - a0[c]).abs() < 1e-5, "{on:?}: key {i} is missed");
                let jump = (arrives - leaves).abs();
                assert!(jump < tolerance, "{on:?}: velocity {arrives} then {leaves} at key {i}");
                speed = speed.max(arrives.abs());
            }
            assert!(speed > 0.5, "{on:?}: a standstill would prove nothing");
        }
    }
}

/// How far along the curve its speed is taken.
const STEP: f64 = 1e-6;
/// What the curve bends within that, some tens a step.
const SECOND_ORDER: f64 = 1e-4;

/// The mean of the screws from the key before and to the key after (Shoemake 1987).
#[test]
fn a_key_is_passed_with_the_mean_of_its_screws() {
    let keys = keys();
    let control = |i: usize| DualQuat::squad_control(keys[i - 1], keys[i], keys[i + 1]);
    let after = keys[2].squad(control(2), control(3), keys[3], STEP);
    let velocity = (keys[2].conjugate() * after).log();
    let to_next = (keys[2].conjugate() * keys[3]).log();
    let from_previous = (keys[1].conjugate() * keys[2]).log();
    for c in 0..3 {
        let real = 0.5 * (to_next.real[c] + from_previous.real[c]);
        let dual = 0.5 * (to_next.dual[c] + from_previous.dual[c]);
        assert!((velocity.real[c] / STEP - real).abs() < SECOND_ORDER);
        assert!((velocity.dual[c] / STEP - dual).abs() < SECOND_ORDER);
    }
}
