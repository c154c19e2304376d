//! Random trees of joints of all kinds, and their configurations.

use dq8::mechanism::{Joint, JointKind, OwnedMechanism};
use dq8::{DualQuat, Quat, Real};

/// A small generator: tests must give the same numbers everywhere.
pub(crate) struct Numbers(u64);

impl Numbers {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(2) + 1)
    }
    /// In [−1, 1).
    pub(crate) fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / f64::from(1_u32 << 30) - 1.0
    }
    pub(crate) fn below(&mut self, bound: usize) -> usize {
        ((self.next() + 1.0) / 2.0 * bound as f64) as usize
    }
    fn unit<const N: usize>(&mut self) -> [f64; N] {
        loop {
            let vector: [f64; N] = core::array::from_fn(|_| self.next());
            let norm = vector.iter().map(|number| number * number).sum::<f64>().sqrt();
            if norm > 0.1 {
                return vector.map(|number| number / norm);
            }
        }
    }
    /// Half of them along an axis of the frame, either way.
    fn axis(&mut self) -> [f64; 3] {
        match self.below(12) {
            which @ 0..6 => {
                let mut axis = [0.0; 3];
                axis[which % 3] = if which < 3 { 1.0 } else { -1.0 };
                axis
            }
            _ => self.unit(),
        }
    }
    fn placement(&mut self) -> DualQuat<f64> {
        let rotation = match self.below(3) {
            0 => Quat::IDENTITY,
            1 => Quat::from_axis_angle(self.axis(), 3.0 * self.next()),
            _ => Quat::from_array(self.unit()),
        };
        let translation = match self.below(3) {
            0 => [0.0; 3],
            1 => self.axis().map(|number| 0.3 * number),
            _ => core::array::from_fn(|_| self.next()),
        };
        DualQuat::from_rotation_translation(rotation, translation)
    }
}

/// A tree of `count` joints; about a tenth of them mimic.
pub(crate) fn tree(numbers: &mut Numbers, count: usize) -> Vec<Joint<f64>> {
    let mut joints: Vec<Joint<f64>> = Vec::new();
    for index in 0..count {
        let near = index.saturating_sub(1 + numbers.below(3).min(index));
        let parent = (index > 0 && numbers.below(12) > 0).then_some(near);
        let (axis, placement) = (numbers.axis(), numbers.placement());
        let kind = match numbers.below(9) {
            0 => JointKind::Fixed,
            1 => JointKind::Prismatic { axis },
            2 => JointKind::Screw { axis, pitch: 0.2 },
            3 => JointKind::Planar { normal: axis },
            4 => JointKind::Floating,
            _ => JointKind::Revolute { axis },
        };
        let mut joint = Joint::new(parent, placement, kind);
        let leader = numbers.below(count);
        if kind.values() == 1
            && joints
                .get(leader)
                .is_some_and(|other| other.kind.values() == 1 && other.mimic.is_none())
            && numbers.below(3) == 0
        {
            joint = joint.mimicking(leader, -0.7, 0.1);
        }
        joints.push(joint);
    }
    joints
}

/// Values of one configuration: angles of a few turns, floating rotations of any length.
pub(crate) fn values(numbers: &mut Numbers, joints: &[Joint<f64>]) -> Vec<f64> {
    let mut values = Vec::new();
    for joint in joints {
        match joint.kind {
            _ if joint.mimic.is_some() => {}
            JointKind::Floating => {
                let length = 1.5 + numbers.next();
                values.extend(numbers.unit::<4>().map(|number| number * length));
                values.extend((0..3).map(|_| numbers.next()));
            }
            kind => values.extend((0..kind.values()).map(|_| 8.0 * numbers.next())),
        }
    }
    values
}

pub(crate) fn mechanism<R: Real>(joints: &[Joint<f64>]) -> OwnedMechanism<R> {
    let joints: Vec<_> = joints.iter().map(Joint::cast).collect();
    OwnedMechanism::new(&joints).expect("a mechanism")
}
