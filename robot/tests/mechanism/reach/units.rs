//! The unit of length is the caller's.

use super::{Solved, at, draw, planar, pose, problem, seven, solved, turned};
use dq8::DualQuat;
use dq8_fixtures::random::Random;
use dq8_robot::ik::{Goal, Options};
use dq8_robot::{Joint, JointKind};

/// A mast on a rail with a thread, an arm that slides out, and a hand.
fn crane() -> Vec<Joint<f64>> {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let turn = [-2.5, 2.5];
    let slide = |on, at, axis| Joint::prismatic(on, at, axis).with_limits([-0.5, 0.75]);
    let hinge = |on, at, axis| Joint::revolute(Some(on), at, axis).with_limits(turn);
    let thread = turned(y, -0.4, [0.0, 0.3, 0.2]);
    vec![
        slide(None, at(0.1, 0.0, 0.3), x),
        hinge(0, turned(x, 0.7, [0.2, 0.1, 0.0]), z),
        Joint::screw(Some(1), thread, z, 0.25).with_limits(turn),
        hinge(2, at(0.4, 0.0, 0.1), y),
        slide(Some(3), turned([0.0, 0.6, 0.8], 1.1, [0.3, 0.0, 0.1]), [0.0, 0.6, 0.8]),
        hinge(4, at(0.1, 0.2, 0.3), [0.8, 0.6, 0.0]),
    ]
}

/// The same, sliding as far as it likes.
fn endless() -> Vec<Joint<f64>> {
    let slide = |joint| if is_slide(&joint) { Joint { limits: None, ..joint } } else { joint };
    crane().into_iter().map(slide).collect()
}

/// A motion with its lengths in a unit that is 1/`scale` as long.
fn motion(pose: DualQuat<f64>, scale: f64) -> DualQuat<f64> {
    let [a, b, c, d, e, f, g, h] = pose.to_array();
    DualQuat::from_array([a, b, c, d, e * scale, f * scale, g * scale, h * scale])
}

fn is_slide(joint: &Joint<f64>) -> bool {
    matches!(joint.kind, JointKind::Prismatic { .. })
}

/// The same joints in that unit.
fn rescaled(joints: &[Joint<f64>], scale: f64) -> Vec<Joint<f64>> {
    let joint = |joint: &Joint<f64>| {
        let mut joint = *joint;
        joint.placement = motion(joint.placement, scale);
        if let JointKind::Screw { pitch, .. } = &mut joint.kind {
            *pitch *= scale;
        }
        if is_slide(&joint) {
            joint.limits = joint.limits.map(|limits| limits.map(|end| end * scale));
        }
        joint
    };
    joints.iter().map(joint).collect()
}

/// What is the same number in another unit is the same for a factor of two to the last bit: a
/// search takes the same steps to the same values, or something in it is measured against a length
/// of its own.
#[test]
fn a_search_takes_the_same_steps_whatever_the_unit_of_length_is() {
    let scenes: [(Vec<Joint<f64>>, Option<f64>); 5] = [
        (seven(), None),
        (planar(&[0.5, 0.4, 0.3]), None),
        (crane(), None),
        (crane(), Some(0.125)),
        (endless(), None),
    ];
    for (joints, length_per_radian) in scenes {
        let mut random = Random(5);
        let link = joints.len() - 1;
        let (own, count) = (problem(&joints, [Goal::pose(link)]), 6);
        let starts: Vec<_> = (0..count).flat_map(|_| draw(&mut random, &joints)).collect();
        let targets: Vec<_> =
            (0..count).map(|_| pose(&own, &draw(&mut random, &joints), link)).collect();
        let postures = [None, Some(draw(&mut random, &joints))];
        for posture in postures {
            let search = |scale: f64| {
                let in_unit = |values: &[f64], scale: f64| -> Vec<f64> {
                    let joints = joints.iter().filter(|joint| joint.kind.values() > 0).cycle();
                    let unit = |joint: &Joint<f64>| if is_slide(joint) { scale } else { 1.0 };
                    values.iter().zip(joints).map(|(value, joint)| value * unit(joint)).collect()
                };
                let mut reach = problem(&rescaled(&joints, scale), [Goal::pose(link)]);
                if let Some(posture) = &posture {
                    reach = reach.with_posture(in_unit(posture, scale)).expect("a posture");
                }
                let targets: Vec<_> = targets.iter().map(|&pose| motion(pose, scale)).collect();
                let options = Options {
                    linear_tolerance: 1e-5 * scale,
                    length_per_radian: length_per_radian.map(|length| length * scale),
                    ..Options::default()
                };
                let solved = solved(&reach, &targets, &in_unit(&starts, scale), &options);
                let in_metres = |(backend, values, mut reports): Solved<f64>| {
                    reports.iter_mut().for_each(|report| report.linear_error /= scale);
                    (backend, in_unit(&values, 1.0 / scale), reports)
                };
                solved.into_iter().map(in_metres).collect::<Vec<_>>()
            };
            let metres = search(1.0);
            for scale in [1024.0, 1.0 / 256.0] {
                assert_eq!(search(scale), metres, "{} joints, {scale}", joints.len());
            }
        }
    }
}

/// Where something slides without end, a radian weighs as much as an eighth of the way that it has
/// to go: how far an arm of length 1 turns to be half a metre to the side, without being asked to
/// turn, tells which length that is.
#[test]
fn what_slides_without_end_weighs_lengths_by_the_way_that_it_has_to_go() {
    let (here, aside) = (DualQuat::IDENTITY, 0.5);
    let options = Options { restarts: false, ..Options::default() };
    let square = (40.0_f64 / 8.0).powi(2);
    // θ² + (sin θ − d)²/L² of an arm, and of two goals of a body 2θ² + ((d − sin θ)² +
    // (1 − cos θ)²)/(2L²), have no slope.
    let check =
        |joints: &[Joint<f64>], goals: &[Goal<f64>], start: &[f64], turn: &dyn Fn(_) -> f64| {
            let reach = problem(joints, goals.to_vec());
            let targets = match goals {
                [_] => vec![at(0.0, aside, 0.0)],
                _ => vec![here, at(1.0, aside, 0.0)],
            };
            for (backend, values, _) in solved(&reach, &targets, start, &options) {
                let (sin, cos) = f64::sin_cos(turn(values));
                let angle = sin.atan2(cos);
                let slope = match goals {
                    [_] => angle + (sin - aside) * cos / square,
                    _ => angle + ((sin - aside) * cos + (1.0 - cos) * sin) / (4.0 * square),
                };
                assert!(slope.abs() < 1e-3, "{backend}: {angle} {slope}");
            }
        };
    let arm = |base| {
        let hinge = Joint::revolute(Some(0), here, [0.0, 0.0, 1.0]);
        [base, hinge, Joint::fixed(Some(1), at(1.0, 0.0, 0.0))]
    };
    let goal = [Goal::pose(2)];
    check(&arm(Joint::prismatic(None, here, [1.0, 0.0, 0.0])), &goal, &[40.0, 0.3], &|v: Vec<
        f64,
    >| v[1]);
    let plate = arm(Joint::planar(None, here, [0.0, 1.0, 0.0]));
    check(&plate, &goal, &[40.0, 0.0, 0.0, 0.3], &|v: Vec<f64>| v[3]);
    check(&plate, &goal, &[0.0, 40.0, 0.0, 0.3], &|v: Vec<f64>| v[3]);
    let body = [Joint::floating(None, here), Joint::fixed(Some(0), at(1.0, 0.0, 0.0))];
    let start = [0.0, 0.0, 0.0, 1.0, 0.0, 40.0, 0.0];
    check(&body, &[Goal::pose(0), Goal::pose(1)], &start, &|v: Vec<f64>| 2.0 * v[2].atan2(v[3]));
}
