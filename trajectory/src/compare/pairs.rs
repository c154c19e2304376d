//! [`Pairs`]: poses of two trajectories at the same times.

use super::align::{Align, Alignment, Map, Pose, align};
use super::error::CompareError;
use super::errors::{Errors, angle};
use super::step::Step;
use crate::{OwnedTrajectory, Trajectory};
use alloc::vec::Vec;
use dq8::DualQuat;
use dq8::scalar::vector;

/// Poses of a reference and of an estimate at the same times, in order of time.
///
/// ```
/// use dq8::{DualQuat, Quat};
/// use dq8_trajectory::OwnedTrajectory;
/// use dq8_trajectory::compare::{Align, Step};
/// // A car on a curve, and an odometer that began elsewhere and measures every tenth metre twice.
/// let stamps: Vec<_> = (0..100).map(|k| 0.1 * f64::from(k)).collect();
/// let curve = |factor: f64| {
///     let turn = |k| Quat::from_rotation_z(0.02 * f64::from(k));
///     let at = |k| [factor * f64::from(k) / 10.0, factor * f64::from(k * k) / 1000.0, 0.0];
///     (0..100).map(|k| DualQuat::from_rotation_translation(turn(k), at(k))).collect()
/// };
/// let reference = OwnedTrajectory::new(stamps.clone(), curve(1.0))?;
/// let estimate = OwnedTrajectory::new(stamps, curve(1.1))?;
/// let pairs = reference.pair(&estimate, 0.01)?.align(Align::Similarity)?;
/// assert!((pairs.alignment().scale - 1.0 / 1.1).abs() < 1e-14);
/// assert!(pairs.absolute().translation().rmse < 1e-13);
/// assert!(pairs.relative(Step::Metres(2.0))?.rotation().max < 1e-7);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Pairs {
    stamps: Vec<f64>,
    reference: Vec<Pose>,
    estimate: Vec<Pose>,
    alignment: Alignment,
}

impl Trajectory<'_> {
    /// Each pose of whichever trajectory has fewer (of the estimate, where they have as many) with
    /// that of the other one whose stamp is nearest, the earlier of two, if it is at most
    /// `tolerance` seconds away. A pose of the longer one may have several partners. It is the
    /// association of evo.
    ///
    /// # Errors
    /// If the tolerance is negative or NaN, no pose has a partner, or one that has is not finite.
    pub fn pair<'e>(
        self,
        estimate: impl Into<Trajectory<'e>>,
        tolerance: f64,
    ) -> Result<Pairs, CompareError> {
        let estimate = estimate.into();
        if tolerance.is_nan() || tolerance < 0.0 {
            return Err(CompareError::Tolerance { value: tolerance });
        }
        let swapped = estimate.stamps().len() > self.stamps().len();
        let (few, many) = if swapped { (self, estimate) } else { (estimate, self) };
        let mut indices = Vec::with_capacity(few.stamps().len());
        // The last stamp that is not later, and so the earlier of the two around the stamp.
        let mut before = 0;
        for (index, &stamp) in few.stamps().iter().enumerate() {
            let away = |other: usize| many.stamps().get(other).map(|other| (other - stamp).abs());
            while many.stamps().get(before + 1).is_some_and(|&next| next <= stamp) {
                before += 1;
            }
            let later = away(before + 1).is_some_and(|later| Some(later) < away(before));
            let near = before + usize::from(later);
            if away(near).is_some_and(|away| away <= tolerance) {
                indices.push(if swapped { [index, near] } else { [near, index] });
            }
        }
        let reference = indices.iter().map(|pair| (pair[0], self.poses()[pair[0]]));
        let estimated = indices.iter().map(|pair| (pair[1], estimate.poses()[pair[1]]));
        let stamps = indices.iter().map(|pair| self.stamps()[pair[0]]).collect();
        Pairs::new(stamps, reference, estimated).ok_or_else(|| none(self, estimate))?
    }

    /// Each pose of this trajectory whose stamp lies within those of the estimate, with the pose of
    /// the estimate at that time ([`Trajectory::at`], along the screw from one pose to the next).
    ///
    /// # Errors
    /// If the estimate has no pose at any of these times, or a pose is not finite.
    pub fn interpolated<'e>(
        self,
        estimate: impl Into<Trajectory<'e>>,
    ) -> Result<Pairs, CompareError> {
        let estimate = estimate.into();
        let [first, last] = estimate.range();
        let begin = self.stamps().partition_point(|&stamp| stamp < first);
        let end = self.stamps().partition_point(|&stamp| stamp <= last);
        let inside = begin..end.max(begin);
        let stamps = self.stamps()[inside.clone()].to_vec();
        let reference = inside.clone().map(|index| (index, self.poses()[index]));
        let estimated = inside.map(|index| {
            let stamp = self.stamps()[index];
            let before = estimate.stamps().partition_point(|&other| other <= stamp);
            (before.saturating_sub(1), estimate.at(stamp))
        });
        Pairs::new(stamps, reference, estimated).ok_or_else(|| none(self, estimate))?
    }
}

fn none(reference: Trajectory<'_>, estimate: Trajectory<'_>) -> CompareError {
    CompareError::NoPairs { reference: reference.range(), estimate: estimate.range() }
}

impl OwnedTrajectory {
    /// [`Trajectory::pair`]
    ///
    /// # Errors
    /// As there.
    pub fn pair<'e>(
        &self,
        estimate: impl Into<Trajectory<'e>>,
        tolerance: f64,
    ) -> Result<Pairs, CompareError> {
        self.view().pair(estimate, tolerance)
    }

    /// [`Trajectory::interpolated`]
    ///
    /// # Errors
    /// As there.
    pub fn interpolated<'e>(
        &self,
        estimate: impl Into<Trajectory<'e>>,
    ) -> Result<Pairs, CompareError> {
        self.view().interpolated(estimate)
    }
}

impl Pairs {
    /// Nothing of no pairs. Poses come with their number.
    fn new(
        stamps: Vec<f64>,
        reference: impl Iterator<Item = (usize, DualQuat<f64>)>,
        estimate: impl Iterator<Item = (usize, DualQuat<f64>)>,
    ) -> Option<Result<Self, CompareError>> {
        if stamps.is_empty() {
            return None;
        }
        let alignment = Alignment { motion: DualQuat::IDENTITY, scale: 1.0 };
        let pairs = || {
            let reference = finite("reference", reference)?;
            let estimate = finite("estimate", estimate)?;
            Ok(Self { stamps, reference, estimate, alignment })
        };
        Some(pairs())
    }

    /// The stamps of the reference in seconds.
    #[must_use]
    pub fn stamps(&self) -> &[f64] {
        &self.stamps
    }

    /// The poses of the reference.
    pub fn reference(&self) -> &[Pose] {
        &self.reference
    }

    /// The poses of the estimate, as they are aligned.
    pub fn estimate(&self) -> &[Pose] {
        &self.estimate
    }

    /// The map that the last alignment moved the estimate by; at first the identity.
    #[must_use]
    pub fn alignment(&self) -> Alignment {
        self.alignment
    }

    /// The same pairs with the estimate laid over the reference.
    ///
    /// # Errors
    /// If the positions of either lie on a line or in a point (for [`Align::Yaw`], as seen from
    /// above in a point), within rounding: then many rotations are as good. Or if squares of
    /// distances overflow.
    pub fn align(mut self, how: Align) -> Result<Self, CompareError> {
        let pairs = self.stamps.len();
        let map = align(how, &self.reference, &self.estimate);
        let map = map.ok_or(CompareError::Ambiguous { pairs })?;
        for pose in &mut self.estimate {
            *pose = map.of(*pose);
        }
        let Map(motion, scale) = map;
        self.alignment = Alignment { motion: motion.into(), scale };
        Ok(self)
    }

    /// The distances of the poses: |t − u| and the angle of p*q, where the reference has the
    /// translation t and the rotation p, the estimate u and q. They are the absolute pose error of
    /// evo (APE), and the absolute trajectory error of Sturm et al. 2012 (ATE) where the pairs are
    /// aligned.
    #[must_use]
    pub fn absolute(&self) -> Errors {
        let pairs = || self.reference.iter().zip(&self.estimate);
        let away = |a: &Pose, b: &Pose| vector::norm(vector::sub(b.translation, a.translation));
        let turned = |a: &Pose, b: &Pose| angle(a.rotation.conjugate() * b.rotation);
        Errors {
            stamps: self.stamps.clone(),
            translations: pairs().map(|(a, b)| away(a, b)).collect(),
            rotations: pairs().map(|(a, b)| turned(a, b)).collect(),
        }
    }

    /// The difference of motions over a step from pair i to pair j: the translation and the
    /// rotation of (Qᵢ⁻¹Qⱼ)⁻¹(Pᵢ⁻¹Pⱼ), where the reference has the poses Q and the
    /// estimate P. It is the relative pose error of evo (RPE) over consecutive steps, after Sturm
    /// et al. 2012.
    ///
    /// # Errors
    /// If the step is not positive and finite, or none ends before the pairs do.
    pub fn relative(&self, step: Step) -> Result<Errors, CompareError> {
        let ends = self.ends(step)?;
        let pairs = self.stamps.len();
        if ends.len() < 2 {
            return Err(CompareError::NoSteps { step, pairs });
        }
        let (mut translations, mut rotations) = (Vec::new(), Vec::new());
        for ends in ends.windows(2) {
            let motion = |poses: &[Pose]| between(poses[ends[0]], poses[ends[1]]);
            let [a, b] = [motion(&self.reference), motion(&self.estimate)];
            translations.push(vector::norm(vector::sub(b.translation, a.translation)));
            rotations.push(angle(a.rotation.conjugate() * b.rotation));
        }
        let stamps = ends[1..].iter().map(|&end| self.stamps[end]).collect();
        Ok(Errors { stamps, translations, rotations })
    }

    /// The pairs at which steps begin and end.
    fn ends(&self, step: Step) -> Result<Vec<usize>, CompareError> {
        let pairs = self.stamps.len();
        let (mut ends, mut gone) = (Vec::from([0]), 0.0);
        match step {
            Step::Frames(frames) if frames > 0 => return Ok((0..pairs).step_by(frames).collect()),
            Step::Metres(metres) if metres > 0.0 && metres.is_finite() => {
                for (index, poses) in self.estimate.windows(2).enumerate() {
                    let way = vector::sub(poses[1].translation, poses[0].translation);
                    gone += vector::norm(way);
                    if gone >= metres {
                        ends.push(index + 1);
                        gone = 0.0;
                    }
                }
            }
            Step::Seconds(seconds) if seconds > 0.0 && seconds.is_finite() => {
                let mut begin = self.stamps[0];
                for (index, &stamp) in self.stamps.iter().enumerate().skip(1) {
                    // Both stamps were rounded.
                    let rounding = f64::EPSILON * (begin.abs() + stamp.abs());
                    if stamp - begin >= seconds - rounding {
                        ends.push(index);
                        begin = stamp;
                    }
                }
            }
            _ => return Err(CompareError::Step { step }),
        }
        Ok(ends)
    }
}

fn finite(
    what: &'static str,
    poses: impl Iterator<Item = (usize, DualQuat<f64>)>,
) -> Result<Vec<Pose>, CompareError> {
    { poses }
        .map(|(index, pose)| match pose.is_finite() {
            true => Ok(pose.into()),
            false => Err(CompareError::NotFinite { what, index }),
        })
        .collect()
}

/// a⁻¹b, its translation from the difference of theirs: far from the origin nothing cancels.
fn between(a: Pose, b: Pose) -> Pose {
    let back = a.rotation.conjugate();
    let translation = back.rotate(vector::sub(b.translation, a.translation));
    Pose { rotation: back * b.rotation, translation }
}
