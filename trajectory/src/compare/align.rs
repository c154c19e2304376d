//! [`Alignment`]: the map of one set of positions onto another one.

use alloc::vec::Vec;
use dq8::representation::RotationTranslation;
use dq8::scalar::vector;
use dq8::{DualQuat, fit::PointPairs};

/// The way in which an estimate is laid over its reference before they are compared.
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
    let positions =
        |poses: &[Pose]| -> Vec<_> { poses.iter().map(|pose| pose.translation).collect() };
    let [from, to] = [positions(estimate), positions(reference)];
    let pairs = PointPairs::new(&from, &to).ok()?;
    let fit = match how {
        Align::Yaw => pairs.about([0.0, 0.0, 1.0]),
        Align::Similarity => pairs.similarity(),
        _ => pairs.rigid(),
    };
    let fit = fit.ok()?;
    Some(Map(fit.motion.into(), fit.scale))
}
