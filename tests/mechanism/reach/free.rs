//! Goals that leave something free, several goals, weights, and what a posture does with the freedom.

use super::super::random::Numbers;
use super::{apart, at, draw, mechanism, planar, seven, solve, solve_everywhere, turned};
use dq8::ik::{Options, Outcome};
use dq8::mechanism::{Freedom, Goal, Joint, Reach};
use dq8::{DualQuat, Quat};

/// Targets of random configurations, and starts; what the goal leaves free is changed in the targets.
fn reached(
    goal: Goal<f64>,
    free: impl Fn(&mut Numbers) -> DualQuat<f64>,
) -> Vec<[DualQuat<f64>; 2]> {
    let joints = seven();
    let arm = mechanism::<f64>(&joints);
    let arm = arm.view();
    let mut numbers = Numbers::new(5);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..200 {
        let pose = arm.link_pose(&draw(&mut numbers, &joints), 7).expect("a link");
        targets.push(pose * free(&mut numbers));
        starts.extend(draw(&mut numbers, &joints));
    }
    let goals = [goal];
    let mut freedoms = [Freedom::default(); 7];
    let reach = Reach::new(arm, &goals, &mut freedoms).expect("a problem");
    let mut pairs = Vec::new();
    for (_, values, reports) in solve_everywhere(&reach, &targets, &starts, &Options::default()) {
        let mut converged = 0;
        for (index, report) in reports.iter().enumerate() {
            if report.outcome == Outcome::Converged {
                let pose = arm.link_pose(&values[7 * index..][..7], 7).expect("a link");
                pairs.push([pose, targets[index]]);
                converged += 1;
            }
        }
        assert!(converged >= 198, "{converged} of 200");
    }
    pairs
}

#[test]
fn where_only_the_position_is_asked_for_the_rotation_is_free() {
    let any = |numbers: &mut Numbers| {
        turned(super::Z, 3.0 * numbers.next(), [0.0; 3]) * turned([0.6, 0.8, 0.0], 2.0, [0.0; 3])
    };
    for [pose, target] in reached(Goal::position(7), any) {
        assert!(apart(pose, target)[1] < 1.001e-5);
    }
}

#[test]
fn where_only_the_rotation_is_asked_for_the_position_is_free() {
    for [pose, target] in reached(Goal::orientation(7), |_| at(9.0, -7.0, 5.0)) {
        assert!(apart(pose, target)[0] < 1.001e-5);
    }
}

/// A drill: any turn about the z axis of the target will do, half a turn too.
#[test]
fn a_turn_about_an_axis_of_the_target_may_be_free() {
    let goal = Goal::pose(7).with_angular([1.0, 1.0, 0.0]);
    let spin = |numbers: &mut Numbers| turned(super::Z, 3.1 * numbers.next(), [0.0; 3]);
    for [pose, target] in reached(goal, spin) {
        assert!(apart(pose, target)[1] < 1.001e-5);
        let [a, b] = [pose, target].map(|pose| pose.rotation().rotate(super::Z));
        let off = (a[0] - b[0]).hypot(a[1] - b[1]).hypot(a[2] - b[2]);
        assert!(off < 2e-5, "{off}");
    }
}

/// A cup on a table: anywhere along the x axis of the target.
#[test]
fn the_way_along_an_axis_of_the_target_may_be_free() {
    let goal = Goal::pose(7).with_linear([0.0, 1.0, 1.0]);
    let slide = |numbers: &mut Numbers| at(4.0 * numbers.next(), 0.0, 0.0);
    for [pose, target] in reached(goal, slide) {
        assert!(apart(pose, target)[0] < 1.001e-5);
        let [_, y, z] = (target.conjugate() * pose).translation();
        assert!(y.hypot(z) < 1.001e-5, "{y} {z}");
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
    let mut numbers = Numbers::new(3);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..100 {
        let goal: Vec<f64> = (0..7).map(|_| numbers.next()).collect();
        targets.extend([4, 8].map(|link| body.link_pose(&goal, link).expect("a link")));
        starts.extend((0..7).map(|_| numbers.next()));
    }
    for (_, values, reports) in solve_everywhere(&reach, &targets, &starts, &Options::default()) {
        for (index, report) in reports.iter().enumerate() {
            assert_eq!(report.outcome, Outcome::Converged, "{index}: {report:?}");
            for (goal, target) in goals.iter().zip(&targets[2 * index..]) {
                let own = &values[7 * index..][..7];
                let pose = body.link_pose(own, goal.link).expect("a link");
                assert!(apart(pose, *target)[1] < 1.001e-5);
            }
        }
    }
}

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
    assert!((values[0] - 0.2).abs() < 1e-3, "{values:?}");
    assert!((report.linear_error - 0.8).abs() < 1e-3, "{report:?}");
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

/// Seven axes have one to spare: the elbow goes toward the posture, and the tool stays.
#[test]
fn a_posture_moves_the_elbow_and_not_the_tool() {
    let joints = seven();
    let arm = mechanism::<f64>(&joints);
    let arm = arm.view();
    let start = [0.5, -0.6, 0.7, -1.4, 0.3, 1.8, -0.4];
    let target = arm.link_pose(&start, 7).expect("a link");
    let posture = [-0.3, -0.6, 1.6, -1.4, -0.3, 1.8, -0.4];
    let goals = [Goal::pose(7)];
    let mut freedoms = [Freedom::default(); 7];
    let reach = Reach::new(arm, &goals, &mut freedoms).expect("a problem");
    let reach = reach.with_posture(&posture).expect("a posture");
    let far = |values: &[f64]| -> f64 {
        values.iter().zip(posture).map(|(value, wish)| (value - wish).powi(2)).sum()
    };
    for (backend, values, reports) in
        solve_everywhere(&reach, &[target], &start, &Options::default())
    {
        assert_eq!(reports[0].outcome, Outcome::Converged, "{backend}");
        let [turn, distance] = apart(arm.link_pose(&values, 7).expect("a link"), target);
        assert!(turn < 1.001e-5 && distance < 1.001e-5, "{backend}: {turn} {distance}");
        assert!(far(&values) < far(&start) - 0.01, "{backend}: {} {}", far(&values), far(&start));
        // Nothing that the tool allows is nearer: the rest is across its self motion.
        let mut columns = [dq8::Twist::from_array([0.0; 6]); 7];
        arm.link_jacobian(dq8::mechanism::World, &values, 7, &mut columns).expect("lengths fit");
        let matrix =
            nalgebra::DMatrix::from_fn(6, 7, |row, column| columns[column].to_array()[row]);
        let inverse = matrix.clone().pseudo_inverse(1e-9).expect("an inverse");
        let wish = nalgebra::DVector::from_fn(7, |row, _| posture[row] - values[row]);
        let free = &wish - &inverse * (&matrix * &wish);
        assert!(free.norm() < 0.02, "{backend}: {}", free.norm());
    }
}

/// From random starts a posture costs no target, and makes the values it ends at fewer.
#[test]
fn with_a_posture_as_many_targets_are_reached() {
    let joints = seven();
    let arm = mechanism::<f64>(&joints);
    let arm = arm.view();
    let posture = [0.0, 0.0, 0.0, -1.5, 0.0, 1.8, 0.0];
    let mut numbers = Numbers::new(9);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..300 {
        targets.push(arm.link_pose(&draw(&mut numbers, &joints), 7).expect("a link"));
        starts.extend(draw(&mut numbers, &joints));
    }
    let goals = [Goal::pose(7)];
    let mut freedoms = [Freedom::default(); 7];
    let reach = Reach::new(arm, &goals, &mut freedoms).expect("a problem");
    let far = |values: &[f64]| -> f64 {
        let squares = values.iter().enumerate().map(|(i, value)| (value - posture[i % 7]).powi(2));
        squares.sum()
    };
    let plain = solve_everywhere(&reach, &targets, &starts, &Options::default());
    let reach = reach.with_posture(&posture).expect("a posture");
    for ((_, with, reports), (_, without, _)) in
        solve_everywhere(&reach, &targets, &starts, &Options::default()).iter().zip(&plain)
    {
        let converged =
            reports.iter().filter(|report| report.outcome == Outcome::Converged).count();
        assert!(converged >= 297, "{converged}");
        assert!(far(with) < 0.9 * far(without), "{} {}", far(with), far(without));
    }
}

/// Of a hinge that turns endlessly the posture is the shorter way away.
#[test]
fn the_posture_of_an_endless_hinge_is_taken_the_shorter_way() {
    let arm = mechanism::<f64>(&planar(&[1.0]));
    let goals = [Goal::position(0)];
    let mut freedoms = [Freedom::default(); 1];
    let reach = Reach::new(arm.view(), &goals, &mut freedoms).expect("a problem");
    let reach = reach.with_posture(&[3.0]).expect("a posture");
    let mut values = [-3.0];
    let mut scratch = vec![0.0; reach.scratch_len()];
    let report = reach
        .solve(
            &[DualQuat::from_rotation(Quat::IDENTITY)],
            &mut values,
            &mut scratch,
            &Options::default(),
        )
        .expect("lengths fit");
    assert_eq!(report.outcome, Outcome::Converged);
    assert!((values[0] - 3.0).abs() < 1e-3, "{values:?}");
    assert!(report.iterations < 10.0, "{report:?}");
}
