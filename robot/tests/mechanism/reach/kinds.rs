//! Random targets that can be reached, for joints of every kind.

use super::super::tree::{tree, values};
use super::{REACHED, ROUNDING, apart, draw, mechanism, seven, solve_everywhere};
use dq8::{DualQuat, Real, Scalar};
use dq8_fixtures::random::Random;
use dq8_robot::ik::{Freedom, Goal, Options, Outcome, Reach};
use dq8_robot::{Joint, JointKind};

/// A pose of eight products in `f32`, and what is measured of it.
const IN_SINGLE: f64 = 4e-6;

/// How many of random targets from random starts are reached, and in how many iterations; what is called
/// reached must be so by the book.
fn rate<R: Scalar>(joints: &[Joint<f64>], link: usize, count: usize) -> (f64, f64) {
    let mechanism = mechanism::<R>(joints);
    let mechanism = mechanism.view();
    let mut random = Random(7);
    let cast = |values: Vec<f64>| values.into_iter().map(<R as Real>::from_f64).collect::<Vec<R>>();
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..count {
        let goal = cast(draw(&mut random, joints));
        targets.push(mechanism.link_pose(&goal, link).expect("a link"));
        starts.extend(cast(draw(&mut random, joints)));
    }
    let goals = [Goal::pose(link)];
    let mut freedoms = vec![Freedom::default(); mechanism.rates()];
    let reach = Reach::new(mechanism, &goals, &mut freedoms).expect("a problem");
    let rounding = if size_of::<R>() == 4 { IN_SINGLE } else { ROUNDING };
    let mut worst = (1.0_f64, 0.0_f64);
    for (backend, values, reports) in
        solve_everywhere(&reach, &targets, &starts, &Options::default())
    {
        let (mut reached, mut iterations) = (0.0, 0.0);
        for (index, (report, target)) in reports.iter().zip(&targets).enumerate() {
            let own = &values[index * mechanism.values()..][..mechanism.values()];
            for joint in 0..joints.len() {
                let range = mechanism.values_of(joint).expect("a joint");
                if let (Some([low, high]), Some(&value)) =
                    (mechanism.limits(joint), own[range].first())
                {
                    assert!(low <= value && value <= high, "{value} of joint {joint}");
                }
            }
            let apart = apart(mechanism.link_pose(own, link).expect("a link"), *target);
            let errors = [report.angular_error, report.linear_error].map(Into::<f64>::into);
            for (error, apart) in errors.into_iter().zip(apart) {
                assert!((error - apart).abs() < rounding, "{backend}: {error} is {apart}");
            }
            if report.outcome == Outcome::Converged {
                assert!(apart.iter().all(|&apart| apart < REACHED + rounding), "{apart:?}");
                reached += 1.0;
                iterations += f64::from(report.iterations);
            }
        }
        worst = (worst.0.min(reached / count as f64), worst.1.max(iterations / reached));
    }
    worst
}

#[test]
fn an_arm_of_seven_axes_reaches_almost_all_random_targets_from_random_starts() {
    for (name, (reached, iterations)) in
        [("f64", rate::<f64>(&seven(), 7, 500)), ("f32", rate::<f32>(&seven(), 7, 500))]
    {
        assert!(reached >= 0.994, "{name}: {reached}");
        assert!(iterations < 10.0, "{name}: {iterations}");
    }
}

/// A gantry of two slides, a thread, and a wrist of three hinges without limits.
#[test]
fn slides_threads_and_endless_hinges_reach_as_many() {
    let mut joints = vec![
        Joint::prismatic(None, DualQuat::IDENTITY, [1.0, 0.0, 0.0]).with_limits([-1.0, 1.0]),
        Joint::prismatic(Some(0), DualQuat::IDENTITY, [0.0, 1.0, 0.0]).with_limits([-1.0, 1.0]),
        Joint::new(
            Some(1),
            DualQuat::IDENTITY,
            JointKind::Screw { axis: [0.0, 0.0, -1.0], pitch: 0.05 },
        )
        .with_limits([-12.0, 12.0]),
    ];
    for (parent, axis) in
        [[0.0, 0.0, 1.0], [0.0, 0.6, 0.8], [1.0, 0.0, 0.0]].into_iter().enumerate()
    {
        joints.push(Joint::revolute(Some(parent + 2), super::at(0.0, 0.0, 0.1), axis));
    }
    let (reached, _) = rate::<f64>(&joints, 5, 300);
    assert!(reached >= 0.99, "{reached}");
}

/// Planar and floating joints too, and joints that mimic: from nearby, where there is one way.
#[test]
fn random_trees_of_joints_of_every_kind_come_back_to_where_they_were() {
    let mut random = Random(11);
    let (mut converged, mut all) = (0, 0);
    for _ in 0..120 {
        let joints = tree(&mut random, 9);
        let link = 8;
        let mechanism = mechanism::<f64>(&joints);
        let mechanism = mechanism.view();
        let goal = values(&mut random, &joints);
        let target = mechanism.link_pose(&goal, link).expect("a link");
        let starts: Vec<f64> = goal.iter().map(|value| value + 0.1 * random.signed()).collect();
        let goals = [Goal::pose(link)];
        let mut freedoms = vec![Freedom::default(); mechanism.rates()];
        let reach = Reach::new(mechanism, &goals, &mut freedoms).expect("a problem");
        for (_, values, reports) in
            solve_everywhere(&reach, &[target], &starts, &Options::default())
        {
            let pose = mechanism.link_pose(&values, link).expect("a link");
            let [turn, distance] = apart(pose, target);
            let report = reports[0];
            assert!((report.angular_error - turn).abs() < ROUNDING, "{turn} {report:?}");
            assert!((report.linear_error - distance).abs() < ROUNDING, "{distance} {report:?}");
            all += 1;
            converged += i32::from(report.outcome == Outcome::Converged);
        }
    }
    assert!(converged * 100 >= all * 95, "{converged} of {all}");
}

/// A body in space has one step to anywhere near.
#[test]
fn a_floating_joint_is_where_its_target_is() {
    let joints = [Joint::new(None, super::at(1.0, 2.0, 3.0), JointKind::Floating)];
    let body = mechanism::<f64>(&joints);
    let target = super::turned([0.6, 0.0, 0.8], 2.0, [0.3, -5.0, 2.0]);
    let mut values = [0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0];
    let report =
        super::solve(body.view(), &[Goal::pose(0)], &[target], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Converged, "{report:?}");
    let [turn, distance] = apart(body.view().link_pose(&values, 0).expect("a link"), target);
    assert!(turn < REACHED && distance < REACHED, "{turn} {distance}");
}
