//! Limits: of one end, of none, and of what mimics a joint.

use super::{LAST_BITS, REACHED, at, mechanism, planar, solve, turned};
use dq8::DualQuat;
use dq8_robot::ik::{Freedom, Goal, Options, Outcome, Reach};
use dq8_robot::{Joint, JointKind};

/// A slide with one end, and a hinge with one end: it counts as endless.
#[test]
fn limits_may_be_open_at_one_end() {
    let open = f64::INFINITY;
    let joints = [
        Joint::prismatic(None, DualQuat::IDENTITY, [1.0, 0.0, 0.0]).with_limits([0.0, open]),
        Joint::revolute(Some(0), DualQuat::IDENTITY, super::Z).with_limits([-open, 1.0]),
        Joint::prismatic(Some(1), DualQuat::IDENTITY, [0.0, 1.0, 0.0]).with_limits([-open, 0.0]),
    ];
    let machine = mechanism::<f64>(&joints);
    let goals = [Goal::pose(2)];
    let target = machine.view().link_pose(&[3.0, -0.5, -2.0], 2).expect("a link");
    let mut values = [2.5, -0.3, -1.5];
    let report = solve(machine.view(), &goals, &[target], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Converged, "{report:?}");
    assert!((values[0] - 3.0).abs() < REACHED && (values[2] + 2.0).abs() < REACHED, "{values:?}");
    assert!((values[1] + 0.5).abs() < REACHED, "{values:?}");
    // Behind both ends.
    let behind = machine.view().link_pose(&[-3.0, 0.0, 2.0], 2).expect("a link");
    let goals = [Goal::pose(2).with_angular([50.0; 3])];
    let options = Options { restarts: false, ..Options::default() };
    let report = solve(machine.view(), &goals, &[behind], &mut values, &options);
    assert_eq!(report.outcome, Outcome::AtLimits, "{report:?}");
    assert!(values[0] == 0.0 && values[2] == 0.0, "{values:?}");
}

#[test]
fn endless_hinges_end_within_half_a_turn_of_the_start() {
    let arm = mechanism::<f64>(&planar(&[1.0, 1.0, 0.5]));
    let target = turned(super::Z, 1.0, [1.2, 0.8, 0.0]);
    let start = [60.0, -75.0, 1000.0];
    let mut values = start;
    let report = solve(arm.view(), &[Goal::pose(3)], &[target], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Converged);
    for (value, start) in values.iter().zip(start) {
        assert!((value - start).abs() <= core::f64::consts::PI, "{values:?}");
    }
}

/// The second finger has the narrower limits.
#[test]
fn limits_of_joints_that_mimic_hold_for_the_joint_that_they_follow() {
    let joints = [
        Joint::prismatic(None, DualQuat::IDENTITY, [0.0, 1.0, 0.0]).with_limits([0.0, 0.04]),
        Joint::prismatic(None, DualQuat::IDENTITY, [0.0, -1.0, 0.0])
            .with_limits([-0.01, 0.05])
            .mimicking(0, 2.0, -0.01),
    ];
    let fingers = mechanism::<f64>(&joints);
    let mut values = [0.0];
    let goals = [Goal::position(1)];
    let far = at(0.0, -0.2, 0.0);
    let report = solve(fingers.view(), &goals, &[far], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::OutOfReach, "{report:?}");
    assert!((values[0] - 0.03).abs() < LAST_BITS, "{values:?}");
    let near = at(0.0, -0.03, 0.0);
    let report = solve(fingers.view(), &goals, &[near], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Converged, "{report:?}");
    assert!((values[0] - 0.02).abs() < REACHED, "{values:?}");
}

/// The limits of the second hinge are far from zero, where the first one would be.
#[test]
fn an_endless_hinge_goes_where_what_mimics_it_may_go() {
    let joints = [
        Joint::revolute(None, DualQuat::IDENTITY, super::Z),
        Joint::revolute(Some(0), at(1.0, 0.0, 0.0), super::Z)
            .with_limits([10.0, 12.0])
            .mimicking(0, 1.0, 0.0),
    ];
    let arm = mechanism::<f64>(&joints);
    let target = arm.view().link_pose(&[11.0], 1).expect("a link");
    let mut values = [0.0];
    let report = solve(arm.view(), &[Goal::pose(1)], &[target], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Converged, "{report:?}");
    assert!((values[0] - 11.0).abs() < REACHED, "{values:?}");
}

/// A turn less is another pose: of a rack on its pinion, of a nut, and of a hinge that turns half as much.
#[test]
fn what_is_not_the_same_a_turn_less_keeps_its_turns() {
    let pinion = Joint::revolute(None, DualQuat::IDENTITY, super::Z);
    let thread = JointKind::Screw { axis: super::Z, pitch: 0.05 };
    let followers = [
        Joint::prismatic(None, DualQuat::IDENTITY, [1.0, 0.0, 0.0]).mimicking(0, 0.05, 0.0),
        Joint::new(None, DualQuat::IDENTITY, thread).mimicking(0, 1.0, 0.0),
        Joint::revolute(None, DualQuat::IDENTITY, super::Z).mimicking(0, 0.5, 0.0),
    ];
    for (index, follower) in followers.into_iter().enumerate() {
        let machine = mechanism::<f64>(&[pinion, follower]);
        let target = machine.view().link_pose(&[7.0], 1).expect("a link");
        let mut values = [6.5];
        let goals = [Goal::pose(1)];
        let report = solve(machine.view(), &goals, &[target], &mut values, &Options::default());
        assert_eq!(report.outcome, Outcome::Converged, "{index}: {report:?}");
        // The rack moves by a twentieth of the turn.
        assert!((values[0] - 7.0).abs() < 20.0 * REACHED, "{index}: {values:?}");
    }
    // One that turns twice as much is the same.
    let twice = Joint::revolute(Some(0), at(1.0, 0.0, 0.0), super::Z).mimicking(0, 2.0, 0.0);
    let machine = mechanism::<f64>(&[pinion, twice]);
    let target = machine.view().link_pose(&[7.0], 1).expect("a link");
    let mut values = [60.0];
    let report =
        solve(machine.view(), &[Goal::pose(1)], &[target], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Converged, "{report:?}");
    // Of the turns, the nearest to the start.
    assert!((values[0] - (7.0 + 8.0 * core::f64::consts::TAU)).abs() < REACHED, "{values:?}");
}

/// Where a limit has no other end, restarts begin with the start: with what became of it.
#[test]
fn values_are_within_limits_of_one_end_after_restarts_too() {
    let joints = [
        Joint::prismatic(None, DualQuat::IDENTITY, [1.0, 0.0, 0.0])
            .with_limits([0.0, f64::INFINITY]),
        Joint::revolute(Some(0), DualQuat::IDENTITY, super::Z).with_limits([-1.0, 1.0]),
        Joint::fixed(Some(1), at(1.0, 0.0, 0.0)),
    ];
    let machine = mechanism::<f64>(&joints);
    let target = at(-3.5, 0.8, 0.0);
    let mut values = [-4.0, 0.5];
    let goals = [Goal::position(2)];
    let report = solve(machine.view(), &goals, &[target], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::AtLimits, "{report:?} {values:?}");
    assert!(report.restarts > 0 && values[0] >= 0.0, "{report:?} {values:?}");
}

/// Their width is no number: there is nothing between that restarts could tell apart.
#[test]
fn limits_as_wide_as_numbers_get_are_none() {
    let whole = [f64::MIN, f64::MAX];
    let joints = [
        Joint::prismatic(None, DualQuat::IDENTITY, [1.0, 0.0, 0.0]).with_limits(whole),
        Joint::revolute(Some(0), DualQuat::IDENTITY, super::Z).with_limits(whole),
        Joint::revolute(Some(1), at(1.0, 0.0, 0.0), super::Z).with_limits([-0.2, 0.2]),
        Joint::fixed(Some(2), at(0.5, 0.0, 0.0)),
    ];
    let machine = mechanism::<f64>(&joints);
    let goals = [Goal::pose(3)];
    let mut freedoms = [Freedom::default(); 3];
    let reach = Reach::new(machine.view(), &goals, &mut freedoms).expect("a problem");
    assert_eq!(reach.reach_bound(0), None);
    // Out of its plane: restarts are of no use, but they are tried.
    let target = at(30.0, 0.3, 0.4);
    let mut values = [5.0, 2.0, 0.1];
    let report = solve(machine.view(), &goals, &[target], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::AtLimits, "{report:?} {values:?}");
    assert!(report.restarts > 0 && values.iter().all(|value| value.is_finite()), "{values:?}");
    assert!((report.linear_error - 0.4).abs() < 0.1, "{report:?} {values:?}");
}

/// A nut on a thread without end.
#[test]
fn an_endless_thread_has_no_bound() {
    let thread = JointKind::Screw { axis: super::Z, pitch: 0.1 };
    let joints = [Joint::new(None, DualQuat::IDENTITY, thread)];
    let machine = mechanism::<f64>(&joints);
    let goals = [Goal::position(0)];
    let mut freedoms = [Freedom::default(); 1];
    let reach = Reach::new(machine.view(), &goals, &mut freedoms).expect("a problem");
    assert_eq!(reach.reach_bound(0), None);
    let mut values = [86.0];
    let far = machine.view().link_pose(&[90.0], 0).expect("a link");
    let report = solve(machine.view(), &goals, &[far], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Converged, "{report:?} {values:?}");
    assert!((values[0] - 90.0).abs() < REACHED, "{values:?}");
}

#[test]
fn limits_of_joints_that_move_no_goal_do_not_matter() {
    let joints = [
        Joint::revolute(None, DualQuat::IDENTITY, super::Z),
        Joint::fixed(Some(0), at(1.0, 0.0, 0.0)),
        Joint::revolute(None, DualQuat::IDENTITY, super::Z).with_limits([1e30, 2e30]),
    ];
    let machine = mechanism::<f64>(&joints);
    let target = machine.view().link_pose(&[0.7, 1e30], 1).expect("a link");
    let mut values = [0.0, 1e30];
    let goals = [Goal::pose(1)];
    let report = solve(machine.view(), &goals, &[target], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Converged, "{report:?}");
    assert_eq!(values[1], 1e30);
}
