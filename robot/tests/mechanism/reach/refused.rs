//! What cannot be asked, and that nothing is touched then.

use super::{at, mechanism, planar, problem, seven, solve};
use dq8::{Backend, DualQuat, ShapeError};
use dq8_robot::ik::{Freedom, Goal, Options, Outcome, Reach, ReachError, Report};
use dq8_robot::{Joint, JointKind};

#[test]
fn errors_name_what_is_wrong() {
    let arm = mechanism::<f64>(&planar(&[1.0, 1.0]));
    let ask = |goals: &[Goal<f64>], room: usize| {
        let mut freedoms = vec![Freedom::default(); room];
        Reach::new(arm.view(), goals, &mut freedoms).map(|_| ()).unwrap_err()
    };
    let good = Goal::pose(2);
    assert_eq!(ask(&[], 2), ReachError::NoGoals);
    assert_eq!(ask(&[good, Goal::pose(3)], 2), ReachError::Link { goal: 1, link: 3, links: 3 });
    assert_eq!(ask(&[good], 1), ReachError::Freedoms { freedoms: 1, rates: 2 });
    let nothing = Goal::position(2).with_linear([0.0; 3]);
    assert_eq!(ask(&[nothing], 2), ReachError::NoWeight { goal: 0 });
    let negative = good.with_linear([1.0, -2.0, 1.0]);
    assert_eq!(ask(&[negative], 2), ReachError::Weight { goal: 0, component: 4, value: -2.0 });
    let endless = good.with_angular([1.0, 1.0, f64::INFINITY]);
    let error = ask(&[good, endless], 2);
    assert_eq!(error, ReachError::Weight { goal: 1, component: 2, value: f64::INFINITY });
    assert!(error.to_string().contains("component 2 of goal 1"));
    // Searches add up the squares of what is weighed.
    for weight in [1e-7, 1e7, 1e-170, 1e160] {
        let error = ask(&[good.with_angular([1.0, weight, 1.0])], 2);
        assert_eq!(error, ReachError::Weight { goal: 0, component: 1, value: weight });
    }
}

/// A link on the base, and one that only fixed joints and such that follow nothing carry.
#[test]
fn a_goal_for_a_link_that_no_joint_moves_is_an_error() {
    let hinge = |on| Joint::revolute(on, at(1.0, 0.0, 0.0), super::Z);
    let joints = [
        hinge(None),
        Joint::fixed(None, at(0.0, 1.0, 0.0)),
        Joint::fixed(Some(1), at(0.0, 1.0, 0.0)),
        hinge(Some(2)).mimicking(0, 0.0, 0.3),
        Joint::fixed(Some(3), at(0.0, 1.0, 0.0)),
        // One that follows a joint of another branch moves.
        hinge(Some(2)).mimicking(0, 0.5, 0.3),
        Joint::fixed(Some(5), at(0.0, 1.0, 0.0)),
    ];
    let machine = mechanism::<f64>(&joints);
    let ask = |goals: &[Goal<f64>]| {
        let mut freedoms = [Freedom::default(); 1];
        Reach::new(machine.view(), goals, &mut freedoms).map(|_| ())
    };
    for link in [1, 2, 3, 4] {
        let refused = ask(&[Goal::pose(0), Goal::position(link)]).unwrap_err();
        assert_eq!(refused, ReachError::Unmoved { goal: 1, link });
        let text = refused.to_string();
        assert!(text.contains("goal 1") && text.contains(&format!("link {link}")), "{text}");
    }
    for link in [0, 5, 6] {
        assert_eq!(ask(&[Goal::pose(link)]), Ok(()));
    }
    let none = mechanism::<f32>(&[Joint::fixed(None, at(0.0, 1.0, 0.0))]);
    let goals = [Goal::pose(0)];
    let refused = Reach::new(none.view(), &goals, &mut []).unwrap_err();
    assert_eq!(refused, ReachError::Unmoved { goal: 0, link: 0 });
}

#[test]
fn limits_that_leave_nothing_are_errors() {
    let finger = Joint::prismatic(None, DualQuat::IDENTITY, super::Z).with_limits([0.0, 0.04]);
    let other = finger.with_limits([1.0, 2.0]).mimicking(0, 1.0, 0.0);
    let far = Joint::revolute(None, DualQuat::IDENTITY, super::Z).with_limits([1e30, 1e30]);
    // It stands at 2, whatever the other does.
    let stuck = Joint::prismatic(Some(0), DualQuat::IDENTITY, super::Z)
        .with_limits([-1.0, 1.0])
        .mimicking(0, 0.0, 2.0);
    for (joints, link, joint) in
        [(vec![finger, other], 1, 1), (vec![finger, far], 1, 1), (vec![finger, stuck], 1, 1)]
    {
        let machine = mechanism::<f64>(&joints);
        let mut freedoms = [Freedom::default(); 2];
        let goals = [Goal::position(link)];
        let error = Reach::new(machine.view(), &goals, &mut freedoms).unwrap_err();
        assert!(
            matches!(error, ReachError::Limits { joint: found, .. } if found == joint),
            "{error}"
        );
    }
}

#[test]
fn postures_that_do_not_fit_are_errors() {
    let problem = problem::<f64>(&planar(&[1.0, 1.0]), [Goal::pose(2)]);
    let reach = problem.view();
    assert_eq!(
        reach.with_posture(&[0.0; 3]).unwrap_err(),
        ReachError::PostureLength { length: 3, expected: 2 }
    );
    let error = reach.with_posture(&[0.0, f64::INFINITY]).unwrap_err();
    assert_eq!(error, ReachError::Posture { index: 1, value: f64::INFINITY });
}

#[test]
fn lengths_that_do_not_fit_are_errors_and_nothing_is_touched() {
    let problem = problem::<f64>(&seven(), [Goal::pose(7), Goal::position(4)]);
    let reach = problem.view();
    let options = Options::default();
    let enough = [reach.scratch_len(), reach.batch_scratch_len()];
    let target = at(0.3, 0.2, 0.5);
    for (targets, values, scratch, what) in
        [(3, 7, 0, "targets"), (2, 6, 0, "values"), (2, 8, 0, "values"), (2, 7, 1, "scratch")]
    {
        let targets = vec![target; targets];
        for batch in [false, true] {
            let mut own = vec![0.125; values];
            let mut memory = vec![0.5; enough[usize::from(batch)] - scratch];
            let mut reports = [Report::default()];
            let done = if batch {
                let job = reach.job();
                job.solve_in(&mut memory, &targets, &mut own, &mut reports, &options)
            } else {
                reach.solve(&targets, &mut own, &mut memory, &options).map(|_| ())
            };
            let Err(ShapeError::Length { what: found, .. }) = done else { panic!("{done:?}") };
            assert_eq!(found, what);
            assert!(own.iter().all(|&value| value == 0.125) && reports == [Report::default()]);
            assert!(memory.iter().all(|&number| number == 0.5));
        }
    }
}

/// A product that wraps would say that little is enough.
#[test]
fn more_numbers_than_can_be_counted_are_more_than_any_memory_holds() {
    let arm = mechanism::<f64>(&seven());
    let bound = |goals| Reach::scratch_bound(arm.view(), goals);
    for goals in [usize::MAX, usize::MAX / 6 + 1, usize::MAX / 42, 1 << (usize::BITS / 2)] {
        assert!(bound(goals) > isize::MAX as usize / size_of::<f64>(), "{goals}: {}", bound(goals));
    }
}

/// Between configurations that are solved.
#[test]
fn what_is_not_a_target_or_not_a_start_is_invalid_and_its_values_are_untouched() {
    let problem = problem::<f64>(&seven(), [Goal::pose(7)]);
    let reach = problem.view();
    let good =
        reach.mechanism().link_pose(&[0.5, -0.6, 0.7, -1.4, 0.3, 1.8, -0.4], 7).expect("a link");
    let scaled = |factor: f64| DualQuat::from_array(good.to_array().map(|number| number * factor));
    let with = |index: usize, number: f64| {
        let mut array = good.to_array();
        array[index] = number;
        DualQuat::from_array(array)
    };
    let bad = [
        with(0, f64::NAN),
        with(6, f64::NAN),
        with(5, f64::INFINITY),
        scaled(1.01),
        scaled(0.0),
        with(7, good.to_array()[7] + 0.01),
        at(1e300, 0.0, 0.0),
    ];
    let start = [0.0, 0.2, 0.0, -1.0, 0.0, 1.2, 0.0];
    for backend in Backend::available() {
        for bad_start in [None, Some(f64::NAN), Some(f64::NEG_INFINITY)] {
            let (mut targets, mut values) = (Vec::new(), Vec::new());
            for target in bad {
                targets.extend([if bad_start.is_some() { good } else { target }, good]);
                let mut own = start;
                own[3] = bad_start.unwrap_or(own[3]);
                values.extend(own);
                values.extend(start);
            }
            let before = values.clone();
            let mut reports = vec![Report::default(); targets.len()];
            let job = reach.job().backend(backend);
            job.solve(&targets, &mut values, &mut reports, &Options::default())
                .expect("lengths fit");
            for (index, report) in reports.iter().enumerate() {
                let far = targets[index].translation()[0] > 1e200 && bad_start.is_none();
                if index % 2 == 1 {
                    assert_eq!(report.outcome, Outcome::Converged, "{backend}: {index}");
                } else if !far {
                    assert_eq!(report.outcome, Outcome::Invalid, "{backend}: {index}");
                    assert!(report.angular_error.is_nan() && report.linear_error.is_nan());
                    let bits = |values: &[f64]| -> Vec<u64> {
                        values[7 * index..][..7].iter().map(|value| value.to_bits()).collect()
                    };
                    assert_eq!(bits(&values), bits(&before), "{backend}: {index}");
                } else {
                    assert_eq!(report.outcome, Outcome::OutOfReach, "{backend}: {index}");
                }
            }
        }
    }
}

#[test]
fn options_that_are_none_are_invalid_and_values_are_untouched() {
    let arm = mechanism::<f64>(&seven());
    let target = arm.view().link_pose(&[0.5, -0.6, 0.7, -1.4, 0.3, 1.8, -0.4], 7).expect("a link");
    let start = [0.0, 0.2, 0.0, -1.0, 0.0, 1.2, 9.0];
    let good = Options::default();
    let mut options = Vec::new();
    for bad in [f64::NAN, -1.0, 0.0] {
        options.push(Options { max_step: bad, ..good });
        options.push(Options { length_per_radian: Some(bad), ..good });
    }
    for bad in [f64::NAN, -1.0] {
        options.push(Options { damping: bad, ..good });
        options.push(Options { linear_tolerance: bad, ..good });
        options.push(Options { angular_tolerance: bad, ..good });
    }
    options.push(Options { length_per_radian: Some(f64::INFINITY), ..good });
    options.push(Options { damping: f64::INFINITY, ..good });
    for options in options {
        let mut values = start;
        let report = solve(arm.view(), &[Goal::pose(7)], &[target], &mut values, &options);
        assert_eq!(report.outcome, Outcome::Invalid, "{options:?}");
        assert!(report.angular_error.is_nan() && report.linear_error.is_nan());
        assert_eq!(values, start, "{options:?}");
    }
}

#[test]
fn distances_that_overflow_are_invalid_and_values_are_untouched() {
    let base = mechanism::<f64>(&[Joint::new(None, DualQuat::IDENTITY, JointKind::Floating)]);
    let start = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    for far in [[1.5e308, 1.5e308, 0.0], [0.0, -1.7e308, 1e308]] {
        let (goals, mut values) = ([Goal::position(0)], start);
        let target = DualQuat::from_translation(far);
        let report = solve(base.view(), &goals, &[target], &mut values, &Options::default());
        assert_eq!(report.outcome, Outcome::Invalid, "{far:?}: {report:?}");
        assert_eq!(values, start);
    }
}

#[test]
fn steps_may_be_as_long_as_they_like() {
    let arm = mechanism::<f64>(&seven());
    let target = arm.view().link_pose(&[0.5, -0.6, 0.7, -1.4, 0.3, 1.8, -0.4], 7).expect("a link");
    let posture = [0.0; 7];
    let goals = [Goal::pose(7)];
    for max_step in [10.0, f64::MAX, f64::INFINITY] {
        let mut freedoms = [Freedom::default(); 7];
        let reach = Reach::new(arm.view(), &goals, &mut freedoms).expect("a problem");
        let with_posture = reach.with_posture(&posture).expect("a posture");
        for reach in [reach, with_posture] {
            let mut values = [0.0, 0.2, 0.0, -1.0, 0.0, 1.2, 0.0];
            let options = Options { max_step, ..Options::default() };
            let mut scratch = vec![f64::NAN; reach.scratch_len()];
            let report =
                reach.solve(&[target], &mut values, &mut scratch, &options).expect("lengths fit");
            assert_eq!(report.outcome, Outcome::Converged, "{max_step}: {report:?}");
        }
    }
}
