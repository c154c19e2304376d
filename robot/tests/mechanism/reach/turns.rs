//! Whole turns: of all values that are the same pose, the one within the limits that is nearest to
//! the start.

use super::{REACHED, X, Z, apart, at, pose, problem, solved, turned};
use dq8::simd::{Float, Lanes, Portable};
use dq8::{DualQuat, Real, Scalar};
use dq8_fixtures::random::Random;
use dq8_robot::Joint;
use dq8_robot::ik::{Goal, Options, Outcome};
use std::f64::consts::{PI, TAU};

const OPEN: f64 = f64::INFINITY;
/// Numbers of one configuration are those of all lanes but for rounding: values of a few turns, in
/// `f32`.
const SINGLE: f64 = 2e-5;

/// What one configuration and every backend make of a start: the values, to within the tolerance of
/// `R`.
fn from<R>(joints: &[Joint<f64>], there: &[f64], start: &[f64], restarts: bool) -> Vec<Vec<f64>>
where
    R: Scalar + Float + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    let link = joints.len() - 1;
    let mut reach = problem::<R>(joints, [Goal::pose(link)]);
    let [there, start]: [Vec<R>; 2] = [there, start]
        .map(|values| values.iter().map(|&value| <R as Real>::from_f64(value)).collect());
    let target = pose(&reach, &there, link);
    let options = Options { restarts, ..Options::default() };
    let mut values = start.clone();
    let report = reach.solve(&[target], &mut values, &options).expect("lengths fit");
    let mut all = vec![(values, report)];
    // More of them than lanes, each alone in its values.
    let (targets, starts) = (vec![target; 17], start.repeat(17));
    for (_, values, reports) in solved(&reach, &targets, &starts, &options) {
        for (values, report) in values.chunks(start.len()).zip(reports) {
            all.push((values.to_vec(), report));
        }
    }
    all.into_iter()
        .map(|(values, report)| {
            assert_eq!(report.outcome, Outcome::Converged, "{report:?}");
            let [turn, distance] = apart(pose(&reach, &values, link), target);
            assert!(turn.max(distance) < REACHED + 20.0 * R::EPSILON.into(), "{values:?}");
            values.into_iter().map(Into::into).collect()
        })
        .collect()
}

/// Asserts what comes of a start, in both precisions, with and without restarts, alone and on all
/// lanes.
fn leads<const N: usize>(joints: &[Joint<f64>], there: [f64; N], start: [f64; N], to: [f64; N]) {
    for restarts in [false, true] {
        let double = from::<f64>(joints, &there, &start, restarts);
        let single = from::<f32>(joints, &there, &start, restarts);
        for (bound, all) in [(10.0 * REACHED, double), (10.0 * REACHED + SINGLE, single)] {
            for values in all {
                for (value, to) in values.iter().zip(to) {
                    assert!((value - to).abs() < bound, "{values:?} for {to:?} from {start:?}");
                }
            }
        }
    }
}

/// A hinge without limits, and one about x on it.
fn two_hinges() -> Vec<Joint<f64>> {
    vec![
        Joint::revolute(None, DualQuat::IDENTITY, Z),
        Joint::revolute(Some(0), at(0.0, 0.0, 1.0), X),
        Joint::fixed(Some(1), at(0.0, 0.0, 1.0)),
    ]
}

fn hinge(limits: [f64; 2]) -> [Joint<f64>; 2] {
    [
        Joint::revolute(None, DualQuat::IDENTITY, Z).with_limits(limits),
        Joint::fixed(Some(0), at(1.0, 0.0, 0.0)),
    ]
}

#[test]
fn an_endless_hinge_ends_where_it_is_nearest_to_the_start() {
    leads(&two_hinges(), [3.25, 0.3], [3.2, 0.3], [3.25, 0.3]);
    leads(&two_hinges(), [3.25, 0.3], [9.0, 0.3], [3.25 + TAU, 0.3]);
    leads(&two_hinges(), [-3.25, 0.3], [-9.0, 0.2], [-3.25 - TAU, 0.3]);
    leads(&two_hinges(), [1.0, 0.3], [-5.0 * TAU, 0.3], [1.0 - 5.0 * TAU, 0.3]);
}

#[test]
fn a_path_past_half_a_turn_has_no_jump() {
    for step in [0.0226, -0.0226] {
        let first = 3.0_f64.copysign(step);
        let mut last = vec![first, 0.3];
        for index in 0..18 {
            let there = [first + step * f64::from(index), 0.3];
            let all = from::<f64>(&two_hinges(), &there, &last, false);
            for values in &all {
                assert!((values[0] - last[0]).abs() < 0.03, "{last:?} to {values:?}");
            }
            last.clone_from(&all[0]);
        }
    }
}

/// The largest that is no farther from the start than any other within the limits.
#[test]
fn limits_of_more_or_less_than_a_turn_are_used_to_their_ends() {
    // (limits, pose, start, answer)
    for (limits, there, start, to) in [
        ([-4.0, 4.0], 3.8, 3.5, 3.8),
        ([-4.0, 4.0], 3.8, -2.0, 3.8 - TAU),
        // Beyond the end, and a turn less.
        ([-4.0, 4.0], 3.9 + 0.4, 3.9, 4.3 - TAU),
        ([0.0, 30.0], 1.0, 29.0, 1.0 + 4.0 * TAU),
        // Starts beyond the limits.
        ([0.0, 30.0], 1.0, 40.0, 1.0 + 4.0 * TAU),
        ([0.0, 30.0], 5.5, 31.0, 5.5 + 3.0 * TAU),
        ([0.0, 30.0], 5.5, -3.0, 5.5),
        ([-TAU, TAU], 3.25, 3.2, 3.25),
        ([-TAU, TAU], -3.25, -3.2, -3.25),
        ([-TAU, TAU], 0.1, 6.2, 0.1),
        // One end, near and far.
        ([-3.0, OPEN], 3.25, 3.2, 3.25),
        ([-3.0, OPEN], -2.9, 20.0, 4.0 * TAU - 2.9),
        ([-3.0, OPEN], -3.1, -3.0, TAU - 3.1),
        ([-OPEN, -20.0], 1.0, -19.0, 1.0 - 4.0 * TAU),
        ([-OPEN, -20.0], 0.0, -40.0, -6.0 * TAU),
        // Farther from zero than `f32` is fine enough, but nowhere else.
        ([-OPEN, -100.0], 0.0, -101.0, -16.0 * TAU),
        ([100.0, OPEN], 0.0, 101.0, 16.0 * TAU),
        // A hundred turns are as many limits as none.
        ([0.0, 100.0 * TAU], 1.0, 45.0, 1.0 + 7.0 * TAU),
        // Less than a turn between the limits: the value is a turn away, or the way leads across
        // the gap.
        ([0.0, 6.0], 0.8, 7.0, 0.8),
        ([0.0, 6.0], 5.0, -0.5, 5.0),
        ([6.0, 9.0], 0.5, 0.3, 0.5 + TAU),
        ([-3.1, 3.1], 3.2, 3.0, 3.2 - TAU),
        ([-3.1, 3.1], 3.0, 9.0, 3.0),
        ([0.0, 6.0], 6.4, 5.9, 6.4 - TAU),
    ] {
        leads(&hinge(limits), [there], [start], [to]);
    }
}

/// Its turn has no limits; its slides have nothing to do with turns.
#[test]
fn the_turn_of_a_planar_joint_is_endless_too() {
    let plate = Joint::planar(None, DualQuat::IDENTITY, Z);
    let joints = [plate, Joint::fixed(Some(0), at(1.0, 0.0, 0.0))];
    leads(&joints, [0.2, -7.0, 3.25], [0.1, -6.9, 3.2], [0.2, -7.0, 3.25]);
    leads(&joints, [20.0, 3.0, 0.2], [0.5, -9.0, 0.1], [20.0, 3.0, 0.2]);
    leads(&joints, [8.0, -7.0, 0.2], [7.5, -7.0, 13.0], [8.0, -7.0, 0.2 + 2.0 * TAU]);
}

/// A turn along a thread is another pose, and so is a turn of what something follows by half as
/// much.
#[test]
fn turns_that_are_another_pose_stay() {
    let joints = [Joint::screw(None, DualQuat::IDENTITY, Z, 0.05)];
    leads(&joints, [9.0], [8.0], [9.0]);
    let half = [
        Joint::revolute(None, DualQuat::IDENTITY, Z),
        Joint::revolute(Some(0), at(1.0, 0.0, 0.0), Z).mimicking(0, 0.5, 0.0),
    ];
    leads(&half, [9.0], [8.0], [9.0]);
    // One that turns twice, backward, or a thousand times as often is where it was.
    for times in [2.0, -1.0, -3.0] {
        let whole = [
            Joint::revolute(None, DualQuat::IDENTITY, Z),
            Joint::revolute(Some(0), at(1.0, 0.0, 0.0), X).mimicking(0, times, 0.1),
        ];
        leads(&whole, [3.25], [3.2], [3.25]);
        leads(&whole, [0.7], [20.0], [0.7 + 3.0 * TAU]);
    }
}

/// Both signs of a quaternion are the same rotation.
#[test]
fn the_rotation_of_a_floating_joint_has_the_sign_of_the_start() {
    let joints = [Joint::floating(None, DualQuat::IDENTITY)];
    let pose = |angle: f64| {
        let [x, y, z, w] = turned(Z, angle, [0.0; 3]).rotation().to_array();
        [x, y, z, w, 0.1, 0.2, 0.3]
    };
    for sign in [1.0, -1.0] {
        let signed = |angle: f64| {
            let [x, y, z, w, at @ ..] = pose(angle);
            let [x, y, z, w] = [x, y, z, w].map(|number| number * sign);
            [x, y, z, w, at[0], at[1], at[2]]
        };
        for (there, start) in [(3.25, 3.0), (0.4, 0.1), (PI + 1.0, PI - 1.0)] {
            leads(&joints, pose(there), signed(start), signed(there));
        }
    }
}

/// Arms that begin again elsewhere: no other whole turn is nearer to the start.
#[test]
fn no_whole_turn_nearer_to_the_start_is_within_the_limits_after_restarts() {
    let mut joints = super::seven();
    let low = [-OPEN, -4.0, 0.0, -TAU, -30.0, -3.1, -OPEN];
    let high = [OPEN, 4.0, OPEN, TAU, 60.0, 3.1, 2.0];
    let limits: [_; 7] = core::array::from_fn(|i| [low[i], high[i]]);
    for (joint, limits) in joints.iter_mut().zip(limits) {
        joint.limits = Some(limits);
    }
    let problem = problem::<f64>(&joints, [Goal::pose(7)]);
    let mut random = Random(71);
    let (mut targets, mut starts) = (Vec::new(), Vec::new());
    for _ in 0..200 {
        let there: Vec<f64> = (0..7).map(|_| random.between(-3.0, 3.0)).collect();
        targets.push(pose(&problem, &there, 7));
        starts.extend((0..7).map(|_| random.between(-40.0, 40.0)));
    }
    for (backend, values, reports) in solved(&problem, &targets, &starts, &Options::default()) {
        let converged = reports.iter().filter(|report| report.is_converged()).count();
        assert!(converged >= 198, "{backend}: {converged}");
        assert!(reports.iter().any(|report| report.restarts > 0), "{backend}");
        for (index, (&value, &start)) in values.iter().zip(&starts).enumerate() {
            let [low, high] = limits[index % 7];
            assert!(low <= value && value <= high, "{backend}: {value}");
            for other in [value - TAU, value + TAU] {
                let is_within = low <= other && other <= high;
                let is_nearer = (other - start).abs() < (value - start).abs() - 1e-12;
                assert!(!(is_within && is_nearer), "{backend}: {other} for {value} from {start}");
            }
        }
    }
}
