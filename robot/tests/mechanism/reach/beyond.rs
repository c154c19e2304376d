//! Targets that nothing reaches: an arm that follows one points at it and goes on with it.

use super::draw;
use dq8::simd::{Lanes, Portable};
use dq8::{DualQuat, Quat, Real, Scalar};
use dq8_fixtures::random::Random;
use dq8_robot::ik::{Goal, Options, OwnedReach, Tracking};
use dq8_robot::{Dh, DhConvention, Joint, OwnedMechanism};
use std::f64::consts::{FRAC_PI_2, PI};

/// A Franka Emika Panda: rows of Craig's form, from its data sheet, and a tool.
fn panda<R: Real>() -> OwnedMechanism<R> {
    let rows = [
        (0.0, 0.333, 0.0, 0.0, [-2.8973, 2.8973]),
        (0.0, 0.0, 0.0, -FRAC_PI_2, [-1.7628, 1.7628]),
        (0.0, 0.316, 0.0, FRAC_PI_2, [-2.8973, 2.8973]),
        (0.0, 0.0, 0.0825, FRAC_PI_2, [-3.0718, -0.0698]),
        (0.0, 0.384, -0.0825, -FRAC_PI_2, [-2.8973, 2.8973]),
        (0.0, 0.0, 0.0, FRAC_PI_2, [-0.0175, 3.7525]),
        (0.0, 0.0, 0.088, FRAC_PI_2, [-2.8973, 2.8973]),
    ]
    .map(|(theta, d, a, alpha, limits): (f64, f64, f64, f64, [f64; 2])| {
        let [theta, d, a, alpha] = [theta, d, a, alpha].map(R::from_f64);
        Dh::hinge(theta, d, a, alpha).with_limits(limits.map(R::from_f64))
    });
    let tool = DualQuat::from_translation([0.0, 0.0, 0.21].map(R::from_f64));
    OwnedMechanism::from_dh(&rows, DhConvention::Modified, tool).unwrap()
}

const START: [f64; 7] = [0.1, 0.3, 0.2, -1.5, 0.1, 1.8, 0.3];

/// The longest step of a joint in a frame, the frames without motion, and the largest angle between
/// the way to the tool and the way to the target, from the second round on. The target is so far
/// ahead, and goes around.
fn followed<R>(goal: Goal<R>, ahead: f64, turn: DualQuat<f64>) -> (f64, usize, f64)
where
    R: Scalar + Lanes<Real = R, Level = Portable, Mask = bool>,
{
    let mut reach = OwnedReach::new(panda::<R>(), [goal]).unwrap();
    let mut values = START.map(<R as Real>::from_f64);
    let (mut longest, mut still, mut off) = (0.0_f64, 0, 0.0_f64);
    for k in 0..800 {
        let a = f64::from(k) * PI / 200.0;
        let target = [ahead, 0.6 * a.sin(), 0.4 + 0.6 * a.cos()];
        let pose = DualQuat::from_rotation_translation(turn.rotation(), target);
        let before = values;
        reach.track(&[pose.cast()], &mut values, &Tracking::default()).unwrap();
        if k < 400 {
            continue;
        }
        let steps = values.iter().zip(before).map(|(&new, old)| (new - old).into().abs());
        let step = steps.fold(0.0_f64, f64::max);
        longest = longest.max(step);
        still += usize::from(step == 0.0);
        // From the shoulder.
        let tool = reach.view().mechanism().link_pose(&values, 7).unwrap().translation();
        let shoulder = [0.0, 0.0, 0.333];
        let tool = [0, 1, 2].map(|i| tool[i].into() - shoulder[i]);
        let target = [0, 1, 2].map(|i| target[i] - shoulder[i]);
        let dot: f64 = tool.iter().zip(target).map(|(a, b)| a * b).sum();
        let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        off = off.max((dot / (length(tool) * length(target))).min(1.0).acos());
    }
    (longest, still, off)
}

#[test]
fn an_arm_points_at_a_target_beyond_reach_and_goes_with_it_in_every_frame() {
    for ahead in [1.3, 1.6, 1.9] {
        for (longest, still, off) in [
            followed::<f64>(Goal::position(7), ahead, DualQuat::IDENTITY),
            followed::<f32>(Goal::position(7), ahead, DualQuat::IDENTITY),
        ] {
            assert!(
                longest < 0.05 && still == 0,
                "{ahead}: {longest} rad in a frame, {still} still"
            );
            assert!(off < 3_f64.to_radians(), "{ahead}: {} degrees off", off.to_degrees());
        }
    }
}

/// A pose that cannot be held, and at half a metre one that can in a part of the round, on the way
/// into which an arm has to turn farther.
#[test]
fn an_arm_goes_with_a_pose_that_it_cannot_hold_in_every_frame() {
    for angle in [PI, 0.0, 1.5] {
        let turn = DualQuat::from_rotation(Quat::from_axis_angle([1.0, 0.0, 0.0], angle));
        for ahead in [0.5, 0.9, 1.2, 1.6] {
            for (longest, still, _) in [
                followed::<f64>(Goal::pose(7), ahead, turn),
                followed::<f32>(Goal::pose(7), ahead, turn),
            ] {
                let most = if ahead > 0.5 { 0.05 } else { 0.4 };
                assert!(longest < most && still == 0, "{ahead}: {longest} rad, {still} still");
            }
        }
    }
}

/// Also where the goal asks for a place and a rotation of which it can have one only: the error
/// that both together make.
#[test]
fn the_same_target_asked_again_never_ends_farther_away() {
    let arm = panda::<f64>();
    let joints: Vec<Joint<f64>> = super::seven();
    let mut random = Random(12);
    let mut worse = vec![];
    for (arm, tool, joints) in
        [(arm.clone(), 7, None), (super::mechanism::<f64>(&joints), 7, Some(joints))]
    {
        for goal in [Goal::position(tool), Goal::pose(tool)] {
            let mut reach = OwnedReach::new(arm.clone(), [goal]).unwrap();
            for _ in 0..100 {
                let target = random.motion(0.8);
                let mut values = match &joints {
                    Some(joints) => draw(&mut random, joints),
                    None => START.to_vec(),
                };
                let options = Options::default();
                let first = reach.solve(&[target], &mut values, &options).unwrap();
                let second = reach.solve(&[target], &mut values, &options).unwrap();
                let error = |r: dq8_robot::ik::Report<f64>| (r.angular_error, r.linear_error);
                let (a, b) = (error(first), error(second));
                if !first.is_converged()
                    && b.1 > a.1 + 1e-9
                    && (goal.angular == [0.0; 3] || b.0 > a.0)
                {
                    worse.push((a, b, first.outcome, second.outcome));
                }
            }
        }
    }
    assert!(worse.is_empty(), "{} of 400: {:?}", worse.len(), &worse[..worse.len().min(5)]);
}

/// Fifty times, after as many frames as the arm needs to come to rest: poses that it cannot hold,
/// and targets that are too far. Without the option the same arm sways.
#[test]
fn a_target_beyond_reach_that_is_asked_again_leads_a_steady_search_to_the_same_values() {
    for goal in [Goal::position(7), Goal::pose(7)] {
        let (mut random, mut count, mut sways) = (Random(13), 0, 0);
        let mut reach = OwnedReach::new(panda::<f64>(), [goal]).unwrap();
        for _ in 0..40 {
            let mut target = random.motion(0.8);
            let [x, y, z] = target.translation();
            target = DualQuat::from_rotation_translation(target.rotation(), [x, y, z + 0.9]);
            let mut moves = |steady: bool| {
                let options = Tracking { steady, ..Tracking::default() };
                let (mut values, mut most, mut error) = (START, 0.0_f64, f64::INFINITY);
                for ask in 0..80 {
                    let before = values;
                    let report = reach.track(&[target], &mut values, &options).unwrap();
                    if report.is_converged() {
                        return None;
                    }
                    if goal.angular == [0.0; 3] && steady {
                        assert!(report.linear_error <= error, "{report:?} {error}");
                        error = report.linear_error;
                    }
                    let steps = values.iter().zip(before).map(|(new, old)| (new - old).abs());
                    most = if ask < 30 { 0.0 } else { steps.fold(most, f64::max) };
                }
                Some(most)
            };
            let [Some(steady), Some(newest)] = [true, false].map(&mut moves) else { continue };
            assert_eq!(steady, 0.0, "{target}");
            (count, sways) = (count + 1, sways + usize::from(newest > 1e-3));
        }
        assert!(count > 10 && sways > 5, "{sways} of {count} sway");
    }
}
