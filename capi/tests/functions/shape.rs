//! The lengths of the arrays that functions are called with.

use crate::element::record;
use dq8::DualQuat;
use dq8_fixtures::random::Random;
use dq8_robot::{Joint, JointKind};

#[derive(Clone, Debug)]
pub(crate) struct Shape {
    /// The number of elements of an array.
    pub(crate) count: usize,
    /// The parents of a hierarchy.
    pub(crate) parents: Vec<i32>,
    /// The instances of a hierarchy, and the configurations of a mechanism.
    pub(crate) instances: usize,
    /// The times of a trajectory.
    pub(crate) times: Vec<f64>,
    /// The joints of a mechanism.
    pub(crate) joints: Vec<Joint<f64>>,
    /// The number of goals of a search.
    pub(crate) goals: usize,
    /// The number of vertices of a skin.
    pub(crate) vertices: usize,
    pub(crate) influences: usize,
    /// True if a vertex has normals. The next two are the same for tangents, and the order of the
    /// numbers of a matrix.
    pub(crate) normals: bool,
    pub(crate) tangents: bool,
    pub(crate) order: i32,
    /// Something that may be wrong, any number.
    pub(crate) any: usize,
}

/// Joints of these kinds, each on the one before or, if it is `true`, on the base.
fn joints(kinds: impl IntoIterator<Item = (JointKind<f64>, Option<usize>)>) -> Vec<Joint<f64>> {
    let placed =
        |(at, (kind, parent))| Joint::new(parent, DualQuat::from_array(record(at, 9)), kind);
    kinds.into_iter().enumerate().map(placed).collect()
}

fn axis(at: usize) -> [f64; 3] {
    let [x, y, z, w] = record::<f64, 4>(at, 7);
    let length = (1.0 - w * w).sqrt();
    [x / length, y / length, z / length]
}

impl Shape {
    pub(crate) fn all() -> [Self; 3] {
        use JointKind::{Fixed, Floating, Planar, Prismatic, Revolute, Screw};
        let mut every = joints([
            (Floating, None),
            (Revolute { axis: axis(1) }, Some(0)),
            (Prismatic { axis: axis(2) }, Some(1)),
            (Screw { axis: axis(3), pitch: 0.3 }, Some(0)),
            (Planar { normal: axis(4) }, Some(3)),
            (Fixed, Some(2)),
            (Revolute { axis: axis(6) }, Some(4)),
            (Revolute { axis: axis(7) }, None),
            (Fixed, None),
        ]);
        every[6] = every[6].mimicking(1, -2.0, 0.1);
        let hinge = |at: usize| (Revolute { axis: axis(at) }, at.checked_sub(1));
        let hinges =
            joints((0..6).map(hinge)).into_iter().map(|joint| joint.with_limits([-2.5, 2.0]));
        let first = Self {
            count: 35,
            parents: vec![-1, 0, 1, 0],
            instances: 19,
            times: vec![0.0, 1.0, 4.0],
            joints: every,
            goals: 2,
            vertices: 19,
            influences: 4,
            normals: true,
            tangents: true,
            order: 0,
            any: 0,
        };
        let second = Self {
            count: 5,
            parents: vec![-1, 0, 1, 0, 3, -1],
            instances: 3,
            times: vec![-1.0, 0.0, 0.5, 2.0],
            joints: hinges.collect(),
            goals: 1,
            vertices: 33,
            influences: 9,
            normals: false,
            tangents: true,
            order: 1,
            any: 1,
        };
        let last = Self {
            count: 16,
            parents: vec![-1, 0],
            instances: 1,
            vertices: 40,
            influences: 1,
            normals: false,
            tangents: false,
            ..second.clone()
        };
        [first, second, last]
    }

    /// Nothing at all.
    pub(crate) fn nothing() -> Self {
        let [.., last] = Self::all();
        Self {
            count: 0,
            parents: vec![],
            instances: 0,
            joints: vec![],
            vertices: 0,
            goals: 0,
            ..last
        }
    }

    pub(crate) fn any(random: &mut Random) -> Self {
        let parents =
            (0..2 + random.below(11)).map(|joint| random.below(joint + 1) as i32 - 1).collect();
        let mut links: Vec<_> = (0..random.below(12))
            .map(|at| {
                let axis = random.direction();
                let kind = match random.below(6) {
                    0 => JointKind::Fixed,
                    1 => JointKind::Prismatic { axis },
                    2 => JointKind::Screw { axis, pitch: random.signed() },
                    3 => JointKind::Planar { normal: axis },
                    4 => JointKind::Floating,
                    _ => JointKind::Revolute { axis },
                };
                Joint::new(random.below(at + 1).checked_sub(1), random.motion(1.0), kind)
            })
            .collect();
        for at in 1..links.len() {
            let one = |joint: &Joint<f64>| {
                use JointKind::{Prismatic, Revolute, Screw};
                matches!(joint.kind, Revolute { .. } | Prismatic { .. } | Screw { .. })
            };
            if random.below(5) == 0
                && one(&links[at])
                && one(&links[at - 1])
                && links[at - 1].mimic.is_none()
            {
                links[at] = links[at].mimicking(at - 1, random.signed(), random.signed());
            } else if random.below(2) == 0 && one(&links[at]) {
                links[at] = links[at].with_limits([-1.0 - random.signed(), 1.5]);
            }
        }
        Self {
            count: random.below(40),
            parents,
            instances: random.below(20),
            times: (0..1 + random.below(9))
                .map(|at| at as f64 + random.between(0.0, 0.5))
                .collect(),
            joints: links,
            goals: random.below(3),
            vertices: random.below(30),
            influences: 1 + random.below(6),
            normals: random.below(2) == 0,
            tangents: random.below(2) == 0,
            order: random.below(2) as i32,
            any: random.bits() as usize >> 1,
        }
    }

    /// The number of poses of all instances.
    pub(crate) fn poses(&self) -> usize {
        self.parents.len() * self.instances
    }
}
