//! Targets that can be reached, for joints of every kind.

use super::super::tree::{tree, values};
use super::{REACHED, ROUNDING, apart, mechanism, problem, solve_everywhere};
use dq8_fixtures::random::Random;
use dq8_robot::ik::{Goal, Options, Outcome};
use dq8_robot::{Joint, JointKind};

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
        let reach = problem(&joints, [Goal::pose(link)]);
        for (_, values, reports) in
            solve_everywhere(&reach.view(), &[target], &starts, &Options::default())
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
