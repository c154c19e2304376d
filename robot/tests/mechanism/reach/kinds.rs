//! Targets that can be reached, for joints of every kind.

use super::super::tree::{tree, values};
use super::{REACHED, ROUNDING, apart, at, pose, problem, solve, solved, turned};
use dq8_fixtures::random::Random;
use dq8_robot::Joint;
use dq8_robot::ik::{Goal, Options, Outcome};

/// Planar and floating joints too, and joints that mimic: from nearby, where there is one way.
#[test]
fn random_trees_of_joints_of_every_kind_come_back_to_where_they_were() {
    let mut random = Random(11);
    let (mut converged, mut all) = (0, 0);
    for _ in 0..120 {
        let joints = tree(&mut random, 9);
        let link = 8;
        let reach = problem(&joints, [Goal::pose(link)]);
        let goal = values(&mut random, &joints);
        let target = pose(&reach, &goal, link);
        let starts: Vec<f64> = goal.iter().map(|value| value + 0.1 * random.signed()).collect();
        for (_, values, reports) in solved(&reach, &[target], &starts, &Options::default()) {
            let [turn, distance] = apart(pose(&reach, &values, link), target);
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
    let body = problem(&[Joint::floating(None, at(1.0, 2.0, 3.0))], [Goal::pose(0)]);
    let target = turned([0.6, 0.0, 0.8], 2.0, [0.3, -5.0, 2.0]);
    let (values, report) = solve(&body, target, [0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0]);
    assert!(report.is_converged(), "{report:?}");
    let [turn, distance] = apart(pose(&body, &values, 0), target);
    assert!(turn < REACHED && distance < REACHED, "{turn} {distance}");
}
