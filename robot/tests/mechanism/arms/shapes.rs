//! Arms of any size, stretched, and with fewer ways to move than a pose has.

use dq8::{Backend, Real, Scalar};
use dq8_arms::{Arm, Random, X, Z, rounded, turning};
use dq8_robot::ik::{Options, Outcome, Report};

/// A planar arm of unit links, in this unit of length.
fn planar<R: Real, const N: usize>(length: f64) -> Arm<R, N> {
    let axes = core::array::from_fn(|i| (Z, [i as f64 * length, 0.3 * length, 0.0]));
    turning(axes, (X, 0.0, [N as f64 * length, 0.3 * length, 0.0])).arm()
}

/// Long arms and tiny ones at full stretch, which rounding puts a little beyond their length.
fn stretched_is_within_reach<R: Scalar>() {
    for length in [1e-6, 1e-3, 300.0, 30_000.0, 1e6] {
        let arm = planar::<R, 6>(length);
        let mut random = Random(12);
        let tolerance = <R as Real>::from_f64(1e-5 * length);
        let targets: [_; 64] = core::array::from_fn(|_| {
            let mut stretched = [R::ZERO; 6];
            stretched[0] = <R as Real>::from_f64(random.between(-3.0, 3.0));
            arm.forward(&stretched)
        });
        // No tolerance of lengths excuses what rounding does.
        let exact = Options { linear_tolerance: R::ZERO, ..Options::default() };
        let within = Options { linear_tolerance: tolerance, ..Options::default() };
        let mut converged = 0;
        for options in [exact, within] {
            let mut values = [[R::HALF; 6]; 64];
            let reports = arm.reach_all(Backend::best(), &targets, &mut values, &options);
            let beyond = |report: &&Report<R>| report.outcome == Outcome::OutOfReach;
            assert_eq!(reports.iter().filter(beyond).count(), 0, "{length}");
            converged = reports.iter().filter(|r| r.outcome == Outcome::Converged).count();
        }
        assert!(converged >= 62, "{length}: {converged} of 64");
    }
}

#[test]
fn an_arm_of_any_size_reaches_as_far_as_it_is_long() {
    stretched_is_within_reach::<f64>();
    stretched_is_within_reach::<f32>();
}

/// Arms that span a plane, or less, have a system of rank three or two, whatever their pose; about
/// axes in any direction, rounding makes it six with pivots of any sign.
fn rank_deficient_arms_converge<R: Scalar, const N: usize>() {
    let (mut random, mut converged) = (Random(13), 0);
    let once = Options { restarts: false, ..Options::default() };
    for _ in 0..50 {
        let axis = random.direction();
        let axes = core::array::from_fn(|_| (axis, random.vector().map(|c| 2.0 * c)));
        let arm = turning(axes, (X, 0.0, random.vector())).arm();
        let (mut targets, mut values) = (Vec::new(), Vec::new());
        for _ in 0..16 {
            let goal: [f64; N] = core::array::from_fn(|_| random.between(-2.5, 2.5));
            targets.push(arm.forward(&rounded(goal)));
            values.push(rounded::<R, N>(goal.map(|value| value + random.between(-0.3, 0.3))));
        }
        let reports = arm.reach_all(Backend::best(), &targets, &mut values, &once);
        converged += reports.iter().filter(|r| r.outcome == Outcome::Converged).count();
    }
    assert_eq!(converged, 800, "{N} joints");
}

#[test]
fn arms_of_parallel_axes_and_of_few_joints_need_no_restarts_near_their_target() {
    rank_deficient_arms_converge::<f64, 4>();
    rank_deficient_arms_converge::<f32, 4>();
    rank_deficient_arms_converge::<f32, 3>();
    rank_deficient_arms_converge::<f32, 2>();
    rank_deficient_arms_converge::<f32, 1>();
}
