//! Limits: of one end, of none, and of what mimics a joint.

use super::{LAST_BITS, REACHED, X, Y, Z, at, near, pose, problem, solve, solve_with, solved};
use dq8::DualQuat;
use dq8_robot::Joint;
use dq8_robot::ik::{Goal, Options, Outcome};
use std::f64::consts::TAU;

const HERE: DualQuat<f64> = DualQuat::IDENTITY;
const OPEN: f64 = f64::INFINITY;

/// A slide with one end, and a hinge with one end: it counts as endless.
#[test]
fn limits_may_be_open_at_one_end() {
    let joints = [
        Joint::prismatic(None, HERE, X).with_limits([0.0, OPEN]),
        Joint::revolute(Some(0), HERE, Z).with_limits([-OPEN, 1.0]),
        Joint::prismatic(Some(1), HERE, Y).with_limits([-OPEN, 0.0]),
    ];
    let machine = problem(&joints, [Goal::pose(2)]);
    let there = [3.0, -0.5, -2.0];
    let (values, report) = solve(&machine, pose(&machine, &there, 2), [2.5, -0.3, -1.5]);
    assert!(report.is_converged() && near(&values, &there, REACHED), "{report:?} {values:?}");
    // Behind both ends.
    let machine = problem(&joints, [Goal::pose(2).with_angular([50.0; 3])]);
    let behind = pose(&machine, &[-3.0, 0.0, 2.0], 2);
    let options = Options { restarts: false, ..Options::default() };
    let (values, report) = solve_with(&machine, &[behind], values, &options);
    assert_eq!(report.outcome, Outcome::AtLimits, "{report:?}");
    assert!(values[0] == 0.0 && values[2] == 0.0, "{values:?}");
}

/// The second finger has the narrower limits.
#[test]
fn limits_of_joints_that_mimic_hold_for_the_joint_that_they_follow() {
    let finger = Joint::prismatic(None, HERE, [0.0, -1.0, 0.0]).with_limits([-0.01, 0.05]);
    let joints =
        [Joint::prismatic(None, HERE, Y).with_limits([0.0, 0.04]), finger.mimicking(0, 2.0, -0.01)];
    let fingers = problem(&joints, [Goal::position(1)]);
    let (values, report) = solve(&fingers, at(0.0, -0.2, 0.0), [0.0]);
    assert_eq!(report.outcome, Outcome::OutOfReach, "{report:?}");
    assert!(near(&values, &[0.03], LAST_BITS), "{values:?}");
    let (values, report) = solve(&fingers, at(0.0, -0.03, 0.0), values);
    assert!(report.is_converged() && near(&values, &[0.02], REACHED), "{report:?} {values:?}");
}

/// Two fingers that turn against each other, and others whose limits are those of the leader,
/// without the sign, the factor or the offset between them.
#[test]
fn limits_of_joints_that_mimic_do_not_hold_where_they_leave_no_range() {
    let knuckle = Joint::revolute(None, at(0.0, 0.03, 0.05), X).with_limits([0.0, 0.8]);
    let inner = Joint::revolute(Some(0), at(0.0, 0.06, 0.03), X);
    for (limits, multiplier, offset) in [
        ([0.0, 0.8757], -1.0, 0.0), // one value
        ([0.1, 0.8757], -1.0, 0.0), // none
        ([0.0, 0.8], 1.0, 2.0),
        ([5.0, 6.0], 1.0, 0.0),
        ([1.0, 2.0], 0.0, 0.5), // it stands, and beyond its limits
        ([-0.0, 0.0], -0.5, 0.0),
    ] {
        let fingers = [knuckle, inner.with_limits(limits).mimicking(0, multiplier, offset)];
        let hand = problem::<f64>(&fingers, [Goal::pose(1)]);
        let (values, report) = solve(&hand, pose(&hand, &[0.4], 1), [0.4]);
        assert!(report.is_converged() && report.iterations == 0, "{limits:?}: {report:?}");
        assert_eq!(values, [0.4]);
        let single = problem::<f32>(&fingers, [Goal::pose(1)]);
        for (backend, values, reports) in
            solved(&single, &[pose(&single, &[0.4], 1)], &[0.5], &Options::default())
        {
            assert!(reports[0].is_converged(), "{backend}: {reports:?} {values:?}");
        }
        let mut said = [[0.0; 2]];
        hand.view().mechanism().value_limits(&mut said).unwrap();
        assert_eq!(said, [[0.0, 0.8]], "{limits:?}");
    }
}

/// A rod beside the arm, whose limits are narrower than the way that it goes with the arm.
#[test]
fn limits_of_joints_that_mimic_and_carry_no_goal_do_not_hold() {
    let joints = [
        Joint::revolute(None, HERE, Z).with_limits([-2.0, 2.0]),
        Joint::revolute(None, at(0.0, 0.1, 0.0), Z).with_limits([-0.5, 0.5]).mimicking(0, 1.0, 0.0),
        Joint::fixed(Some(0), at(1.0, 0.0, 0.0)),
    ];
    let arm = problem::<f64>(&joints, [Goal::position(2)]);
    let (values, report) = solve(&arm, pose(&arm, &[1.5], 2), [0.0]);
    assert!(report.is_converged() && near(&values, &[1.5], REACHED), "{report:?} {values:?}");
    // The range that is told, and drawn from, keeps both.
    let mut said = [[0.0; 2]];
    arm.view().mechanism().value_limits(&mut said).unwrap();
    assert_eq!(said, [[-0.5, 0.5]]);
}

/// Values that are reached: of what mimics far from zero, of what is not the same a turn less (a
/// rack on its pinion, a nut, a hinge that turns half as much), and of what is, where the nearest
/// to the start is meant.
#[test]
fn what_mimics_a_hinge_says_which_of_its_turns_are_the_same() {
    let pinion = Joint::revolute(None, HERE, Z);
    let follower = Joint::revolute(Some(0), at(1.0, 0.0, 0.0), Z);
    for (follower, there, start, wanted, times) in [
        (follower.with_limits([10.0, 12.0]).mimicking(0, 1.0, 0.0), 11.0, 0.0, 11.0, 1.0),
        // The rack moves by a twentieth of the turn.
        (Joint::prismatic(None, HERE, X).mimicking(0, 0.05, 0.0), 7.0, 6.5, 7.0, 20.0),
        (Joint::screw(None, HERE, Z, 0.05).mimicking(0, 1.0, 0.0), 7.0, 6.5, 7.0, 20.0),
        (Joint::revolute(None, HERE, Z).mimicking(0, 0.5, 0.0), 7.0, 6.5, 7.0, 20.0),
        (Joint::revolute(None, HERE, Z).mimicking(0, 0.5, 0.0), 7.0, 0.0, 7.0 - 2.0 * TAU, 20.0),
        (follower.mimicking(0, 2.0, 0.0), 7.0, 60.0, 7.0 + 8.0 * TAU, 1.0),
    ] {
        let machine = problem(&[pinion, follower], [Goal::pose(1)]);
        let (values, report) = solve(&machine, pose(&machine, &[there], 1), [start]);
        assert!(report.is_converged(), "{follower:?}: {report:?}");
        assert!(near(&values, &[wanted], times * REACHED), "{follower:?}: {values:?}");
    }
}

/// Where a limit has no other end, restarts begin with the start: with what became of it.
#[test]
fn values_are_within_limits_of_one_end_after_restarts_too() {
    let joints = [
        Joint::prismatic(None, HERE, X).with_limits([0.0, OPEN]),
        Joint::revolute(Some(0), HERE, Z).with_limits([-1.0, 1.0]),
        Joint::fixed(Some(1), at(1.0, 0.0, 0.0)),
    ];
    let machine = problem(&joints, [Goal::position(2)]);
    let (values, report) = solve(&machine, at(-3.5, 0.8, 0.0), [-4.0, 0.5]);
    assert_eq!(report.outcome, Outcome::AtLimits, "{report:?} {values:?}");
    assert!(report.restarts > 0 && values[0] >= 0.0, "{report:?} {values:?}");
}

/// Their width is no number: there is nothing between that restarts could tell apart.
#[test]
fn limits_as_wide_as_numbers_get_are_none() {
    let whole = [f64::MIN, f64::MAX];
    let joints = [
        Joint::prismatic(None, HERE, X).with_limits(whole),
        Joint::revolute(Some(0), HERE, Z).with_limits(whole),
        Joint::revolute(Some(1), at(1.0, 0.0, 0.0), Z).with_limits([-0.2, 0.2]),
        Joint::fixed(Some(2), at(0.5, 0.0, 0.0)),
    ];
    let machine = problem(&joints, [Goal::pose(3)]);
    assert_eq!(machine.view().reach_bound(0), None);
    // Out of its plane: restarts are of no use, but they are tried.
    let (values, report) = solve(&machine, at(30.0, 0.3, 0.4), [5.0, 2.0, 0.1]);
    assert_eq!(report.outcome, Outcome::AtLimits, "{report:?} {values:?}");
    assert!(report.restarts > 0 && values.iter().all(|value| value.is_finite()), "{values:?}");
    assert!((report.linear_error - 0.4).abs() < 0.1, "{report:?} {values:?}");
}

/// A nut on a thread without end.
#[test]
fn an_endless_thread_has_no_bound() {
    let machine = problem(&[Joint::screw(None, HERE, Z, 0.1)], [Goal::position(0)]);
    assert_eq!(machine.view().reach_bound(0), None);
    let (values, report) = solve(&machine, pose(&machine, &[90.0], 0), [86.0]);
    assert!(report.is_converged() && near(&values, &[90.0], REACHED), "{report:?} {values:?}");
}

#[test]
fn limits_of_joints_that_move_no_goal_do_not_matter() {
    let joints = [
        Joint::revolute(None, HERE, Z),
        Joint::fixed(Some(0), at(1.0, 0.0, 0.0)),
        Joint::revolute(None, HERE, Z).with_limits([1e30, 2e30]),
    ];
    let machine = problem(&joints, [Goal::pose(1)]);
    let (values, report) = solve(&machine, pose(&machine, &[0.7, 1e30], 1), [0.0, 1e30]);
    assert!(report.is_converged() && values[1] == 1e30, "{report:?} {values:?}");
}
