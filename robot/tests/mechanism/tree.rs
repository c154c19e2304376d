//! Random trees of joints of all kinds, and their configurations.

use dq8::{DualQuat, Quat, Real};
use dq8_fixtures::random::Random;
use dq8_robot::{Joint, JointKind, OwnedMechanism};

/// Half of them along an axis of the frame, either way.
fn axis(random: &mut Random) -> [f64; 3] {
    match random.below(12) {
        which @ 0..6 => {
            let mut axis = [0.0; 3];
            axis[which % 3] = if which < 3 { 1.0 } else { -1.0 };
            axis
        }
        _ => random.direction(),
    }
}

fn placement(random: &mut Random) -> DualQuat<f64> {
    let rotation = match random.below(3) {
        0 => Quat::IDENTITY,
        1 => Quat::from_axis_angle(axis(random), 3.0 * random.signed()),
        _ => Quat::from_array(random.direction()),
    };
    let translation = match random.below(3) {
        0 => [0.0; 3],
        1 => axis(random).map(|number| 0.3 * number),
        _ => random.vector(),
    };
    DualQuat::from_rotation_translation(rotation, translation)
}

/// A tree of `count` joints; about a tenth of them mimic.
pub(crate) fn tree(random: &mut Random, count: usize) -> Vec<Joint<f64>> {
    let mut joints: Vec<Joint<f64>> = Vec::new();
    for index in 0..count {
        let near = index.saturating_sub(1 + random.below(3).min(index));
        let parent = (index > 0 && random.below(12) > 0).then_some(near);
        let (axis, placement) = (axis(random), placement(random));
        let kind = match random.below(9) {
            0 => JointKind::Fixed,
            1 => JointKind::Prismatic { axis },
            2 => JointKind::Screw { axis, pitch: 0.2 },
            3 => JointKind::Planar { normal: axis },
            4 => JointKind::Floating,
            _ => JointKind::Revolute { axis },
        };
        let mut joint = Joint::new(parent, placement, kind);
        let leader = random.below(count);
        if kind.values() == 1
            && joints
                .get(leader)
                .is_some_and(|other| other.kind.values() == 1 && other.mimic.is_none())
            && random.below(3) == 0
        {
            joint = joint.mimicking(leader, -0.7, 0.1);
        }
        joints.push(joint);
    }
    joints
}

/// Values of one configuration: angles of a few turns, floating rotations of any length.
pub(crate) fn values(random: &mut Random, joints: &[Joint<f64>]) -> Vec<f64> {
    let mut values = Vec::new();
    for joint in joints {
        match joint.kind {
            _ if joint.mimic.is_some() => {}
            JointKind::Floating => {
                let length = 1.5 + random.signed();
                values.extend(random.direction::<4>().map(|number| number * length));
                values.extend(random.vector::<3>());
            }
            kind => values.extend((0..kind.values()).map(|_| 8.0 * random.signed())),
        }
    }
    values
}

pub(crate) fn mechanism<R: Real>(joints: &[Joint<f64>]) -> OwnedMechanism<R> {
    let joints: Vec<_> = joints.iter().map(Joint::cast).collect();
    OwnedMechanism::new(&joints).expect("a mechanism")
}
