//! The steps of a search on arms from screws.

use dq8::geometry::Screw;
use dq8::{DualQuat, Line, Quat};
use dq8_arms::{Arm, Random, ur5};
use dq8_robot::ik::{Options, Outcome};

/// A number of about 1 that nothing but its limits or its target decides.
const LAST_BITS: f64 = 1e-15;
/// The same steps with a joint that does not move: each rounds what came before.
const SAME_STEPS: f64 = 1e-12;

/// Beyond the bound in every direction, from just beyond to as far as numbers go.
#[test]
fn a_target_beyond_the_arm_is_out_of_reach_and_the_arm_stretches_toward_it() {
    let (plan, mut random) = (ur5(), Random(6));
    let arm = plan.arm::<f64>();
    let (_, length) = arm.bound();
    for (far, rounding) in [(1.001, 1e-12), (2.0, 1e-12), (1e3, 1e-9), (1e100, 1e88)] {
        let mut excess = 0.0;
        for _ in 0..20 {
            let direction = Quat::from_array(random.vector()).normalize().rotate([1.0, 0.0, 0.0]);
            let turn = Quat::from_axis_angle([0.6, 0.0, 0.8], random.between(0.0, 1.0));
            let at = direction.map(|c| c * far * length);
            let target = DualQuat::from_rotation_translation(turn, at);
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

/// A slide that cannot move asks for a share of every step and gets none; the others step as if it
/// were not there.
#[test]
fn a_joint_held_at_its_limits_is_as_none() {
    let (plan, mut random) = (ur5(), Random(11));
    let arm = plan.arm::<f64>();
    let [a, b, c, d, e, f] = plan.axes.map(|axis| axis.screw());
    let axis = Line { direction: [1.0, 0.0, 0.0], moment: [0.0; 3] };
    let stuck = (Screw { axis, angle: 0.0, slide: 1.0 }, [0.0, 0.0]);
    let longer = Arm::new(&[a, b, c, stuck, d, e, f], arm.forward(&[0.0; 6])).expect("an arm");
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

/// In front of a singular pose the Jacobian promises everything. Neither the limit of a step nor
/// what the damping allows, |e|/(2λ), is exceeded; and without damping the second would be.
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
