//! What a report says where there is no solution, or not yet.

use super::{
    LAST_BITS, REACHED, ROUNDING, apart, at, draw, mechanism, planar, problem, seven, solve, turned,
};
use dq8::{DualQuat, Quat};
use dq8_fixtures::random::Random;
use dq8_robot::Joint;
use dq8_robot::ik::{Freedom, Goal, Options, Outcome, Reach};

#[test]
fn beyond_the_length_of_the_arm_is_out_of_reach_and_the_arm_points_there() {
    let arm = mechanism::<f64>(&planar(&[1.0, 1.0]));
    let mut values = [0.4, 0.9];
    let goals = [Goal::position(2)];
    let report = solve(arm.view(), &goals, &[at(0.0, 5.0, 0.0)], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::OutOfReach);
    assert!((report.linear_error - 3.0).abs() < ROUNDING, "{report:?}");
    let [x, y, _] = arm.view().link_pose(&values, 2).expect("a link").translation();
    assert!(x.abs() < 0.1 && y > 1.99, "{x} {y}");
}

#[test]
fn the_bound_of_the_reach_is_the_sum_of_the_offsets() {
    let joints = seven();
    let problem = problem::<f64>(&joints, [Goal::pose(7)]);
    let reach = problem.view();
    let (centre, length) = reach.reach_bound(0).expect("a bound");
    assert!(centre.iter().zip([0.0, 0.0, 0.34]).all(|(a, b)| (a - b).abs() < LAST_BITS));
    let offsets = 0.32 + 0.08 + 0.08_f64.hypot(0.39) + 0.09 + 0.11;
    assert!((length - offsets).abs() < LAST_BITS, "{length}");
    assert_eq!(reach.reach_bound(1), None);
}

/// Two links of lengths 1 and 0.4 leave a hole about the base.
#[test]
fn within_the_length_of_the_arm_what_no_way_leads_to_is_stalled() {
    let arm = mechanism::<f64>(&planar(&[1.0, 0.4]));
    for restarts in [false, true] {
        let mut values = [0.3, 0.8];
        let options = Options { restarts, ..Options::default() };
        let report =
            solve(arm.view(), &[Goal::position(2)], &[at(0.2, 0.0, 0.0)], &mut values, &options);
        assert_eq!(report.outcome, Outcome::Stalled, "{report:?}");
        let near = if restarts { 0.02 } else { 1e-3 };
        assert!((report.linear_error - 0.4).abs() < near, "{report:?}");
    }
}

#[test]
fn what_limits_forbid_is_at_limits() {
    let mut joints = planar(&[1.0, 1.0]);
    joints[0] = joints[0].with_limits([-0.5, 0.5]);
    joints[1] = joints[1].with_limits([0.0, 1.0]);
    let arm = mechanism::<f64>(&joints);
    let mut values = [0.0, 0.5];
    let goals = [Goal::position(2)];
    let report = solve(arm.view(), &goals, &[at(-1.0, 1.0, 0.0)], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::AtLimits);
    assert!(
        (values[0] - 0.5).abs() < LAST_BITS && (values[1] - 1.0).abs() < LAST_BITS,
        "{values:?}"
    );
}

#[test]
fn too_few_iterations_are_unfinished_and_more_of_them_converge() {
    let arm = mechanism::<f64>(&seven());
    let goal = [0.5, -0.6, 0.7, -1.4, 0.3, 1.8, -0.4];
    let target = arm.view().link_pose(&goal, 7).expect("a link");
    let start = [0.0, 0.2, 0.0, -1.0, 0.0, 1.2, 0.0];
    let mut values = start;
    let options = Options { max_iterations: 2, ..Options::default() };
    let report = solve(arm.view(), &[Goal::pose(7)], &[target], &mut values, &options);
    assert_eq!((report.outcome, report.iterations), (Outcome::Unfinished, 2));
    let report = solve(arm.view(), &[Goal::pose(7)], &[target], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Converged);
}

#[test]
fn a_start_at_the_target_takes_no_iteration_and_keeps_its_bits() {
    let arm = mechanism::<f64>(&seven());
    let goal = [0.5, -0.6, 0.7, -1.4, 0.3, 1.8, -0.4];
    let target = arm.view().link_pose(&goal, 7).expect("a link");
    let mut values = goal;
    let report = solve(arm.view(), &[Goal::pose(7)], &[target], &mut values, &Options::default());
    assert_eq!((report.outcome, report.iterations, values), (Outcome::Converged, 0, goal));
}

#[test]
fn a_target_that_moves_is_followed_in_two_iterations_without_restarts() {
    let arm = mechanism::<f64>(&seven());
    let mut values = [0.5, -0.6, 0.7, -1.4, 0.3, 1.8, -0.4];
    let options = Options { restarts: false, ..Options::default() };
    let home = arm.view().link_pose(&values, 7).expect("a link");
    for step in 1..=40 {
        let angle = 0.01 * f64::from(step);
        let target = turned([0.0, 0.0, 1.0], angle, [0.0; 3]) * home;
        let before = values;
        let report = solve(arm.view(), &[Goal::pose(7)], &[target], &mut values, &options);
        assert_eq!(report.outcome, Outcome::Converged);
        assert!(report.iterations <= 2 && report.restarts == 0, "{report:?}");
        for (value, before) in values.iter().zip(before) {
            assert!((value - before).abs() < 0.1, "{value} {before}");
        }
    }
}

#[test]
fn targets_a_little_off_unit_are_those_that_are_unit() {
    let arm = mechanism::<f64>(&seven());
    let goal = [0.5, -0.6, 0.7, -1.4, 0.3, 1.8, -0.4];
    let unit = arm.view().link_pose(&goal, 7).expect("a link");
    let off = DualQuat::from_array(unit.to_array().map(|number| number * (1.0 + 5e-4)));
    let start = [0.0, 0.2, 0.0, -1.0, 0.0, 1.2, 0.0];
    for target in [unit, off] {
        let mut values = start;
        let report =
            solve(arm.view(), &[Goal::pose(7)], &[target], &mut values, &Options::default());
        assert_eq!(report.outcome, Outcome::Converged);
        let [turn, distance] = apart(arm.view().link_pose(&values, 7).expect("a link"), unit);
        assert!(turn < REACHED && distance < REACHED, "{turn} {distance}");
    }
}

#[test]
fn half_a_turn_away_there_is_a_way() {
    let arm = mechanism::<f64>(&seven());
    let goal = [0.5, -0.6, 0.7, -1.4, 0.3, 1.8, -0.4];
    let pose = arm.view().link_pose(&goal, 7).expect("a link");
    let target =
        pose * DualQuat::from_rotation(Quat::from_axis_angle(super::Z, core::f64::consts::PI));
    let mut values = goal;
    let report = solve(arm.view(), &[Goal::pose(7)], &[target], &mut values, &Options::default());
    assert_eq!(report.outcome, Outcome::Converged, "{report:?}");
}

/// Three hinges at one point reach nothing but that point, which is rounded as far from the base as it lies.
#[test]
fn a_tool_that_cannot_move_away_reaches_where_it_is() {
    let place =
        |on: Option<usize>| if on.is_none() { at(60.0, 0.0, 80.0) } else { at(0.0, 0.0, 0.0) };
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let joints: Vec<_> = axes
        .into_iter()
        .enumerate()
        .map(|(i, axis)| Joint::revolute(i.checked_sub(1), place(i.checked_sub(1)), axis))
        .collect();
    let wrist = mechanism::<f32>(&joints);
    let (goals, mut freedoms) = ([Goal::pose(2)], [Freedom::default(); 3]);
    let reach = Reach::new(wrist.view(), &goals, &mut freedoms).expect("a problem");
    let mut scratch = vec![0.0; reach.scratch_len()];
    // Of the bound alone depends what is out of reach.
    let tight = Options::<f32> { linear_tolerance: 0.0, ..Options::default() };
    for step in 0..200 {
        let mut values = [0.01, 0.02, 0.03].map(|rate| rate * step as f32);
        let target = wrist.view().link_pose(&values, 2).expect("a link");
        let report = reach.solve(&[target], &mut values, &mut scratch, &tight).expect("they fit");
        assert_ne!(report.outcome, Outcome::OutOfReach, "{step}");
        assert!(report.linear_error < 1e-4, "{step}: {report:?}");
    }
}

/// The code of restarts is all that it leaves out.
#[test]
fn following_is_solving_without_restarts() {
    let problem = problem::<f64>(&seven(), [Goal::pose(7)]);
    let reach = problem.view();
    let (mut random, mut converged) = (Random(72), 0);
    let mut scratch = vec![f64::NAN; reach.scratch_len()];
    for _ in 0..100 {
        let [there, start] = [(); 2].map(|()| draw(&mut random, &seven()));
        let target = reach.mechanism().link_pose(&there, 7).expect("a link");
        let once = Options { restarts: false, ..Options::default() };
        let mut solved = start.clone();
        let wanted = reach.solve(&[target], &mut solved, &mut scratch, &once).expect("they fit");
        for restarts in [false, true] {
            let (options, mut values) = (Options { restarts, ..once }, start.clone());
            let found = reach.follow(&[target], &mut values, &mut scratch, &options);
            assert_eq!((found, &values), (Ok(wanted), &solved));
        }
        converged += usize::from(wanted.outcome == Outcome::Converged);
    }
    assert!((30..100).contains(&converged), "{converged}");
}
