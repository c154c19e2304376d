//! Blends of motions: what they keep, where they break, and lanes against the scalar reference.

mod edges;

use dq8::DualQuat;
use dq8_contract::cluster::{Cluster, Dealt, apart, cluster, length};
use dq8_contract::inputs::{for_all, proptest_config, unit_motion};
use dq8_contract::ledger::Ledger;
use dq8_contract::tolerance::{section, unit_roundoff};
use dq8_contract::{for_every_implementation, sample::Sample};
use proptest::collection::vec;
use proptest::prelude::*;

/// As many as the most lanes there are.
const CLUSTERS: usize = 16;

/// Calls `$check::<M>(name, chunk, …)` for each implementation and as many clusters as it has lanes.
macro_rules! on_every_implementation {
    ($check:ident, $clusters:expr $(, $argument:expr)*) => {
        for_every_implementation!(|name, M| {
            for chunk in $clusters.chunks_exact(<M as Sample>::LANES) {
                $check::<M>(name, chunk $(, $argument)*);
            }
        })
    };
}

proptest! {
    #![proptest_config(proptest_config(32))]

    #[test]
    fn signs_of_influences_do_not_matter(
        clusters in vec(cluster(), CLUSTERS),
        flips in prop::array::uniform4(any::<bool>()),
    ) {
        on_every_implementation!(signs, clusters, flips);
    }

    #[test]
    fn the_order_of_influences_does_not_matter(clusters in vec(cluster(), CLUSTERS)) {
        on_every_implementation!(order, clusters);
    }

    #[test]
    fn the_mean_of_two_is_screw_interpolation(clusters in vec(cluster(), CLUSTERS)) {
        on_every_implementation!(mean_of_two, clusters);
    }

    #[test]
    fn the_logs_from_the_mean_cancel(clusters in vec(cluster(), CLUSTERS)) {
        on_every_implementation!(logs_cancel, clusters);
    }

    #[test]
    fn a_common_motion_carries_blends_along(
        clusters in vec(cluster(), CLUSTERS),
        common in unit_motion(),
    ) {
        on_every_implementation!(common_motion, clusters, common);
    }

    #[test]
    fn the_mean_of_a_lane_does_not_depend_on_its_neighbours(
        clusters in vec(cluster(), CLUSTERS),
    ) {
        on_every_implementation!(neighbours, clusters);
    }
}

#[test]
fn lanes_blend_as_the_scalar_reference_does() {
    Ledger::keep("blends", |ledger| {
        for_all(32, &vec(cluster(), CLUSTERS), |clusters| {
            on_every_implementation!(reference, clusters, ledger);
        });
    });
}

/// Smaller steps than this are rounding.
fn tolerance<M: Sample>() -> M::Real {
    M::splat(16.0 * unit_roundoff(M::SINGLE))
}

fn dib<M: Sample>(influences: &[(M, M::Real)]) -> M {
    M::dib(influences, tolerance::<M>(), 32).expect("there are influences").motion
}

fn dlb<M: Sample>(influences: &[(M, M::Real)]) -> M {
    M::dlb(influences).expect("there are influences")
}

fn dlb_running<M: Sample>(influences: &[(M, M::Real)]) -> M {
    M::dlb_running(influences).expect("there are influences")
}

/// The two agree as motions, in every lane, to `units` of u · `scale`.
fn assert_same<M: Sample>(what: &str, left: M, right: M, scale: f64, units: f64) {
    for (left, right) in left.scatter().into_iter().zip(right.scatter()) {
        let off = apart(left, right, scale) / unit_roundoff(M::SINGLE);
        assert!(off <= units, "{what}: {off} u apart: {left:?} and {right:?}");
    }
}

/// What the table allows a blend against the truth; two ways to one blend are held to as much.
fn units(op: &str) -> f64 {
    section("blends").line(op, "").units
}

fn scale_of(clusters: &[Cluster]) -> f64 {
    clusters.iter().map(|cluster| length(&cluster.poses)).fold(1.0, f64::max)
}

fn signs<M: Sample>(name: &str, clusters: &[Cluster], flips: [bool; 4]) {
    let x = Dealt::<M>::new(clusters);
    let mut flipped = x;
    for (pose, flip) in flipped.poses.iter_mut().zip(flips) {
        *pose = if flip { -*pose } else { *pose };
    }
    // Not merely close: the same numbers, or all of them negated.
    let same = |what, a: M, b: M| assert_same(&format!("{name}, {what}"), a, b, 1.0, 0.0);
    let (a, b) = (x.influences(), flipped.influences());
    same("dlb", dlb(&a), dlb(&b));
    same("dlb_running", dlb_running(&a), dlb_running(&b));
    same("dib", dib(&a), dib(&b));
    let ([p, q, ..], [pf, qf, ..]) = (x.poses, flipped.poses);
    same("slerp_lerp", p.slerp_lerp(q, x.t), pf.slerp_lerp(qf, x.t));
}

fn order<M: Sample>(name: &str, clusters: &[Cluster]) {
    let [a, b, c, d] = Dealt::<M>::new(clusters).influences();
    let (forth, back) = ([a, b, c, d], [c, d, b, a]);
    let scale = scale_of(clusters);
    let (mean, sum) = (units("dib"), units("dlb_running"));
    assert_same(&format!("{name}, dib"), dib(&forth), dib(&back), scale, mean);
    assert_same(&format!("{name}, dlb"), dlb(&forth), dlb(&back), scale, sum);
    assert_same(&format!("{name}, running"), dlb_running(&forth), dlb(&back), scale, sum);
}

fn mean_of_two<M: Sample>(name: &str, clusters: &[Cluster]) {
    let x = Dealt::<M>::new(clusters);
    let rest: Vec<f64> = M::lanes(x.t).iter().map(|t| 1.0 - t).collect();
    let [a, b, ..] = x.poses;
    let mean = dib(&[(a, M::real(&rest)), (b, x.t)]);
    assert_same(name, mean, a.sclerp(b, x.t), scale_of(clusters), units("dib"));
}

fn logs_cancel<M: Sample>(name: &str, clusters: &[Cluster]) {
    let x = Dealt::<M>::new(clusters);
    let mean = M::dib(&x.influences(), tolerance::<M>(), 32).expect("there are influences");
    assert_eq!(M::bits(mean.converged), (1 << M::LANES) - 1, "{name}: {clusters:?}");
    let most = M::lanes(mean.iterations).into_iter().fold(0.0, f64::max);
    // Measured over 1600 clusters: 3 and 8, to 10⁻⁶ and 2·10⁻¹⁵.
    assert!(most <= if M::SINGLE { 4.0 } else { 9.0 }, "{name}: {most} iterations");
    for (lane, motion) in mean.motion.scatter().into_iter().enumerate() {
        let exact = x.lane(lane);
        let mean = DualQuat::from_array(motion).normalize();
        let mut sum = [0.0; 6];
        for (pose, weight) in exact.influences() {
            let log = (mean.conjugate() * pose.normalize()).log();
            for (sum, log) in sum.iter_mut().zip(log.real.into_iter().chain(log.dual)) {
                *sum += weight * log;
            }
        }
        let scale = length(&exact.poses.map(DualQuat::to_array));
        for (i, sum) in sum.into_iter().enumerate() {
            let off = sum.abs() / if i < 3 { 1.0 } else { scale };
            let off = off / unit_roundoff(M::SINGLE);
            assert!(off <= 32.0, "{name}: component {i} is off by {off} u: {exact:?}");
        }
    }
}

fn common_motion<M: Sample>(name: &str, clusters: &[Cluster], common: [f64; 8]) {
    let x = Dealt::<M>::new(clusters);
    let c = M::gather(&vec![common; M::LANES]);
    let (mut left, mut right) = (x, x);
    left.poses = x.poses.map(|pose| c * pose);
    right.poses = x.poses.map(|pose| pose * c);
    let scale = scale_of(clusters) + length(&[common]);
    let same = |what, a, b| assert_same::<M>(&format!("{name}, {what}"), a, b, scale, 32.0);

    let (middle, l, r) = (x.influences(), left.influences(), right.influences());
    same("c dib", c * dib(&middle), dib(&l));
    same("dib c", dib(&middle) * c, dib(&r));
    same("c dlb", c * dlb(&middle), dlb(&l));
    same("dlb c", dlb(&middle) * c, dlb(&r));
    let ([a, b, ..], [la, lb, ..], [ra, rb, ..]) = (x.poses, left.poses, right.poses);
    same("c sclerp", c * a.sclerp(b, x.t), la.sclerp(lb, x.t));
    same("sclerp c", a.sclerp(b, x.t) * c, ra.sclerp(rb, x.t));
    same("c slerp_lerp", c * a.slerp_lerp(b, x.t), la.slerp_lerp(lb, x.t));
}

fn neighbours<M: Sample>(name: &str, clusters: &[Cluster]) {
    let mean = |clusters: &[Cluster]| {
        let influences = Dealt::<M>::new(clusters).influences();
        M::dib(&influences, tolerance::<M>(), 32).expect("there are influences")
    };
    let together = mean(clusters);
    for (lane, &cluster) in clusters.iter().enumerate() {
        let alone = mean(&vec![cluster; M::LANES]);
        assert_eq!(together.motion.scatter()[lane], alone.motion.scatter()[lane], "{name}");
        let [with, without] = [together, alone].map(|mean| M::lanes(mean.iterations)[lane]);
        assert_eq!(with.to_bits(), without.to_bits(), "{name}: {with} and {without} iterations");
    }
}

fn reference<M: Sample>(name: &str, clusters: &[Cluster], ledger: &Ledger) {
    let x = Dealt::<M>::new(clusters);
    let [a, b, ..] = x.poses;
    let running = dlb_running(&x.influences()).scatter();
    let mean = dib(&x.influences()).scatter();
    let interpolated = a.slerp_lerp(b, x.t).scatter();
    for lane in 0..M::LANES {
        let exact = x.lane(lane);
        let [a, b, ..] = exact.poses;
        let scale = length(&exact.poses.map(DualQuat::to_array));
        let check = |what: &str, got, want: DualQuat<f64>| {
            let off = apart(got, want.to_array(), scale) / unit_roundoff(M::SINGLE);
            ledger.measure(what, "", off, || format!("{name}: {exact:?}"));
        };
        check("dlb_running", running[lane], dlb_running(&exact.influences()));
        check("dib", mean[lane], dib(&exact.influences()));
        check("slerp_lerp", interpolated[lane], a.slerp_lerp(b, exact.t));
    }
}
