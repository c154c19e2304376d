//! The numbers that all contenders work on.

use dq8::{Quat, representation::RotationTranslation};
use dq8_fixtures::random::Random;

pub(crate) type Pose = RotationTranslation<f64>;

pub(crate) struct Poses {
    pub(crate) rows: Vec<Row>,
}

/// What one operation works on.
#[derive(Clone, Copy)]
pub(crate) struct Row {
    pub(crate) a: Pose,
    pub(crate) b: Pose,
    pub(crate) t: f64,
    pub(crate) point: [f64; 3],
}

/// In and out of 256 motions are 16 KiB in `f32`: the first cache holds both.
pub(crate) const COUNT: usize = 128;

impl Poses {
    pub(crate) fn new() -> Self {
        let mut random = Random(1);
        let rows = (0..COUNT).map(|_| {
            let (a, turn) = (pose(&mut random, 1.0), pose(&mut random, 1.5));
            // Key poses are near each other, with signs as they come.
            let b = Pose { rotation: a.rotation * turn.rotation, ..turn };
            Row { a, b, t: random.between(0.0, 1.0), point: random.vector() }
        });
        Self { rows: rows.collect() }
    }
}

/// `w` is what of the scalar part is not chance: the larger, the smaller the turn. The sign is
/// chance.
fn pose(random: &mut Random, w: f64) -> Pose {
    let [x, y, z, chance] = random.vector();
    let turn = Quat::from_xyzw(x, y, z, w + chance) * random.signed().signum();
    Pose { rotation: turn.normalize(), translation: random.vector().map(|c| 2.0 * c) }
}
