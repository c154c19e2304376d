//! What a search says where there is nothing to reach, nothing to do, or nothing to compute with.

use super::REACHED;
use super::arms::{Random, gantry, puma, rounded, ur5};
use dq8::ik::{Arm, Joint, Options, Outcome, Report};
use dq8::{Backend, DualQuat, Lanes, Quat, Scalar, simd::Portable};

/// A number of about 1 that nothing but its limits or its target decides.
const LAST_BITS: f64 = 1e-15;
/// A search stalls where a step gains nothing that `f64` sees: on the root of its roundoff.
const AT_REST: f64 = 2e-8;
/// The same steps in another unit, or with a joint that does not move: each rounds what came before.
const SAME_STEPS: f64 = 1e-12;

fn turned(angle: f64, translation: [f64; 3]) -> DualQuat<f64> {
    let turn = Quat::from_axis_angle([0.6, 0.0, 0.8], angle);
    DualQuat::from_rotation_translation(turn, translation)
}

#[test]
fn a_start_at_the_target_takes_no_iteration_and_stays() {
    let (plan, mut random) = (puma(), Random(5));
    let arm = plan.arm::<f64>();
    for _ in 0..20 {
        let values = plan.draw(&mut random);
        let target = arm.forward(&values);
        // σ and −σ are the same motion.
        for target in [target, -target] {
            let mut moved = values;
            let report = arm.reach(target, &mut moved, &Options::default());
            assert_eq!((report.outcome, report.iterations), (Outcome::Converged, 0));
            assert_eq!(moved, values);
        }
    }
}

/// Beyond the bound in every direction, from just beyond to as far as numbers go.
#[test]
fn a_target_beyond_the_arm_is_out_of_reach_and_the_arm_stretches_toward_it() {
    let (plan, mut random) = (ur5(), Random(6));
    let arm = plan.arm::<f64>();
    let (_, length) = arm.reach_bound();
    for (far, rounding) in [(1.001, 1e-12), (2.0, 1e-12), (1e3, 1e-9), (1e100, 1e88)] {
        let mut excess = 0.0;
        for _ in 0..20 {
            let direction = Quat::from_array(random.vector()).normalize().rotate([1.0, 0.0, 0.0]);
            let target = turned(random.between(0.0, 1.0), direction.map(|c| c * far * length));
            let mut values = plan.draw(&mut random);
            let report = arm.reach(target, &mut values, &Options::default());
            assert_eq!((report.outcome, report.restarts), (Outcome::OutOfReach, 0));
            assert!(values.iter().all(|value| value.is_finite()));
            // What is left beside the way that no arm of this length goes.
            let beside = report.linear_error - (far - 1.0) * length;
            assert!(beside > -rounding && beside < 1.2 * length + rounding, "{far}: {report:?}");
            excess += beside / 20.0;
        }
        // The bound is not sharp, and some turns of the end keep it from stretching.
        assert!(excess < 0.3 * length + rounding, "{far}: {excess} of {length}");
    }
}

/// A planar arm asked to leave its plane by an angle, well within its length.
#[test]
fn a_pose_that_no_joint_can_give_stalls_as_near_as_it_gets() {
    let up = [0.0, 0.0, 1.0_f64];
    let joints = [0.0, 1.0, 2.0].map(|x| Joint::revolute(up, [x, 0.0, 0.0]));
    let arm = Arm::new(joints, DualQuat::from_translation([2.0, 0.0, 0.0])).expect("an arm");
    for restarts in [true, false] {
        let tilt = Quat::from_axis_angle([1.0, 0.0, 0.0], 0.25);
        let target = DualQuat::from_rotation_translation(tilt, [1.0, 0.5, 0.0]);
        let mut values = [0.2, 0.7, -0.5];
        let options = Options { restarts, ..Options::default() };
        let report = arm.reach(target, &mut values, &options);
        assert_eq!(report.outcome, Outcome::Stalled, "{report:?}");
        assert!((report.angular_error - 0.25).abs() < AT_REST, "{report:?}");
        assert!(report.linear_error < AT_REST, "{report:?}");
        assert_eq!(report.restarts > 0, restarts);
    }
}

#[test]
fn a_limit_in_the_way_is_named_and_kept() {
    let hinge = Joint::revolute([0.0, 0.0, 1.0_f64], [0.0; 3]).with_limits([-0.5, 1.0]);
    let arm = Arm::new([hinge], DualQuat::from_translation([1.0, 0.0, 0.0])).expect("an arm");
    for (wanted, stop) in [(1.5_f64, 1.0), (-2.0, -0.5)] {
        let target = DualQuat::from_rotation(Quat::from_axis_angle([0.0, 0.0, 1.0], wanted))
            * DualQuat::from_translation([1.0, 0.0, 0.0]);
        let mut values = [0.2];
        let report = arm.reach(target, &mut values, &Options::default());
        assert_eq!((report.outcome, values), (Outcome::AtLimits, [stop]));
        assert!((report.angular_error - (wanted - stop).abs()).abs() < LAST_BITS);
    }
    // A start beyond a limit begins at it.
    let mut values = [5.0];
    let target = DualQuat::from_rotation(Quat::from_axis_angle([0.0, 0.0, 1.0], 0.9))
        * DualQuat::from_translation([1.0, 0.0, 0.0]);
    let report = arm.reach(target, &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Converged);
    assert!((values[0] - 0.9).abs() < REACHED);
}

/// A slide that cannot move asks for a share of every step and gets none; the others step as if it were
/// not there.
#[test]
fn a_joint_held_at_its_limits_is_as_none() {
    let (plan, mut random) = (ur5(), Random(11));
    let arm = plan.arm::<f64>();
    let [a, b, c, d, e, f] = *arm.joints();
    let stuck = Joint::prismatic([1.0, 0.0, 0.0], [0.0, 0.0]);
    let longer = Arm::new([a, b, c, stuck, d, e, f], arm.forward(&[0.0; 6])).expect("an arm");
    let once = Options { restarts: false, ..Options::default() };
    for _ in 0..20 {
        let target = arm.forward(&plan.draw(&mut random));
        let start = plan.draw(&mut random).map(|angle| 0.3 * angle);
        let mut six = start;
        let [a, b, c, d, e, f] = start;
        let mut seven = [a, b, c, 0.0, d, e, f];
        let options = Options { max_iterations: 5, ..once };
        let (wanted, report) =
            (arm.reach(target, &mut six, &options), longer.reach(target, &mut seven, &options));
        assert_eq!((report.iterations, report.outcome), (wanted.iterations, wanted.outcome));
        let [a, b, c, held, d, e, f] = seven;
        assert_eq!(held, 0.0);
        for (got, wanted) in [a, b, c, d, e, f].into_iter().zip(six) {
            assert!((got - wanted).abs() < SAME_STEPS, "{got} for {wanted}");
        }
    }
}

/// From one end of a full turn the way across is the shorter one.
#[test]
fn a_hinge_without_stops_goes_over_the_half_turn() {
    let hinge = Joint::revolute([0.0, 0.0, 1.0_f64], [0.0; 3]);
    let arm = Arm::new([hinge], DualQuat::from_translation([1.0, 0.0, 0.0])).expect("an arm");
    let mut values = [3.0];
    let report = arm.reach(arm.forward(&[-3.0]), &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Converged);
    assert!((values[0] + 3.0).abs() < REACHED, "{values:?}");
    assert!(report.iterations <= 3, "{report:?}");
}

#[test]
fn few_iterations_leave_it_unfinished_and_nearer() {
    let plan = ur5();
    let arm = plan.arm::<f64>();
    let goal = [0.4, -0.9, 1.1, -0.3, 0.8, 0.2];
    let start = [0.9, -0.3, 0.6, 0.4, 1.3, -0.5];
    let mut left = f64::INFINITY;
    for max_iterations in 0..3 {
        let mut values = start;
        let options = Options { max_iterations, ..Options::default() };
        let report = arm.reach(arm.forward(&goal), &mut values, &options);
        assert_eq!(report.outcome, Outcome::Unfinished, "{report:?}");
        assert_eq!(report.iterations, max_iterations);
        assert!(report.angular_error + report.linear_error < left);
        left = report.angular_error + report.linear_error;
    }
}

/// Stretched, a UR5 has a Jacobian of rank four.
#[test]
fn a_stretched_arm_finds_its_way() {
    let (plan, mut random) = (ur5(), Random(7));
    let arm = plan.arm::<f64>();
    let mut reached = 0;
    for _ in 0..100 {
        let target = arm.forward(&plan.draw(&mut random));
        let mut values = [0.0; 6];
        let report = arm.reach(target, &mut values, &Options::default());
        reached += u32::from(report.outcome == Outcome::Converged);
    }
    assert!(reached >= 99, "{reached}");
}

/// In front of a singular pose the Jacobian promises everything. Neither the limit of a step nor what the
/// damping allows, |e|/(2λ), is exceeded; and without damping the second would be.
#[test]
fn damping_keeps_steps_short_in_front_of_singular_poses() {
    let (plan, mut random) = (ur5(), Random(8));
    let arm = plan.arm::<f64>();
    let once = Options { max_iterations: 1, length_per_radian: Some(1.0), ..Options::default() };
    let damped = Options { damping: 0.05, ..once };
    let mut undamped_longest = 0.0_f64;
    for round in 0..400 {
        // An elbow that is nearly, or wholly, stretched.
        let mut start = plan.draw(&mut random).map(|angle| 0.5 * angle);
        start[2] = [0.0, 1e-9, 1e-4, 0.1][round % 4];
        let turns = |target, options| {
            let mut values = start;
            arm.reach(target, &mut values, options);
            let turns = core::array::from_fn::<f64, 6, _>(|i| {
                let turn = (values[i] - start[i]).abs();
                turn.min(std::f64::consts::TAU - turn)
            });
            (
                turns.iter().fold(0.0, |most: f64, t| most.max(*t)),
                turns.map(|t| t * t).iter().sum::<f64>().sqrt(),
            )
        };
        let (longest, _) = turns(arm.forward(&plan.draw(&mut random)), &once);
        assert!(longest <= 1.5 + LAST_BITS, "{longest}");

        let pushed = DualQuat::from_translation([1e-2 * random.signed(), 1e-2, 0.0]);
        let target = pushed * arm.forward(&start);
        let error = pushed.translation().iter().map(|c| c * c).sum::<f64>().sqrt();
        let (_, length) = turns(target, &damped);
        assert!(length <= error / (2.0 * 0.05), "{length} for {error}");
        undamped_longest = undamped_longest.max(turns(target, &once).1 * (2.0 * 0.05) / error);
    }
    assert!(undamped_longest > 2.0, "{undamped_longest}");
}

/// Every number of a target and of a start, one after the other, not a number, infinite, or too large.
fn nothing_comes_of_nothing<R>()
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    let plan = gantry();
    let arm = plan.arm::<R>();
    let start: [R; 8] = rounded([0.1; 8]);
    let target = arm.forward(&rounded([0.2; 8]));
    let (inf, nan) = (R::ONE / R::ZERO, R::NAN);
    let untouched = |target: DualQuat<R>, start: [R; 8]| {
        let mut values = start;
        let report = arm.reach(target, &mut values, &Options::default());
        assert_eq!(report.outcome, Outcome::Invalid, "{target:?} {start:?}");
        assert!(report.angular_error.is_nan() && report.linear_error.is_nan());
        assert_eq!(report.iterations, 0);
        for (value, start) in values.into_iter().zip(start) {
            assert!(value == start || start.is_nan());
        }
    };
    for bad in [nan, inf, -inf] {
        for component in 0..8 {
            let mut components = target.to_array();
            components[component] = bad;
            untouched(DualQuat::from_array(components), start);
            let mut start = start;
            start[component] = bad;
            untouched(target, start);
        }
    }
    untouched(DualQuat::ZERO, start);
    untouched(target.scale(R::TWO), start);

    // As large as numbers get without being infinite, and as small: never NaN.
    let big = R::ONE / R::from(1e-37);
    let tiny = R::from(1e-37) * R::from(1e-7);
    for translation in [[big; 3], [big, R::ZERO, -big], [tiny; 3], [-tiny, R::ZERO, R::ZERO]] {
        let target = DualQuat::from_rotation_translation(target.rotation(), translation);
        for options in [
            Options::default(),
            Options { length_per_radian: Some(tiny), ..Options::default() },
            Options { length_per_radian: Some(big), ..Options::default() },
            Options { max_step: inf, ..Options::default() },
            Options { angular_tolerance: R::ZERO, linear_tolerance: inf, ..Options::default() },
        ] {
            let mut values = start;
            arm.reach(target, &mut values, &options);
            assert!(values.iter().all(|value| value.is_finite()), "{values:?} {options:?}");
        }
    }
    for options in [
        Options { length_per_radian: Some(R::ZERO), ..Options::default() },
        Options { length_per_radian: Some(nan), ..Options::default() },
        Options { max_step: nan, ..Options::default() },
        Options { max_step: R::ZERO, ..Options::default() },
        Options { angular_tolerance: nan, linear_tolerance: inf, ..Options::default() },
    ] {
        let mut values = start;
        let report = arm.reach(target, &mut values, &options);
        assert_eq!((report.outcome, values), (Outcome::Invalid, start), "{options:?}");
    }
    for max_step in [R::from(100.0), inf] {
        let mut values = start;
        let options = Options { max_step, ..Options::default() };
        let report = arm.reach(target, &mut values, &options);
        assert_eq!(report.outcome, Outcome::Converged, "{report:?}");
    }
}

#[test]
fn what_is_not_a_number_moves_nothing_and_never_comes_out() {
    nothing_comes_of_nothing::<f64>();
    nothing_comes_of_nothing::<f32>();
}

#[test]
fn an_arm_without_joints_is_where_it_is() {
    let home = turned(0.5, [0.1, 0.2, 0.3]);
    let arm = Arm::<f64, 0>::new([], home).expect("an arm");
    assert_eq!(arm.forward(&[]), home);
    assert_eq!(arm.reach(home, &mut [], &Options::default()).outcome, Outcome::Converged);
    let aside = arm.reach(turned(0.6, [0.1, 0.2, 0.3]), &mut [], &Options::default());
    assert_eq!(aside.outcome, Outcome::Stalled);
    assert!((aside.angular_error - 0.1).abs() < LAST_BITS);
    let away = arm.reach(turned(0.5, [0.1, 0.2, 0.4]), &mut [], &Options::default());
    assert_eq!(away.outcome, Outcome::OutOfReach);
    assert!((away.linear_error - 0.1).abs() < LAST_BITS);

    let mut reports = [Report::default(); 3];
    let nothing =
        Backend::best().reach(&arm, &[home; 3], &mut [[]; 3], &mut reports, &Options::default());
    assert_eq!(nothing, Ok(()));
    assert!(reports.iter().all(|report| report.outcome == Outcome::Converged));
}

/// In millimetres an arm is the same arm.
#[test]
fn the_unit_of_length_does_not_matter() {
    let scale = 1000.0;
    let metres = puma();
    let mut millimetres = metres;
    for axis in &mut millimetres.axes {
        axis.through = axis.through.map(|c| c * scale);
    }
    millimetres.home.2 = metres.home.2.map(|c| c * scale);
    let (small, large) = (metres.arm::<f64>(), millimetres.arm::<f64>());
    let mut random = Random(9);
    for _ in 0..20 {
        let (goal, start) = (metres.draw(&mut random), metres.draw(&mut random));
        let (mut a, mut b) = (start, start);
        let once = Options { restarts: false, ..Options::default() };
        let finer = Options { linear_tolerance: 1e-5 * scale, ..once };
        let in_metres = small.reach(small.forward(&goal), &mut a, &once);
        let in_millimetres = large.reach(large.forward(&goal), &mut b, &finer);
        if in_metres.outcome == Outcome::Converged {
            assert_eq!(in_metres.iterations, in_millimetres.iterations);
            for (a, b) in a.into_iter().zip(b) {
                assert!((a - b).abs() < SAME_STEPS, "{a} {b}");
            }
        }
    }
}

/// What is tried is what there is: 128 poses, each once, and then no more.
#[test]
fn a_search_ends_after_a_restart_from_each_of_its_128_poses() {
    let up = [0.0, 0.0, 1.0_f64];
    let joints = [0.0, 1.0, 2.0].map(|x| Joint::revolute(up, [x, 0.0, 0.0]));
    let arm = Arm::new(joints, DualQuat::from_translation([2.0, 0.0, 0.0])).expect("an arm");
    let tilt = Quat::from_axis_angle([1.0, 0.0, 0.0], 0.25);
    let target = DualQuat::from_rotation_translation(tilt, [1.0, 0.5, 0.0]);
    let options = Options { max_iterations: 100_000, ..Options::default() };
    let mut values = [0.2, 0.7, -0.5];
    let report = arm.reach(target, &mut values, &options);
    assert_eq!((report.outcome, report.restarts), (Outcome::Stalled, 128), "{report:?}");
    assert!(report.iterations < 3000, "{report:?}");
}
