//! Blends of motions: what they keep, where they break, and lanes against the scalar reference.

mod edges;

use dq8::DualQuat;
use dq8_contract::bound::apart;
use dq8_contract::case::{Arguments, Case};
use dq8_contract::implementation::{On, implementations};
use dq8_contract::inputs::{cluster, proptest_config, unit_motion};
use dq8_contract::lanes::{Motions, Reals};
use dq8_contract::operations::operation;
use dq8_contract::scale::farthest;
use proptest::collection::vec;
use proptest::prelude::*;

/// As many as the most lanes there are.
const CLUSTERS: usize = 16;

/// Calls `check` for each implementation and as many clusters as it has lanes.
fn on_every_implementation(clusters: &[Case], check: impl Fn(On, &[Case])) {
    for on in implementations() {
        clusters.chunks_exact(on.lanes).for_each(|chunk| check(on, chunk));
    }
}

proptest! {
    #![proptest_config(proptest_config(32))]

    #[test]
    fn signs_of_influences_do_not_matter(
        clusters in vec(cluster(), CLUSTERS),
        flips in prop::array::uniform4(any::<bool>()),
    ) {
        on_every_implementation(&clusters, |on, chunk| signs(on, chunk, flips));
    }

    #[test]
    fn the_order_of_influences_does_not_matter(clusters in vec(cluster(), CLUSTERS)) {
        on_every_implementation(&clusters, order);
    }

    #[test]
    fn the_mean_of_two_is_screw_interpolation(clusters in vec(cluster(), CLUSTERS)) {
        on_every_implementation(&clusters, mean_of_two);
    }

    #[test]
    fn the_logs_from_the_mean_cancel(clusters in vec(cluster(), CLUSTERS)) {
        on_every_implementation(&clusters, logs_cancel);
    }

    #[test]
    fn a_common_motion_carries_blends_along(
        clusters in vec(cluster(), CLUSTERS),
        common in unit_motion(),
    ) {
        on_every_implementation(&clusters, |on, chunk| common_motion(on, chunk, common));
    }
}

/// Smaller steps than this are rounding.
fn tolerance(on: On) -> Reals {
    on.splat(16.0 * on.roundoff())
}

fn dib(influences: &[(Motions, Reals)]) -> Motions {
    let on = influences[0].0.on();
    on.dib(influences, tolerance(on), 32).expect("there are influences").motion
}

fn dlb(influences: &[(Motions, Reals)]) -> Motions {
    influences[0].0.on().dlb(influences).expect("there are influences")
}

fn dlb_running(influences: &[(Motions, Reals)]) -> Motions {
    influences[0].0.on().dlb_running(influences).expect("there are influences")
}

/// The two agree as motions, in every lane, to `units` of u · `scale`.
fn assert_same(what: &str, left: Motions, right: Motions, scale: f64, units: f64) {
    let roundoff = left.on().roundoff();
    for (left, right) in left.scatter().into_iter().zip(right.scatter()) {
        let off = apart(left, right, scale) / roundoff;
        assert!(off <= units, "{what}: {off} u apart: {left:?} and {right:?}");
    }
}

/// What the table allows a blend against the truth; two ways to one blend are held to as much.
fn units(op: &str) -> f64 {
    let (.., bounds) = operation(op).double().expect("blends are held against f64");
    bounds[0].units
}

fn scale_of(clusters: &[Case]) -> f64 {
    clusters.iter().map(|cluster| farthest(&cluster.poses())).fold(1.0, f64::max)
}

fn signs(on: On, clusters: &[Case], flips: [bool; 4]) {
    let x = Arguments::new(on, clusters);
    let mut poses = x.poses();
    for (pose, flip) in poses.iter_mut().zip(flips) {
        *pose = if flip { -*pose } else { *pose };
    }
    let flipped = x.with_poses(poses);
    // Not merely close: the same numbers, or all of them negated.
    let same =
        |what, a: Motions, b: Motions| assert_same(&format!("{on:?}, {what}"), a, b, 1.0, 0.0);
    let (a, b) = (x.influences(), flipped.influences());
    same("dlb", dlb(&a), dlb(&b));
    same("dlb_running", dlb_running(&a), dlb_running(&b));
    same("dib", dib(&a), dib(&b));
    let ([p, q, ..], [pf, qf, ..]) = (x.poses(), flipped.poses());
    same("slerp_lerp", p.slerp_lerp(q, x.t), pf.slerp_lerp(qf, x.t));
}

fn order(on: On, clusters: &[Case]) {
    let [a, b, c, d] = Arguments::new(on, clusters).influences();
    let (forth, back) = ([a, b, c, d], [c, d, b, a]);
    let scale = scale_of(clusters);
    let (mean, sum) = (units("dib"), units("dlb_running"));
    assert_same(&format!("{on:?}, dib"), dib(&forth), dib(&back), scale, mean);
    assert_same(&format!("{on:?}, dlb"), dlb(&forth), dlb(&back), scale, sum);
    assert_same(&format!("{on:?}, running"), dlb_running(&forth), dlb(&back), scale, sum);
}

fn mean_of_two(on: On, clusters: &[Case]) {
    let x = Arguments::new(on, clusters);
    let rest: Vec<f64> = x.t.lanes().iter().map(|t| 1.0 - t).collect();
    let [a, b, ..] = x.poses();
    let mean = dib(&[(a, on.reals(&rest)), (b, x.t)]);
    assert_same(on.name, mean, a.sclerp(b, x.t), scale_of(clusters), units("dib"));
}

fn logs_cancel(on: On, clusters: &[Case]) {
    let x = Arguments::new(on, clusters);
    let mean = on.dib(&x.influences(), tolerance(on), 32).expect("there are influences");
    assert_eq!(mean.converged, (1 << on.lanes) - 1, "{on:?}: {clusters:?}");
    let most = mean.iterations.lanes().into_iter().fold(0.0, f64::max);
    // Measured over 1600 clusters: 3 and 8, to 10⁻⁶ and 2·10⁻¹⁵.
    assert!(most <= if on.single { 4.0 } else { 9.0 }, "{on:?}: {most} iterations");
    for (lane, motion) in mean.motion.scatter().into_iter().enumerate() {
        let exact = clusters[lane].rounded(on);
        let mean = DualQuat::from_array(motion).normalize();
        let mut sum = [0.0; 6];
        for (pose, weight) in exact.poses().into_iter().zip(exact.weights) {
            let pose = DualQuat::from_array(pose);
            let log = (mean.conjugate() * pose.normalize()).log();
            for (sum, log) in sum.iter_mut().zip(log.real.into_iter().chain(log.dual)) {
                *sum += weight * log;
            }
        }
        let scale = farthest(&exact.poses());
        for (i, sum) in sum.into_iter().enumerate() {
            let off = sum.abs() / if i < 3 { 1.0 } else { scale };
            let off = off / on.roundoff();
            assert!(off <= 32.0, "{on:?}: component {i} is off by {off} u: {exact:?}");
        }
    }
}

fn common_motion(on: On, clusters: &[Case], common: [f64; 8]) {
    let x = Arguments::new(on, clusters);
    let c = on.same(common);
    let left = x.with_poses(x.poses().map(|pose| c * pose));
    let right = x.with_poses(x.poses().map(|pose| pose * c));
    let scale = scale_of(clusters) + farthest(&[common]);
    let same = |what, a, b| assert_same(&format!("{on:?}, {what}"), a, b, scale, 32.0);

    let (middle, l, r) = (x.influences(), left.influences(), right.influences());
    same("c dib", c * dib(&middle), dib(&l));
    same("dib c", dib(&middle) * c, dib(&r));
    same("c dlb", c * dlb(&middle), dlb(&l));
    same("dlb c", dlb(&middle) * c, dlb(&r));
    let ([a, b, ..], [la, lb, ..], [ra, rb, ..]) = (x.poses(), left.poses(), right.poses());
    same("c sclerp", c * a.sclerp(b, x.t), la.sclerp(lb, x.t));
    same("sclerp c", a.sclerp(b, x.t) * c, ra.sclerp(rb, x.t));
    same("c slerp_lerp", c * a.slerp_lerp(b, x.t), la.slerp_lerp(lb, x.t));
}
