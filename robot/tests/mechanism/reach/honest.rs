//! Lanes against each other; `arms/lanes.rs` holds them to one configuration.

use super::{ROUNDING, apart, draw, problem, seven, solve_everywhere};
use dq8::{DualQuat, Real, Scalar};
use dq8_fixtures::random::Random;
use dq8_robot::Joint;
use dq8_robot::ik::{Goal, Options, Outcome, Reach, Report};

struct Searches<R> {
    targets: Vec<DualQuat<R>>,
    starts: Vec<R>,
}

/// Some of the targets are out of reach.
fn searches<R: Real>(reach: &Reach<'_, R>, count: usize) -> Searches<R> {
    let joints = seven();
    let mut random = Random(21);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for index in 0..count {
        let goal: Vec<R> = draw(&mut random, &joints).into_iter().map(R::from_f64).collect();
        let mut target = reach.mechanism().link_pose(&goal, 7).expect("a link");
        if index % 9 == 4 {
            target = DualQuat::from_translation([R::from(0.4), R::ZERO, R::ZERO]) * target;
        }
        targets.push(target);
        starts.extend(draw(&mut random, &joints).into_iter().map(R::from_f64));
    }
    Searches { targets, starts }
}

/// Solves in this order and in the other: to the bit the same.
fn assert_order_does_not_matter<R: Scalar>(
    reach: &Reach<'_, R>,
    Searches { mut targets, mut starts }: Searches<R>,
) {
    let count = starts.len() / targets.len();
    let there = solve_everywhere(reach, &targets, &starts, &Options::default());
    targets.reverse();
    starts = starts.rchunks(count).flatten().copied().collect();
    let back = solve_everywhere(reach, &targets, &starts, &Options::default());
    for ((backend, values, reports), (_, reversed, last)) in there.iter().zip(&back) {
        for (own, other) in values.chunks(count).zip(reversed.rchunks(count)) {
            assert_eq!(own, other, "{backend}");
        }
        for (own, other) in reports.iter().zip(last.iter().rev()) {
            assert_eq!(own, other, "{backend}");
        }
    }
}

#[test]
fn a_result_does_not_depend_on_other_configurations() {
    let problem = problem::<f32>(&seven(), [Goal::pose(7)]);
    let reach = problem.view();
    assert_order_does_not_matter(&reach, searches(&reach, 101));
}

/// Where other lanes are stopped by limits, all are solved once more.
#[test]
fn nor_does_it_with_a_posture() {
    let problem = problem::<f32>(&seven(), [Goal::pose(7)]);
    let reach = problem.view();
    let posture = [0.1, 0.3, -0.2, -1.5, 0.4, 1.8, 0.3];
    let reach = reach.with_posture(&posture).expect("a posture");
    assert_order_does_not_matter(&reach, searches(&reach, 101));
}

/// On a slide without end lengths weigh by how far a target is, in each lane otherwise.
#[test]
fn nor_does_it_where_targets_are_near_and_far() {
    let mut joints = vec![Joint::prismatic(None, DualQuat::IDENTITY, [0.0, 1.0, 0.0])];
    for mut joint in seven() {
        joint.parent = Some(joint.parent.map_or(0, |parent| parent + 1));
        joints.push(joint);
    }
    let problem = problem::<f64>(&joints, [Goal::pose(8)]);
    let reach = problem.view();
    let mut random = Random(33);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for index in 0..41 {
        let mut values = draw(&mut random, &joints);
        values[0] *= f64::from(1 << (index % 8));
        let aside = if index % 2 == 0 { 0.0 } else { 1.5 };
        let aside = DualQuat::from_translation([aside, 0.0, 0.0]);
        targets.push(aside * reach.mechanism().link_pose(&values, 8).expect("a link"));
        starts.extend(draw(&mut random, &joints));
    }
    assert_order_does_not_matter(&reach, Searches { targets, starts });
}

#[test]
fn any_number_of_configurations_is_solved() {
    let problem = problem::<f64>(&seven(), [Goal::pose(7)]);
    let reach = problem.view();
    for count in [0, 1, 2, 3, 9, 17] {
        let Searches { targets, starts } = searches(&reach, count);
        for (backend, values, reports) in
            solve_everywhere(&reach, &targets, &starts, &Options::default())
        {
            assert_eq!((values.len(), reports.len()), (7 * count, count));
            for (index, report) in reports.iter().enumerate() {
                assert_ne!(report.outcome, Outcome::Invalid, "{backend}: {index}");
            }
        }
    }
}

/// A tolerance that `f32` could not meet.
const FINE: f64 = 1e-12;

#[test]
fn tighter_tolerances_are_met_in_double_precision() {
    let problem = problem::<f64>(&seven(), [Goal::pose(7)]);
    let reach = problem.view();
    let target =
        reach.mechanism().link_pose(&[0.5, -0.6, 0.7, -1.4, 0.3, 1.8, -0.4], 7).expect("a link");
    let options = Options { angular_tolerance: FINE, linear_tolerance: FINE, ..Options::default() };
    let mut values = vec![0.0, 0.2, 0.0, -1.0, 0.0, 1.2, 0.0];
    let mut reports = [Report::default()];
    reach.job().solve(&[target], &mut values, &mut reports, &options).expect("lengths fit");
    assert_eq!(reports[0].outcome, Outcome::Converged, "{:?}", reports[0]);
    let [turn, distance] = apart(reach.mechanism().link_pose(&values, 7).expect("a link"), target);
    assert!(turn < FINE + ROUNDING && distance < FINE + ROUNDING, "{turn} {distance}");
}
