//! Smooth motion through key poses.

use dq8::DualQuat;
use dq8_contract::cluster::{Cluster, Dealt, apart, cluster, length};
use dq8_contract::inputs::{for_all, proptest_config, turn_and_move, vector};
use dq8_contract::ledger::Ledger;
use dq8_contract::tolerance::{section, unit_roundoff};
use dq8_contract::{for_every_implementation, sample::Sample};
use proptest::collection::vec;
use proptest::prelude::*;

/// As many as the most lanes there are.
const CLUSTERS: usize = 16;

fn all_lanes<M: Sample>(pose: DualQuat<f64>) -> M {
    M::gather(&vec![pose.to_array(); M::LANES])
}

fn reference<M: Sample>(name: &str, clusters: &[Cluster], ledger: &Ledger) {
    let x = Dealt::<M>::new(clusters);
    let [a, b, c, d] = x.poses;
    let path = a.squad(b, c, d, x.t).scatter();
    let control = M::squad_control(a, b, c).scatter();
    let flipped = [(-a).squad(b, -c, -d, x.t), M::squad_control(-a, b, -c)].map(M::scatter);
    let (starts, ends) = (a.squad(b, c, d, M::splat(0.0)), a.squad(b, c, d, M::splat(1.0)));
    for lane in 0..M::LANES {
        let exact = x.lane(lane);
        let [a, b, c, d] = exact.poses;
        let scale = length(&exact.poses.map(DualQuat::to_array));
        let check = |op: &str, kind: &str, got, want: DualQuat<f64>| {
            let off = apart(got, want.to_array(), scale) / unit_roundoff(M::SINGLE);
            ledger.measure(op, kind, off, || format!("{name}: {exact:?}"));
        };
        check("squad", "", path[lane], a.squad(b, c, d, exact.t));
        check("squad_control", "", control[lane], DualQuat::squad_control(a, b, c));
        check("squad", "start", starts.scatter()[lane], a);
        check("squad", "end", ends.scatter()[lane], d);
        let of_signs = [(path[lane], flipped[0][lane]), (control[lane], flipped[1][lane])];
        for (plain, flipped) in of_signs {
            assert!(apart(plain, flipped, 1.0) == 0.0, "{name}: signs matter: {exact:?}");
        }
    }
}

/// Keys evenly spaced along one screw.
fn even_screw<M: Sample>(name: &str, start: [f64; 8], step: [f64; 8], t: f64) {
    let step = DualQuat::from_array(step);
    let first = DualQuat::from_array(start);
    let keys = [first, first * step, first * step * step, first * step * step * step];
    let [k0, k1, k2, k3] = keys.map(all_lanes::<M>);
    let (s1, s2) = (M::squad_control(k0, k1, k2), M::squad_control(k1, k2, k3));
    let scale = length(&keys.map(DualQuat::to_array));
    let t = M::splat(t);
    let pairs = [("control", s1, k1), ("path", k1.squad(s1, s2, k2, t), k1.sclerp(k2, t))];
    for (what, left, right) in pairs {
        let off = apart(left.scatter()[0], right.scatter()[0], scale) / unit_roundoff(M::SINGLE);
        // Two ways, each with its own error.
        let units = 2.0 * section("paths").line("squad", "").units;
        assert!(off <= units, "{name}, {what}: {off} u");
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
        for_every_implementation!(|name, M| {
            even_screw::<M>(name, cluster.poses[0], step, cluster.t);
        });
    }
}

#[test]
fn paths_are_those_of_the_reference_and_do_not_see_signs() {
    Ledger::keep("paths", |ledger| {
        for_all(32, &vec(cluster(), CLUSTERS), |clusters| {
            for_every_implementation!(|name, M| {
                for chunk in clusters.chunks_exact(<M as Sample>::LANES) {
                    reference::<M>(name, chunk, ledger);
                }
            });
        });
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
    fn check<M: Sample>(name: &str) {
        let keys = keys();
        let at = |i: usize| all_lanes::<M>(keys[i]);
        let control = |i: usize| M::squad_control(at(i - 1), at(i), at(i + 1));
        let point = [3.0, -1.0, 2.0].map(M::splat);
        let moved = |motion: M| motion.transform_point(point).map(|c| M::lanes(c)[0]);
        // One-sided differences of second order; what is left of them is the third derivative.
        let (step, tolerance) = if M::SINGLE { (1.0 / 128.0, 2e-2) } else { (1e-4, 1e-5) };
        for i in 2..=3 {
            let before = |t| moved(at(i - 1).squad(control(i - 1), control(i), at(i), M::splat(t)));
            let after = |t| moved(at(i).squad(control(i), control(i + 1), at(i + 1), M::splat(t)));
            let (b0, b1, b2) = (before(1.0), before(1.0 - step), before(1.0 - 2.0 * step));
            let (a0, a1, a2) = (after(0.0), after(step), after(2.0 * step));
            let mut speed = 0.0_f64;
            for c in 0..3 {
                let arrives = (3.0 * b0[c] - 4.0 * b1[c] + b2[c]) / (2.0 * step);
                let leaves = (4.0 * a1[c] - 3.0 * a0[c] - a2[c]) / (2.0 * step);
                assert!((b0[c] - a0[c]).abs() < 1e-5, "{name}: key {i} is missed");
                let jump = (arrives - leaves).abs();
                assert!(jump < tolerance, "{name}: velocity {arrives} then {leaves} at key {i}");
                speed = speed.max(arrives.abs());
            }
            assert!(speed > 0.5, "{name}: a standstill would prove nothing");
        }
    }
    for_every_implementation!(|name, M| check::<M>(name));
}

/// The mean of the screws from the key before and to the key after (Shoemake 1987).
#[test]
fn a_key_is_passed_with_the_mean_of_its_screws() {
    let keys = keys();
    let control = |i: usize| DualQuat::squad_control(keys[i - 1], keys[i], keys[i + 1]);
    let after = keys[2].squad(control(2), control(3), keys[3], 1e-6);
    let velocity = (keys[2].conjugate() * after).log();
    let to_next = (keys[2].conjugate() * keys[3]).log();
    let from_previous = (keys[1].conjugate() * keys[2]).log();
    for c in 0..3 {
        let real = 0.5 * (to_next.real[c] + from_previous.real[c]);
        let dual = 0.5 * (to_next.dual[c] + from_previous.dual[c]);
        assert!((velocity.real[c] / 1e-6 - real).abs() < 1e-4);
        assert!((velocity.dual[c] / 1e-6 - dual).abs() < 1e-4);
    }
}

#[test]
fn what_is_not_finite_gives_nan_in_its_lane_alone() {
    fn check<M: Sample>(name: &str) {
        let [a, b, c, d, ..] = keys().map(DualQuat::to_array);
        let same = |pose| M::gather(&vec![pose; M::LANES]);
        let t = M::splat(0.25);
        let wanted = [
            same(a).squad(same(b), same(c), same(d), t),
            M::squad_control(same(a), same(b), same(c)),
        ];
        for value in [f64::NAN, f64::INFINITY] {
            for which in 0..3 {
                let spoilt = |i: usize, pose: [f64; 8]| {
                    let mut lanes = vec![pose; M::LANES];
                    if i == which {
                        lanes[0][5] = value;
                    }
                    M::gather(&lanes)
                };
                let (a, b, c) = (spoilt(0, a), spoilt(1, b), spoilt(2, c));
                let got = [a.squad(b, c, same(d), t), M::squad_control(a, b, c)];
                for (got, wanted) in got.into_iter().zip(wanted) {
                    let (got, wanted) = (got.scatter(), wanted.scatter());
                    assert!(got[0].iter().any(|c| c.is_nan()), "{name}: {value} in {which}");
                    assert_eq!(got[1..], wanted[1..], "{name}: {value} in {which}");
                }
            }
        }
    }
    for_every_implementation!(|name, M| check::<M>(name));
}
