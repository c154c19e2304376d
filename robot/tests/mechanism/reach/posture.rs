//! What a posture does with the freedom that goals leave.

use super::{
    REACHED, SETTLED, apart, at, draw, mechanism, planar, problem, seven, solve_everywhere,
};
use dq8::DualQuat;
use dq8_fixtures::random::Random;
use dq8_robot::ik::{Freedom, Goal, Options, Outcome, Reach};
use dq8_robot::{Joint, Mechanism, World};
use std::f64::consts::TAU;

/// How long the part of the way to the posture is that the goal allows: next to nothing where no pose that
/// reaches the target is nearer.
fn across(arm: Mechanism<'_, f64>, goals: &[Goal<f64>; 1], values: &[f64], posture: &[f64]) -> f64 {
    let [Goal { link, angular, linear, .. }] = *goals;
    let count = values.len();
    let mut columns = vec![dq8::Twist::from_array([0.0; 6]); count];
    arm.link_jacobian(World, values, link, &mut columns).expect("lengths fit");
    let [x, y, z] = arm.link_pose(values, link).expect("a link").translation();
    let weights = [angular, linear].concat();
    let matrix = nalgebra::DMatrix::from_fn(6, count, |row, column| {
        let [a, b, c, u, v, w] = columns[column].to_array();
        // At the link instead of the origin.
        let there = [u + b * z - c * y, v + c * x - a * z, w + a * y - b * x];
        weights[row] * [a, b, c, there[0], there[1], there[2]][row]
    });
    let inverse = matrix.clone().pseudo_inverse(1e-9).expect("an inverse");
    let wish = nalgebra::DVector::from_fn(count, |row, _| posture[row] - values[row]);
    (&wish - &inverse * (&matrix * &wish)).norm()
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
        assert!(turn < REACHED && distance < REACHED, "{backend}: {turn} {distance}");
        assert!(far(&values) < far(&start) - 0.01, "{backend}: {} {}", far(&values), far(&start));
        let free = across(arm, &goals, &values, &posture);
        assert!(free < SETTLED, "{backend}: {free}");
    }
}

/// A search that has not arrived knows nothing of a posture: none costs a target, and values come nearer to it.
#[test]
fn with_a_posture_as_many_targets_are_reached() {
    let joints = seven();
    let arm = mechanism::<f64>(&joints);
    let arm = arm.view();
    let posture = [0.0, 0.0, 0.0, -1.5, 0.0, 1.8, 0.0];
    let mut random = Random(9);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..150 {
        targets.push(arm.link_pose(&draw(&mut random, &joints), 7).expect("a link"));
        starts.extend(draw(&mut random, &joints));
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
    for ((backend, with, reports), (_, without, expected)) in
        solve_everywhere(&reach, &targets, &starts, &Options::default()).iter().zip(&plain)
    {
        for (index, (report, expected)) in reports.iter().zip(expected).enumerate() {
            assert_eq!(report.outcome, expected.outcome, "{backend}: {index}");
            assert_eq!(report.restarts, expected.restarts, "{backend}: {index}");
        }
        assert!(far(with) < 0.9 * far(without), "{} {}", far(with), far(without));
    }
}

/// Five hinges for a point in a plane leave three.
#[test]
fn a_planar_arm_goes_as_near_to_the_posture_as_its_point_allows() {
    let arm = mechanism::<f64>(&planar(&[0.5; 5]));
    let arm = arm.view();
    let posture = [0.3, 0.5, -0.4, 0.8, 0.6];
    let goals = [Goal::position(5)];
    let mut freedoms = [Freedom::default(); 5];
    let reach = Reach::new(arm, &goals, &mut freedoms).expect("a problem");
    let reach = reach.with_posture(&posture).expect("a posture");
    let mut random = Random(17);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..50 {
        targets.push(at(1.0 + 0.5 * random.signed(), 0.8 * random.signed(), 0.0));
        starts.extend((0..5).map(|_| random.signed()));
    }
    for (backend, values, reports) in
        solve_everywhere(&reach, &targets, &starts, &Options::default())
    {
        let mut nearest = 0;
        for (index, report) in reports.iter().enumerate() {
            assert_eq!(report.outcome, Outcome::Converged, "{backend}: {index}");
            let own = &values[5 * index..][..5];
            let pose = arm.link_pose(own, 5).expect("a link");
            assert!(apart(pose, targets[index])[1] < REACHED);
            nearest += usize::from(across(arm, &goals, own, &posture) < 10.0 * SETTLED);
        }
        // Half a turn from the posture of an endless hinge there are two ways to it.
        assert!(nearest >= 48, "{backend}: {nearest} of 50");
    }
}

/// Whole turns of a hinge that turns endlessly are the same posture, and the way there is the shorter one.
#[test]
fn the_posture_of_an_endless_hinge_is_taken_the_shorter_way() {
    let arm = mechanism::<f64>(&planar(&[1.0]));
    let goals = [Goal::position(0)];
    for turns in [0.0, 1.0, -7.0] {
        let posture = [3.0 + turns * TAU];
        let mut freedoms = [Freedom::default(); 1];
        let reach = Reach::new(arm.view(), &goals, &mut freedoms).expect("a problem");
        let reach = reach.with_posture(&posture).expect("a posture");
        for (backend, values, [report]) in
            solve_everywhere(&reach, &[DualQuat::IDENTITY], &[-3.0], &Options::default())
                .into_iter()
                .map(|(backend, values, reports)| (backend, values, [reports[0]]))
        {
            assert_eq!(report.outcome, Outcome::Converged);
            assert!((values[0] + TAU - 3.0).abs() < SETTLED, "{backend}: {turns} {values:?}");
            assert!(report.iterations < 4, "{backend}: {turns} {report:?}");
        }
    }
}

/// Beyond a limit the posture is at the limit, and no number is too large for one.
#[test]
fn a_posture_beyond_the_limits_is_the_one_at_the_limits() {
    let joints = seven();
    let arm = mechanism::<f32>(&joints);
    let arm = arm.view();
    let goals = [Goal::pose(7)];
    let mut random = Random(13);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    let mut cast = || -> Vec<f32> {
        draw(&mut random, &joints).into_iter().map(|value| value as f32).collect()
    };
    for _ in 0..60 {
        targets.push(arm.link_pose(&cast(), 7).expect("a link"));
        starts.extend(cast());
    }
    let far = [9.0, f32::MAX, 9.0, f32::MIN, 9.0, 9.0, f32::MAX];
    let near = [2.8, 1.7, 2.8, -3.0, 2.8, 3.7, 2.8];
    let [far, near] = [far, near].map(|posture| {
        let mut freedoms = [Freedom::default(); 7];
        let reach = Reach::new(arm, &goals, &mut freedoms).expect("a problem");
        let reach = reach.with_posture(&posture).expect("a posture");
        solve_everywhere(&reach, &targets, &starts, &Options::default())
    });
    for ((backend, values, reports), (_, expected, _)) in far.iter().zip(&near) {
        let converged =
            reports.iter().filter(|report| report.outcome == Outcome::Converged).count();
        assert!(converged >= 59, "{backend}: {converged}");
        assert_eq!(values, expected, "{backend}");
    }
}

/// Where a slide has no end, the way to a posture may be no number: the other joints have theirs.
#[test]
fn a_posture_too_far_for_a_float_is_left_out() {
    let joints = [
        Joint::prismatic(None, DualQuat::IDENTITY, [1.0, 0.0, 0.0]),
        Joint::revolute(Some(0), DualQuat::IDENTITY, super::Z),
    ];
    let problem = problem::<f32>(&joints, [Goal::position(1)]);
    let reach = problem.view();
    let reach = reach.with_posture(&[f32::MAX, 0.5]).expect("a posture");
    let target = DualQuat::from_translation([1.0, 0.0, 0.0]);
    for (backend, values, reports) in
        solve_everywhere(&reach, &[target], &[0.0, 0.0], &Options::default())
    {
        assert_eq!(reports[0].outcome, Outcome::Converged, "{backend}");
        assert!((values[0] - 1.0).abs() < 1e-4, "{backend}: {values:?}");
        assert!((values[1] - 0.5).abs() < 1e-3, "{backend}: {values:?}");
    }
}
