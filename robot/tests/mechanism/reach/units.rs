//! The unit of length is the caller's.

use super::{at, draw, mechanism, planar, seven, solve_everywhere, turned};
use dq8::DualQuat;
use dq8_fixtures::random::Random;
use dq8_robot::ik::{Freedom, Goal, Options, Reach};
use dq8_robot::{Joint, JointKind, OwnedMechanism};

/// A mast on a rail with a thread, an arm that slides out, and a hand.
fn crane() -> Vec<Joint<f64>> {
    let placements = [
        at(0.1, 0.0, 0.3),
        turned([1.0, 0.0, 0.0], 0.7, [0.2, 0.1, 0.0]),
        turned([0.0, 1.0, 0.0], -0.4, [0.0, 0.3, 0.2]),
        at(0.4, 0.0, 0.1),
        turned([0.0, 0.6, 0.8], 1.1, [0.3, 0.0, 0.1]),
        at(0.1, 0.2, 0.3),
    ];
    let z = [0.0, 0.0, 1.0];
    let kinds = [
        JointKind::Prismatic { axis: [1.0, 0.0, 0.0] },
        JointKind::Revolute { axis: z },
        JointKind::Screw { axis: z, pitch: 0.25 },
        JointKind::Revolute { axis: [0.0, 1.0, 0.0] },
        JointKind::Prismatic { axis: [0.0, 0.6, 0.8] },
        JointKind::Revolute { axis: [0.8, 0.6, 0.0] },
    ];
    let joint = |(index, (kind, placement)): (usize, (JointKind<f64>, DualQuat<f64>))| {
        let joint = Joint::new(index.checked_sub(1), placement, kind);
        joint.with_limits(if matches!(kind, JointKind::Prismatic { .. }) {
            [-0.5, 0.75]
        } else {
            [-2.5, 2.5]
        })
    };
    kinds.into_iter().zip(placements).enumerate().map(joint).collect()
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
fn rescaled(joints: &[Joint<f64>], scale: f64) -> OwnedMechanism<f64> {
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
    mechanism(&joints.iter().map(joint).collect::<Vec<_>>())
}

/// What is the same number in another unit is the same for a factor of two to the last bit: a search takes the same steps
/// to the same values, or something in it is measured against a length of its own.
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
        let goals = [Goal::pose(link)];
        let own = mechanism::<f64>(&joints);
        let count = 6;
        let starts: Vec<_> = (0..count).flat_map(|_| draw(&mut random, &joints)).collect();
        let targets: Vec<_> = (0..count)
            .map(|_| own.view().link_pose(&draw(&mut random, &joints), link).expect("a link"))
            .collect();
        let postures = [None, Some(draw(&mut random, &joints))];
        for posture in postures {
            let search = |scale: f64| {
                let in_unit = |values: &[f64], scale: f64| -> Vec<f64> {
                    let joints = joints.iter().filter(|joint| joint.kind.values() > 0).cycle();
                    let unit = |joint: &Joint<f64>| if is_slide(joint) { scale } else { 1.0 };
                    values.iter().zip(joints).map(|(value, joint)| value * unit(joint)).collect()
                };
                let there = rescaled(&joints, scale);
                let mut freedoms = vec![Freedom::default(); there.view().rates()];
                let posture = posture.as_deref().map(|posture| in_unit(posture, scale));
                let mut reach = Reach::new(there.view(), &goals, &mut freedoms).expect("a problem");
                if let Some(posture) = &posture {
                    reach = reach.with_posture(posture).expect("a posture");
                }
                let targets: Vec<_> = targets.iter().map(|&pose| motion(pose, scale)).collect();
                let options = Options {
                    linear_tolerance: 1e-5 * scale,
                    length_per_radian: length_per_radian.map(|length| length * scale),
                    ..Options::default()
                };
                let solved = solve_everywhere(&reach, &targets, &in_unit(&starts, scale), &options);
                let mut all = Vec::new();
                for (backend, values, reports) in solved {
                    let values = in_unit(&values, 1.0 / scale);
                    let steps: Vec<_> = reports
                        .iter()
                        .map(|report| {
                            let linear = report.linear_error / scale;
                            (
                                report.outcome,
                                report.iterations,
                                report.restarts,
                                report.angular_error,
                                linear,
                            )
                        })
                        .collect();
                    all.push((backend, values, steps));
                }
                all
            };
            let metres = search(1.0);
            for scale in [1024.0, 1.0 / 256.0] {
                assert_eq!(search(scale), metres, "{} joints, {scale}", joints.len());
            }
        }
    }
}
