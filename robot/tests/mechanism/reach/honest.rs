//! Lanes against one configuration, and against each other.

use super::{ROUNDING, apart, draw, mechanism, seven, solve_everywhere};
use dq8::{DualQuat, Real, Scalar};
use dq8_fixtures::random::Random;
use dq8_robot::Joint;
use dq8_robot::ik::{Freedom, Goal, Options, Outcome, Reach, Report};

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

/// Backends round otherwise, and every step of a search makes of it a few times as much.
const SAME_WAY: f64 = 1e-9;

/// Rounding may send a search from a restart another way: then both must be right for themselves.
#[test]
fn every_backend_says_what_one_configuration_says() {
    let arm = mechanism::<f64>(&seven());
    let goals = [Goal::pose(7)];
    let mut freedoms = [Freedom::default(); 7];
    let reach = Reach::new(arm.view(), &goals, &mut freedoms).expect("a problem");
    let Searches { targets, starts } = searches(&reach, 203);
    let mut scratch = vec![0.0; reach.scratch_len()];
    for (backend, values, reports) in
        solve_everywhere(&reach, &targets, &starts, &Options::default())
    {
        let mut same = 0;
        for (index, (report, target)) in reports.iter().zip(&targets).enumerate() {
            let mut own = starts[7 * index..][..7].to_vec();
            let alone = reach
                .solve(&[*target], &mut own, &mut scratch, &Options::default())
                .expect("lengths fit");
            let lanes = &values[7 * index..][..7];
            same += usize::from(
                report.outcome == alone.outcome
                    && report.iterations == alone.iterations
                    && own.iter().zip(lanes).all(|(a, b)| (a - b).abs() < SAME_WAY),
            );
            for (values, report) in [(own.as_slice(), alone), (lanes, *report)] {
                let pose = arm.view().link_pose(values, 7).expect("a link");
                let [turn, distance] = apart(pose, *target);
                assert!(
                    (report.angular_error - turn).abs() < ROUNDING
                        || report.outcome == Outcome::OutOfReach
                );
                assert!((report.linear_error - distance).abs() < ROUNDING, "{report:?} {distance}");
            }
        }
        assert!(same >= 195, "{backend}: {same} of 203");
    }
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
    let arm = mechanism::<f32>(&seven());
    let goals = [Goal::pose(7)];
    let mut freedoms = [Freedom::default(); 7];
    let reach = Reach::new(arm.view(), &goals, &mut freedoms).expect("a problem");
    assert_order_does_not_matter(&reach, searches(&reach, 101));
}

/// Where other lanes are stopped by limits, all are solved once more.
#[test]
fn nor_does_it_with_a_posture() {
    let arm = mechanism::<f32>(&seven());
    let goals = [Goal::pose(7)];
    let mut freedoms = [Freedom::default(); 7];
    let reach = Reach::new(arm.view(), &goals, &mut freedoms).expect("a problem");
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
    let machine = mechanism::<f64>(&joints);
    let goals = [Goal::pose(8)];
    let mut freedoms = [Freedom::default(); 8];
    let reach = Reach::new(machine.view(), &goals, &mut freedoms).expect("a problem");
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
    let arm = mechanism::<f64>(&seven());
    let goals = [Goal::pose(7)];
    let mut freedoms = [Freedom::default(); 7];
    let reach = Reach::new(arm.view(), &goals, &mut freedoms).expect("a problem");
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
    let arm = mechanism::<f64>(&seven());
    let goals = [Goal::pose(7)];
    let mut freedoms = [Freedom::default(); 7];
    let reach = Reach::new(arm.view(), &goals, &mut freedoms).expect("a problem");
    let target = arm.view().link_pose(&[0.5, -0.6, 0.7, -1.4, 0.3, 1.8, -0.4], 7).expect("a link");
    let options = Options { angular_tolerance: FINE, linear_tolerance: FINE, ..Options::default() };
    let mut values = vec![0.0, 0.2, 0.0, -1.0, 0.0, 1.2, 0.0];
    let mut reports = [Report::default()];
    reach.job().solve(&[target], &mut values, &mut reports, &options).expect("lengths fit");
    assert_eq!(reports[0].outcome, Outcome::Converged, "{:?}", reports[0]);
    let [turn, distance] = apart(arm.view().link_pose(&values, 7).expect("a link"), target);
    assert!(turn < FINE + ROUNDING && distance < FINE + ROUNDING, "{turn} {distance}");
}
