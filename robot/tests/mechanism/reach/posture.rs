//! What a posture does with the freedom that goals leave.

use super::{
    REACHED, SETTLED, THERE, Z, apart, at, draw, near, planar, pose, problem, seven, solve_with,
    solved,
};
use dq8::DualQuat;
use dq8_fixtures::random::Random;
use dq8_robot::ik::{Goal, Options, OwnedReach};
use dq8_robot::{Joint, World};
use std::f64::consts::TAU;

/// How long the part of the way to the posture is that the goal allows: next to nothing where no
/// pose that reaches the target is nearer.
fn across(reach: &OwnedReach<f64>, values: &[f64], posture: &[f64]) -> f64 {
    let arm = reach.view().mechanism();
    let Goal { link, angular, linear, .. } = reach.view().goals()[0];
    let count = values.len();
    let mut columns = vec![dq8::Twist::from_array([0.0; 6]); count];
    let there = arm.link_jacobian(World, values, link, &mut columns).expect("lengths fit");
    let weights = [angular, linear].concat();
    let matrix = nalgebra::DMatrix::from_fn(6, count, |row, column| {
        // At the link instead of the origin.
        let (twist, origin) = (columns[column], there.translation());
        weights[row] * [twist.angular, twist.velocity_at(origin)].as_flattened()[row]
    });
    let inverse = matrix.clone().pseudo_inverse(1e-9).expect("an inverse");
    let wish = nalgebra::DVector::from_fn(count, |row, _| posture[row] - values[row]);
    (&wish - &inverse * (&matrix * &wish)).norm()
}

/// Seven axes have one to spare: the elbow goes toward the posture, and the tool stays.
#[test]
fn a_posture_moves_the_elbow_and_not_the_tool() {
    let posture = [-0.3, -0.6, 1.6, -1.4, -0.3, 1.8, -0.4];
    let reach = problem(&seven(), [Goal::pose(7)]).with_posture(posture).expect("a posture");
    let target = pose(&reach, &THERE, 7);
    let far = |values: &[f64]| -> f64 {
        values.iter().zip(posture).map(|(value, wish)| (value - wish).powi(2)).sum()
    };
    for (backend, values, reports) in solved(&reach, &[target], &THERE, &Options::default()) {
        assert!(reports[0].is_converged(), "{backend}");
        let [turn, distance] = apart(pose(&reach, &values, 7), target);
        assert!(turn < REACHED && distance < REACHED, "{backend}: {turn} {distance}");
        assert!(far(&values) < far(&THERE) - 0.01, "{backend}: {} {}", far(&values), far(&THERE));
        let free = across(&reach, &values, &posture);
        assert!(free < SETTLED, "{backend}: {free}");
    }
}

/// A search that has not arrived knows nothing of a posture: none costs a target, and values come
/// nearer to it.
#[test]
fn with_a_posture_as_many_targets_are_reached() {
    let (joints, mut random) = (seven(), Random(9));
    let reach = problem(&joints, [Goal::pose(7)]);
    let posture = [0.0, 0.0, 0.0, -1.5, 0.0, 1.8, 0.0];
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..150 {
        targets.push(pose(&reach, &draw(&mut random, &joints), 7));
        starts.extend(draw(&mut random, &joints));
    }
    let far = |values: &[f64]| -> f64 {
        let squares = values.iter().enumerate().map(|(i, value)| (value - posture[i % 7]).powi(2));
        squares.sum()
    };
    let plain = solved(&reach, &targets, &starts, &Options::default());
    let reach = reach.with_posture(posture).expect("a posture");
    for ((backend, with, reports), (_, without, expected)) in
        solved(&reach, &targets, &starts, &Options::default()).iter().zip(&plain)
    {
        for (index, (report, expected)) in reports.iter().zip(expected).enumerate() {
            let [found, wanted] =
                [report, expected].map(|report| (report.outcome, report.restarts));
            assert_eq!(found, wanted, "{backend}: {index}");
        }
        assert!(far(with) < 0.9 * far(without), "{} {}", far(with), far(without));
    }
}

/// Five hinges for a point in a plane leave three.
#[test]
fn a_planar_arm_goes_as_near_to_the_posture_as_its_point_allows() {
    let (posture, mut random) = ([0.3, 0.5, -0.4, 0.8, 0.6], Random(17));
    let reach = problem(&planar(&[0.5; 5]), [Goal::position(5)]);
    let reach = reach.with_posture(posture).expect("a posture");
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..50 {
        targets.push(at(1.0 + 0.5 * random.signed(), 0.8 * random.signed(), 0.0));
        starts.extend((0..5).map(|_| random.signed()));
    }
    for (backend, values, reports) in solved(&reach, &targets, &starts, &Options::default()) {
        let mut nearest = 0;
        for ((report, own), target) in reports.iter().zip(values.chunks(5)).zip(&targets) {
            assert!(report.is_converged(), "{backend}: {report:?}");
            assert!(apart(pose(&reach, own, 5), *target)[1] < REACHED);
            nearest += usize::from(across(&reach, own, &posture) < 10.0 * SETTLED);
        }
        // Half a turn from the posture of an endless hinge there are two ways to it.
        assert!(nearest >= 48, "{backend}: {nearest} of 50");
    }
}

/// The way to a posture that no values at the target have ends with the first step of less than
/// 10⁻⁴ rad.
#[test]
fn a_search_for_a_posture_ends_where_next_to_nothing_moves() {
    let reach = problem(&planar(&[0.5; 3]), [Goal::position(3)]);
    let reach = reach.with_posture([0.9, -0.8, 1.6]).expect("a posture");
    let search = |max_iterations| {
        let options = Options { max_iterations, restarts: false, ..Options::default() };
        solve_with(&reach, &[at(1.0, 0.2, 0.0)], [0.3, 0.5, -0.4], &options)
    };
    let (last, report) = search(100);
    let [one, two] = [1, 2].map(|fewer| search(report.iterations - fewer).0);
    let way = |a: [f64; 3], b: [f64; 3]| {
        a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    };
    assert!(report.is_converged() && report.iterations < 100, "{report:?}");
    assert!(way(last, one) < 1e-4 && way(one, two) > 1e-4, "{last:?} {one:?} {two:?}");
}

/// Whole turns of a hinge that turns endlessly are the same posture, and the way there is the
/// shorter one.
#[test]
fn the_posture_of_an_endless_hinge_is_taken_the_shorter_way() {
    for turns in [0.0, 1.0, -7.0] {
        let reach = problem(&planar(&[1.0]), [Goal::position(0)]);
        let reach = reach.with_posture([3.0 + turns * TAU]).expect("a posture");
        for (backend, values, reports) in
            solved(&reach, &[DualQuat::IDENTITY], &[-3.0], &Options::default())
        {
            assert!(reports[0].is_converged());
            assert!(near(&values, &[3.0 - TAU], SETTLED), "{backend}: {turns} {values:?}");
            assert!(reports[0].iterations < 4, "{backend}: {turns} {reports:?}");
        }
    }
}

/// Beyond a limit the posture is at the limit, and no number is too large for one.
#[test]
fn a_posture_beyond_the_limits_is_the_one_at_the_limits() {
    let (joints, mut random) = (seven(), Random(13));
    let arm = problem::<f32>(&joints, [Goal::pose(7)]);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    let mut cast = || -> Vec<f32> {
        draw(&mut random, &joints).into_iter().map(|value| value as f32).collect()
    };
    for _ in 0..60 {
        targets.push(pose(&arm, &cast(), 7));
        starts.extend(cast());
    }
    let far = [9.0, f32::MAX, 9.0, f32::MIN, 9.0, 9.0, f32::MAX];
    let at_limits = [2.8, 1.7, 2.8, -3.0, 2.8, 3.7, 2.8];
    let [far, expected] = [far, at_limits].map(|posture| {
        let arm = arm.clone().with_posture(posture).expect("a posture");
        solved(&arm, &targets, &starts, &Options::default())
    });
    for ((backend, values, reports), (_, expected, _)) in far.iter().zip(&expected) {
        let converged = reports.iter().filter(|report| report.is_converged()).count();
        assert!(converged >= 59, "{backend}: {converged}");
        assert_eq!(values, expected, "{backend}");
    }
}

/// Where a slide has no end, the way to a posture may be no number: the other joints have theirs.
#[test]
fn a_posture_too_far_for_a_float_is_left_out() {
    let slide = Joint::prismatic(None, DualQuat::IDENTITY, [1.0, 0.0, 0.0]);
    let joints = [slide, Joint::revolute(Some(0), DualQuat::IDENTITY, Z)];
    let reach = problem::<f32>(&joints, [Goal::position(1)]);
    let reach = reach.with_posture([f32::MAX, 0.5]).expect("a posture");
    let target = DualQuat::from_translation([1.0, 0.0, 0.0]);
    for (backend, values, reports) in solved(&reach, &[target], &[0.0, 0.0], &Options::default()) {
        assert!(reports[0].is_converged(), "{backend}");
        assert!((values[0] - 1.0).abs() < 1e-4, "{backend}: {values:?}");
        assert!((values[1] - 0.5).abs() < 1e-3, "{backend}: {values:?}");
    }
}
