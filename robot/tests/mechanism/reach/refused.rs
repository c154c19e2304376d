//! What cannot be asked, and that nothing is touched then.

use super::{START, THERE, Z, at, mechanism, planar, pose, problem, seven, solve, solve_with};
use dq8::{Backend, DualQuat, ShapeError};
use dq8_robot::Joint;
use dq8_robot::ik::{
    Freedom, Goal, Options, Outcome, OwnedReach, Reach, ReachError, Report, Tracking,
};

/// The error of these goals.
fn refused(joints: &[Joint<f64>], goals: &[Goal<f64>]) -> ReachError {
    OwnedReach::new(mechanism(joints), goals).map(|_| ()).unwrap_err()
}

#[test]
fn errors_name_what_is_wrong() {
    let arm = planar(&[1.0, 1.0]);
    let ask = |goals: &[Goal<f64>]| refused(&arm, goals);
    let good = Goal::pose(2);
    assert_eq!(ask(&[]), ReachError::NoGoals);
    assert_eq!(ask(&[good, Goal::pose(3)]), ReachError::Link { goal: 1, link: 3, links: 3 });
    let nothing = Goal::position(2).with_linear([0.0; 3]);
    assert_eq!(ask(&[nothing]), ReachError::NoWeight { goal: 0 });
    let error = ask(&[good, good.with_linear([1.0, -2.0, 1.0])]);
    assert_eq!(error, ReachError::Weight { goal: 1, component: 4, value: -2.0 });
    assert!(error.to_string().contains("component 4 of goal 1"));
    // Searches add up the squares of what is weighed.
    for value in [f64::INFINITY, 1e-7, 1e7, 1e-170, 1e160] {
        let error = ask(&[good.with_angular([1.0, value, 1.0])]);
        assert_eq!(error, ReachError::Weight { goal: 0, component: 1, value });
    }
    let (owned, goals) = (mechanism::<f64>(&arm), [good]);
    let error = Reach::new(owned.view(), &goals, &mut [Freedom::default()]).unwrap_err();
    assert_eq!(error, ReachError::Freedoms { freedoms: 1, rates: 2 });
    let posture = |values: &[f64]| problem(&arm, [good]).with_posture(values).unwrap_err();
    assert_eq!(posture(&[0.0; 3]), ReachError::PostureLength { length: 3, expected: 2 });
    let endless = ReachError::Posture { index: 1, value: f64::INFINITY };
    assert_eq!(posture(&[0.0, f64::INFINITY]), endless);
}

/// A link on the base, and one that only fixed joints and such that follow nothing carry.
#[test]
fn a_goal_for_a_link_that_no_joint_moves_is_an_error() {
    let hinge = |on| Joint::revolute(on, at(1.0, 0.0, 0.0), Z);
    let post = |on| Joint::fixed(on, at(0.0, 1.0, 0.0));
    let joints = [
        hinge(None),
        post(None),
        post(Some(1)),
        hinge(Some(2)).mimicking(0, 0.0, 0.3),
        post(Some(3)),
        // One that follows a joint of another branch moves.
        hinge(Some(2)).mimicking(0, 0.5, 0.3),
        post(Some(5)),
    ];
    for link in [1, 2, 3, 4] {
        let error = refused(&joints, &[Goal::pose(0), Goal::position(link)]);
        assert_eq!(error, ReachError::Unmoved { goal: 1, link });
        let text = error.to_string();
        assert!(text.contains("goal 1") && text.contains(&format!("link {link}")), "{text}");
    }
    for link in [0, 5, 6] {
        problem::<f64>(&joints, [Goal::pose(link)]);
    }
    let unmoved = ReachError::Unmoved { goal: 0, link: 0 };
    assert_eq!(refused(&[post(None)], &[Goal::pose(0)]), unmoved);
}

#[test]
fn limits_that_leave_nothing_are_errors() {
    let here = DualQuat::IDENTITY;
    let finger = Joint::prismatic(None, here, Z).with_limits([0.0, 0.04]);
    let far = Joint::revolute(None, here, Z).with_limits([1e30, 1e30]);
    {
        let other = far;
        let error = refused(&[finger, other], &[Goal::position(1)]);
        assert!(matches!(error, ReachError::Limits { joint: 1, .. }), "{error}");
    }
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
        for way in 0..3 {
            let mut own = vec![0.125; values];
            let mut memory = vec![0.5; enough[way.min(1)] - scratch];
            let (mut reports, job) = ([Report::default()], reach.job());
            let done = match way {
                0 => reach.solve(&targets, &mut own, &mut memory, &options).map(|_| ()),
                1 => job.solve_in(&mut memory, &targets, &mut own, &mut reports, &options),
                _ if what == "scratch" => continue,
                _ => {
                    #[cfg(feature = "rayon")]
                    let job = job.threads(usize::MAX);
                    job.solve(&targets, &mut own, &mut reports, &options)
                }
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
    let problem = problem(&seven(), [Goal::pose(7)]);
    let good = pose(&problem, &THERE, 7);
    let with = |index: usize, number: f64| {
        let mut array = good.to_array();
        array[index] = number;
        DualQuat::from_array(array)
    };
    let start = |number: f64| START.map(|value| if value == START[3] { number } else { value });
    let cases = [
        (with(0, f64::NAN), START),
        (with(6, f64::NAN), START),
        (with(5, f64::INFINITY), START),
        (good.scale(1.0011), START),
        (good.scale(0.9989), START),
        (good.scale(0.0), START),
        (with(7, good.to_array()[7] + 0.01), START),
        (good, start(f64::NAN)),
        (good, start(f64::NEG_INFINITY)),
        // This one is only far.
        (at(1e300, 0.0, 0.0), START),
    ];
    let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
    let targets = cases.map(|(target, _)| [target, good]).concat();
    let before = cases.map(|(_, start)| [start, START].concat()).concat();
    for backend in Backend::available() {
        let (mut values, mut reports) = (before.clone(), [Report::default(); 20]);
        let job = problem.job().backend(backend);
        job.solve(&targets, &mut values, &mut reports, &Options::default()).expect("lengths fit");
        for (index, report) in reports.iter().enumerate() {
            let of = |all: &[f64]| bits(&all[7 * index..][..7]);
            let (what, outcome) = (format!("{backend}: {index}"), report.outcome);
            match index {
                18 => assert_eq!(outcome, Outcome::OutOfReach, "{what}"),
                _ if index % 2 == 1 => assert_eq!(outcome, Outcome::Converged, "{what}"),
                _ => {
                    assert_eq!((outcome, of(&values)), (Outcome::Invalid, of(&before)), "{what}");
                    assert!(report.angular_error.is_nan() && report.linear_error.is_nan());
                }
            }
        }
    }
}

#[test]
fn options_that_are_none_and_distances_that_overflow_are_invalid_and_values_are_untouched() {
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
    let arm = problem(&seven(), [Goal::pose(7)]);
    let (target, mut start) = (pose(&arm, &THERE, 7), START);
    start[6] = 9.0;
    for options in options {
        let (values, report) = solve_with(&arm, &[target], start, &options);
        assert_eq!((report.outcome, values), (Outcome::Invalid, start), "{options:?}");
        assert!(report.angular_error.is_nan() && report.linear_error.is_nan());
    }
    for bad in [f64::NAN, -1.0, f64::INFINITY] {
        let good = Tracking::default();
        let posture = Tracking { posture_weight: bad, ..good };
        let floating = Tracking { floating_weight: bad, ..good };
        for tracking in [posture, floating, Tracking { start_weight: bad, ..good }] {
            let (mut values, mut scratch) = (start, vec![0.0; arm.view().scratch_len()]);
            let report = arm.view().track(&[target], &mut values, &mut scratch, &tracking);
            let outcome = report.expect("lengths fit").outcome;
            assert_eq!((outcome, values), (Outcome::Invalid, start), "{tracking:?}");
        }
    }
    let base = problem(&[Joint::floating(None, DualQuat::IDENTITY)], [Goal::position(0)]);
    let start = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    for far in [[1.5e308, 1.5e308, 0.0], [0.0, -1.7e308, 1e308]] {
        let (values, report) = solve(&base, DualQuat::from_translation(far), start);
        assert_eq!((report.outcome, values), (Outcome::Invalid, start), "{far:?}: {report:?}");
    }
    // Two values whose sum is none.
    let slide = |on| Joint::prismatic(on, DualQuat::IDENTITY, [1.0, 0.0, 0.0]);
    let slides = problem(&[slide(None), slide(Some(0))], [Goal::position(1)]);
    let (values, report) = solve(&slides, DualQuat::IDENTITY, [1.5e308; 2]);
    assert_eq!((report.outcome, values), (Outcome::Invalid, [1.5e308; 2]), "{report:?}");
}

#[test]
fn steps_may_be_as_long_as_they_like() {
    let arm = problem(&seven(), [Goal::pose(7)]);
    let target = pose(&arm, &THERE, 7);
    for arm in [arm.clone(), arm.with_posture([0.0; 7]).expect("a posture")] {
        for max_step in [10.0, f64::MAX, f64::INFINITY] {
            let options = Options { max_step, ..Options::default() };
            let (_, report) = solve_with(&arm, &[target], START, &options);
            assert!(report.is_converged(), "{max_step}: {report:?}");
        }
    }
}
