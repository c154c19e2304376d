//! Goals that leave something free, several goals, and weights.

use super::{REACHED, apart, at, draw, mechanism, seven, solve, solve_everywhere, turned};
use dq8::DualQuat;
use dq8_fixtures::random::Random;
use dq8_robot::Joint;
use dq8_robot::ik::{Freedom, Goal, Options, Outcome, Reach};

/// Targets of random configurations, and starts; what the goal leaves free is changed in the targets.
fn reached(
    goal: Goal<f64>,
    free: impl Fn(&mut Random) -> DualQuat<f64>,
) -> Vec<[DualQuat<f64>; 2]> {
    let joints = seven();
    let arm = mechanism::<f64>(&joints);
    let arm = arm.view();
    let mut random = Random(5);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..200 {
        let pose = arm.link_pose(&draw(&mut random, &joints), 7).expect("a link");
        targets.push(pose * free(&mut random));
        starts.extend(draw(&mut random, &joints));
    }
    let goals = [goal];
    let mut freedoms = [Freedom::default(); 7];
    let reach = Reach::new(arm, &goals, &mut freedoms).expect("a problem");
    let mut pairs = Vec::new();
    for (_, values, reports) in solve_everywhere(&reach, &targets, &starts, &Options::default()) {
        let (mut converged, mut iterations) = (0, 0.0);
        for (index, report) in reports.iter().enumerate() {
            if report.outcome == Outcome::Converged {
                let pose = arm.link_pose(&values[7 * index..][..7], 7).expect("a link");
                pairs.push([pose, targets[index]]);
                converged += 1;
                iterations += f64::from(report.iterations);
            }
        }
        assert!(converged >= 198, "{converged} of 200");
        assert!(iterations < 12.0 * f64::from(converged), "{iterations} for {converged}");
    }
    pairs
}

#[test]
fn where_only_the_position_is_asked_for_the_rotation_is_free() {
    let any = |random: &mut Random| {
        turned(super::Z, 3.0 * random.signed(), [0.0; 3]) * turned([0.6, 0.8, 0.0], 2.0, [0.0; 3])
    };
    for [pose, target] in reached(Goal::position(7), any) {
        assert!(apart(pose, target)[1] < REACHED);
    }
}

#[test]
fn where_only_the_rotation_is_asked_for_the_position_is_free() {
    for [pose, target] in reached(Goal::orientation(7), |_| at(9.0, -7.0, 5.0)) {
        assert!(apart(pose, target)[0] < REACHED);
    }
}

/// A drill: any turn about the z axis of the target will do, half a turn too.
#[test]
fn a_turn_about_an_axis_of_the_target_may_be_free() {
    let goal = Goal::pose(7).with_angular([1.0, 1.0, 0.0]);
    let spin = |random: &mut Random| turned(super::Z, 3.1 * random.signed(), [0.0; 3]);
    for [pose, target] in reached(goal, spin) {
        assert!(apart(pose, target)[1] < REACHED);
        let [a, b] = [pose, target].map(|pose| pose.rotation().rotate(super::Z));
        let off = (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2]);
        assert!(off < REACHED, "{off}");
    }
}

/// A cup on a table: anywhere along the x axis of the target.
#[test]
fn the_way_along_an_axis_of_the_target_may_be_free() {
    let goal = Goal::pose(7).with_linear([0.0, 1.0, 1.0]);
    let slide = |random: &mut Random| at(4.0 * random.signed(), 0.0, 0.0);
    for [pose, target] in reached(goal, slide) {
        assert!(apart(pose, target)[0] < REACHED);
        let [_, y, z] = (target.conjugate() * pose).translation();
        assert!(y.hypot(z) < REACHED, "{y} {z}");
    }
}

/// Two arms on a trunk that turns.
fn two_arms() -> Vec<Joint<f64>> {
    let mut joints =
        vec![Joint::revolute(None, at(0.0, 0.0, 1.0), super::Z).with_limits([-1.0, 1.0])];
    for side in [-1.0, 1.0] {
        let shoulder = Some(0);
        let first = joints.len();
        joints.push(Joint::revolute(shoulder, at(0.0, 0.2 * side, 0.0), [0.0, 1.0, 0.0]));
        joints.push(Joint::revolute(Some(first), DualQuat::IDENTITY, super::Z));
        joints.push(Joint::revolute(Some(first + 1), at(0.3, 0.0, 0.0), [0.0, 1.0, 0.0]));
        joints.push(Joint::fixed(Some(first + 2), at(0.3, 0.0, 0.0)));
    }
    joints
}

#[test]
fn two_hands_come_to_two_targets_at_once() {
    let joints = two_arms();
    let body = mechanism::<f64>(&joints);
    let body = body.view();
    let goals = [Goal::position(4), Goal::position(8)];
    let mut freedoms = [Freedom::default(); 7];
    let reach = Reach::new(body, &goals, &mut freedoms).expect("a problem");
    let mut random = Random(3);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..100 {
        let goal: Vec<f64> = (0..7).map(|_| random.signed()).collect();
        targets.extend([4, 8].map(|link| body.link_pose(&goal, link).expect("a link")));
        starts.extend((0..7).map(|_| random.signed()));
    }
    for (_, values, reports) in solve_everywhere(&reach, &targets, &starts, &Options::default()) {
        for (index, report) in reports.iter().enumerate() {
            assert_eq!(report.outcome, Outcome::Converged, "{index}: {report:?}");
            for (goal, target) in goals.iter().zip(&targets[2 * index..]) {
                let own = &values[7 * index..][..7];
                let pose = body.link_pose(own, goal.link).expect("a link");
                assert!(apart(pose, *target)[1] < REACHED);
            }
        }
    }
}

/// A search stalls where a step gains nothing that `f64` sees: on the root of its roundoff.
const AT_REST: f64 = 2e-8;

/// One slide between two targets that it cannot both reach divides its way by the squares of the weights.
#[test]
fn the_heavier_of_two_goals_is_the_nearer() {
    let joints = [
        Joint::prismatic(None, DualQuat::IDENTITY, [1.0, 0.0, 0.0]).with_limits([-5.0, 5.0]),
        Joint::fixed(Some(0), DualQuat::IDENTITY),
    ];
    let slide = mechanism::<f64>(&joints);
    let goals = [Goal::position(0).with_linear([2.0; 3]), Goal::position(1)];
    let mut values = [0.3];
    let targets = [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0)];
    let report = solve(slide.view(), &goals, &targets, &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Stalled);
    assert!((values[0] - 0.2).abs() < AT_REST, "{values:?}");
    assert!((report.linear_error - 0.8).abs() < AT_REST, "{report:?}");
}

#[test]
fn joints_that_carry_no_goal_keep_their_values_whatever_they_are() {
    let joints = two_arms();
    let body = mechanism::<f64>(&joints);
    let target = body.view().link_pose(&[0.2, 0.3, 0.4, 0.5, 0.0, 0.0, 0.0], 4).expect("a link");
    let mut values = [0.0, 0.1, 0.1, 0.1, f64::NAN, 1e300, -0.0];
    let goals = [Goal::position(4)];
    let report = solve(body.view(), &goals, &[target], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Converged, "{report:?}");
    let bits = [values[4], values[5], values[6]].map(f64::to_bits);
    assert_eq!(bits, [f64::NAN, 1e300, -0.0].map(f64::to_bits));
}
