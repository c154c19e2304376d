//! [`Alignment`]: the map of one set of positions onto another one.

use dq8::representation::RotationTranslation;
use dq8::scalar::vector;
use dq8::seams::best_rotation;
use dq8::{DualQuat, Quat, Real};

/// How an estimate is laid over its reference before they are compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Align {
    /// Not at all: both are in one frame.
    #[default]
    None,
    /// The first pose onto the first one.
    Origin,
    /// Turned about the z axis of the reference and shifted, so that the sum of the squares of the
    /// distances of the positions is least: for odometry that knows which way is down.
    Yaw,
    /// The same with any rotation (Horn 1987; Umeyama 1991).
    Rigid,
    /// The same with any rotation and a scale (Umeyama 1991): for one camera, which sees no scale.
    Similarity,
}

/// The map of positions of an estimate onto those of its reference, p ↦ s·r p r* + t.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Alignment {
    /// r and t.
    pub motion: DualQuat<f64>,
    /// s, which is 1 but for [`Align::Similarity`].
    pub scale: f64,
}

pub(super) type Pose = RotationTranslation<f64>;

/// A rotation, a translation and a scale.
pub(super) struct Map(pub(super) Pose, pub(super) f64);

impl Map {
    /// The pose, moved; the scale changes its translation alone.
    pub(super) fn of(&self, pose: Pose) -> Pose {
        let Self(motion, scale) = self;
        let translation = motion.transform_point(vector::scale(pose.translation, *scale));
        Pose { rotation: motion.rotation * pose.rotation, translation }
    }
}

/// The map, or nothing where many are as good.
pub(super) fn align(how: Align, reference: &[Pose], estimate: &[Pose]) -> Option<Map> {
    if how == Align::None {
        return Some(Map(Pose::IDENTITY, 1.0));
    }
    if how == Align::Origin {
        return Some(Map(*reference.first()? * estimate.first()?.inverse(), 1.0));
    }
    let centers = [center(reference), center(estimate)];
    // Σ y xᵀ of x in the estimate and y in the reference, each from its center.
    let mut products = [[0.0; 3]; 3];
    let mut squares = [0.0; 2];
    let mut furthest = [0.0_f64; 2];
    for (y, x) in reference.iter().zip(estimate) {
        let far = [y, x].map(|pose| vector::norm(pose.translation));
        furthest = [furthest[0].max(far[0]), furthest[1].max(far[1])];
        let y = vector::sub(y.translation, centers[0]);
        let x = vector::sub(x.translation, centers[1]);
        for (row, y) in products.iter_mut().zip(y) {
            *row = vector::add(*row, vector::scale(x, y));
        }
        squares = [squares[0] + vector::dot(y, y), squares[1] + vector::dot(x, x)];
    }
    // Of Σ|y − s r x r*|² only the mixed term depends on the rotation: it is the sum of the
    // products of its elements and these, which is to be largest.
    let (rotation, [sum, gap]) = match how {
        Align::Yaw => yaw(products),
        _ => best_rotation(products).ok()?,
    };
    // What the rounding of the positions, which grows with their distance from the origin, can add
    // to a product. The comparison is false for what has overflowed, too.
    let lengths = squares.map(Real::sqrt);
    let mixed = furthest[0] * lengths[1] + furthest[1] * lengths[0];
    let rounding = 8.0 * f64::EPSILON * Real::sqrt(reference.len() as f64) * mixed;
    let clear = gap > rounding && rounding.is_finite();
    if !clear {
        return None;
    }
    let scale = if how == Align::Similarity { sum / squares[1] } else { 1.0 };
    let shift = rotation.rotate(vector::scale(centers[1], scale));
    Some(Map(Pose { rotation, translation: vector::sub(centers[0], shift) }, scale))
}

fn center(poses: &[Pose]) -> [f64; 3] {
    let sum = poses.iter().fold([0.0; 3], |sum, pose| vector::add(sum, pose.translation));
    sum.map(|sum| sum / poses.len() as f64)
}

/// The best rotation about z, the sum of the products for it, and how much of it depends on the
/// angle: (a + e) cos ψ + (d − b) sin ψ.
fn yaw([[a, b, _], [d, e, _], [.., i]]: [[f64; 3]; 3]) -> (Quat<f64>, [f64; 2]) {
    let [cosine, sine] = [a + e, d - b];
    let gap = Real::sqrt(cosine * cosine + sine * sine);
    (Quat::from_rotation_z(Real::atan2(sine, cosine)), [gap + i, gap])
}
