//! What a report says where there is no solution, or not yet.

use super::{
    LAST_BITS, REACHED, ROUNDING, START, THERE, Z, apart, at, draw, near, planar, pose, problem,
    seven, solve, solve_with, turned,
};
use dq8::{DualQuat, Quat};
use dq8_fixtures::random::Random;
use dq8_robot::Joint;
use dq8_robot::ik::{Goal, Options, Outcome};

#[test]
fn beyond_the_length_of_the_arm_is_out_of_reach_and_the_arm_points_there() {
    let arm = problem(&planar(&[1.0, 1.0]), [Goal::position(2)]);
    let (values, report) = solve(&arm, at(0.0, 5.0, 0.0), [0.4, 0.9]);
    assert_eq!(report.outcome, Outcome::OutOfReach);
    assert!((report.linear_error - 3.0).abs() < ROUNDING, "{report:?}");
    let [x, y, _] = pose(&arm, &values, 2).translation();
    assert!(x.abs() < 0.1 && y > 1.99, "{x} {y}");
}

/// An arm that is as far from the base as it gets weighs a turn against the lengths of its links,
/// and not against the way that is missing.
#[test]
fn how_far_beyond_reach_a_pose_is_does_not_change_what_comes_nearest() {
    let arm = problem(&planar(&[1.0, 1.0, 0.5]), [Goal::pose(3)]);
    let [values, farther] = [5.0, 500.0].map(|far| {
        let (values, report) = solve(&arm, turned(Z, 0.3, [0.0, far, 0.0]), [0.9, 0.5, 0.4]);
        assert_eq!(report.outcome, Outcome::OutOfReach);
        values
    });
    assert!(near(&values, &farther, 1e-6), "{values:?} {farther:?}");
}

#[test]
fn the_bound_of_the_reach_is_the_sum_of_the_offsets() {
    let problem = problem(&seven(), [Goal::pose(7)]);
    let (centre, length) = problem.view().reach_bound(0).expect("a bound");
    let offsets = 0.32 + 0.08 + 0.08_f64.hypot(0.39) + 0.09 + 0.11;
    assert!(near(&centre, &[0.0, 0.0, 0.34], LAST_BITS), "{centre:?}");
    assert!((length - offsets).abs() < LAST_BITS, "{length}");
    assert_eq!(problem.view().reach_bound(1), None);
}

/// Two links of lengths 1 and 0.4 leave a hole about the base.
#[test]
fn within_the_length_of_the_arm_what_no_way_leads_to_is_stalled() {
    let arm = problem(&planar(&[1.0, 0.4]), [Goal::position(2)]);
    for (restarts, near) in [(false, 1e-3), (true, 0.02)] {
        let options = Options { restarts, ..Options::default() };
        let (_, report) = solve_with(&arm, &[at(0.2, 0.0, 0.0)], [0.3, 0.8], &options);
        assert_eq!(report.outcome, Outcome::Stalled, "{report:?}");
        assert!((report.linear_error - 0.4).abs() < near, "{report:?}");
    }
}

#[test]
fn what_limits_forbid_is_at_limits() {
    let mut joints = planar(&[1.0, 1.0]);
    joints[0] = joints[0].with_limits([-0.5, 0.5]);
    joints[1] = joints[1].with_limits([0.0, 1.0]);
    let arm = problem(&joints, [Goal::position(2)]);
    let (values, report) = solve(&arm, at(-1.0, 1.0, 0.0), [0.0, 0.5]);
    assert_eq!(report.outcome, Outcome::AtLimits);
    assert!(near(&values, &[0.5, 1.0], LAST_BITS), "{values:?}");
}

/// From a start, from where too few iterations lead to, from the target itself, and from half a
/// turn away; a target may be a little off unit.
#[test]
fn what_can_be_reached_converges_and_a_start_at_the_target_keeps_its_bits() {
    let arm = problem(&seven(), [Goal::pose(7)]);
    let target = pose(&arm, &THERE, 7);
    let options = Options { max_iterations: 2, ..Options::default() };
    let (values, report) = solve_with(&arm, &[target], START, &options);
    assert_eq!((report.outcome, report.iterations), (Outcome::Unfinished, 2));
    let turn = DualQuat::from_rotation(Quat::from_axis_angle(Z, core::f64::consts::PI));
    for (target, start, there) in [
        (target, values, target),
        (target, START, target),
        (target.scale(1.0009), START, target),
        (target.scale(0.9991), START, target),
        (target * turn, THERE, target * turn),
    ] {
        let (values, report) = solve(&arm, target, start);
        assert_eq!(report.outcome, Outcome::Converged, "{report:?}");
        let [turn, distance] = apart(pose(&arm, &values, 7), there);
        assert!(turn < REACHED && distance < REACHED, "{turn} {distance}");
    }
    let (values, report) = solve(&arm, target, THERE);
    assert_eq!((report.outcome, report.iterations, values), (Outcome::Converged, 0, THERE));
}

#[test]
fn a_target_that_moves_is_followed_in_two_iterations_without_restarts() {
    let arm = problem(&seven(), [Goal::pose(7)]);
    let options = Options { restarts: false, ..Options::default() };
    let (mut values, home) = (THERE, pose(&arm, &THERE, 7));
    for step in 1..=40 {
        let target = turned(Z, 0.01 * f64::from(step), [0.0; 3]) * home;
        let (next, report) = solve_with(&arm, &[target], values, &options);
        assert_eq!(report.outcome, Outcome::Converged);
        assert!(report.iterations <= 2 && report.restarts == 0, "{report:?}");
        assert!(near(&next, &values, 0.1), "{next:?} {values:?}");
        values = next;
    }
}

/// Three hinges at one point reach nothing but that point, which is rounded as far from the base as
/// it lies.
#[test]
fn a_tool_that_cannot_move_away_reaches_where_it_is() {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], Z];
    let places = [at(60.0, 0.0, 80.0), DualQuat::IDENTITY, DualQuat::IDENTITY];
    let joint = |i: usize| Joint::revolute(i.checked_sub(1), places[i], axes[i]);
    let mut wrist = problem::<f32>(&[0, 1, 2].map(joint), [Goal::pose(2)]);
    // Of the bound alone depends what is out of reach.
    let tight = Options::<f32> { linear_tolerance: 0.0, ..Options::default() };
    for step in 0..200 {
        let mut values = [0.01, 0.02, 0.03].map(|rate| rate * step as f32);
        let target = pose(&wrist, &values, 2);
        let report = wrist.solve(&[target], &mut values, &tight).expect("lengths fit");
        assert_ne!(report.outcome, Outcome::OutOfReach, "{step}");
        assert!(report.linear_error < 1e-4, "{step}: {report:?}");
    }
}

/// The code of restarts is all that it leaves out.
#[test]
fn following_is_solving_without_restarts() {
    let problem = problem(&seven(), [Goal::pose(7)]);
    let (mut random, mut converged) = (Random(72), 0);
    let mut scratch = vec![f64::NAN; problem.view().scratch_len()];
    for _ in 0..100 {
        let [there, start] = [(); 2].map(|()| draw(&mut random, &seven()));
        let target = pose(&problem, &there, 7);
        let once = Options { restarts: false, ..Options::default() };
        let start: [f64; 7] = start.try_into().expect("seven");
        let (solved, wanted) = solve_with(&problem, &[target], start, &once);
        for restarts in [false, true] {
            let (options, mut values) = (Options { restarts, ..once }, start);
            let found = problem.view().follow(&[target], &mut values, &mut scratch, &options);
            assert_eq!((found, values), (Ok(wanted), solved));
        }
        converged += usize::from(wanted.is_converged());
    }
    assert!((30..100).contains(&converged), "{converged}");
}
