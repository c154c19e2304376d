//! [`Trajectory`] and [`OwnedTrajectory`]: poses at rising stamps.

use crate::TrajectoryError;
use crate::screw::parts;
use alloc::vec::Vec;
use core::ops::Range;
use dq8::storage::same_length;
use dq8::{DualQuat, Real, Twist};

/// Poses at rising stamps, in memory of the caller; from one to the next it is screw motion by the
/// shorter way.
///
/// A pose carries the moving body (a scanner, a camera) into the frame of the world:
/// `world = pose.transform_point(body)`. Stamps are seconds. Poses must be unit, as everywhere.
///
/// ```
/// use dq8::DualQuat;
/// use dq8_trajectory::{Trajectory, TrajectoryError};
/// let poses = [0.0, 2.0, 8.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
/// let path = Trajectory::new(&[0.0, 1.0, 3.0], &poses)?;
/// assert_eq!(path.at(2.0).translation(), [5.0, 0.0, 0.0]);
/// assert_eq!(path.at(9.0).translation(), [8.0, 0.0, 0.0]); // it stays where it ends
/// let error = Trajectory::new(&[0.0, 1.0, 1.0], &poses).unwrap_err();
/// assert_eq!(error, TrajectoryError::NotRising { index: 2, value: 1.0 });
/// # Ok::<(), TrajectoryError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Trajectory<'a> {
    stamps: &'a [f64],
    poses: &'a [DualQuat<f64>],
}

impl<'a> Trajectory<'a> {
    /// A trajectory through `poses[k]` at the time `stamps[k]`.
    ///
    /// # Errors
    /// If the slices differ in length, are empty, a stamp is not finite, not later than the one
    /// before, or further from the first than the largest number.
    pub fn new(stamps: &'a [f64], poses: &'a [DualQuat<f64>]) -> Result<Self, TrajectoryError> {
        same_length("poses", poses.len(), stamps.len())?;
        if stamps.is_empty() {
            return Err(TrajectoryError::Empty);
        }
        let mut before = None;
        for (index, &value) in stamps.iter().enumerate() {
            // From the first stamp on, so that no time between two of them is infinite.
            let since = value - stamps[0];
            if !since.is_finite() || before.is_some_and(|before| value <= before) {
                return Err(TrajectoryError::NotRising { index, value });
            }
            before = Some(value);
        }
        Ok(Self { stamps, poses })
    }

    /// The stamps in seconds.
    #[must_use]
    pub fn stamps(self) -> &'a [f64] {
        self.stamps
    }

    /// The poses.
    #[must_use]
    pub fn poses(self) -> &'a [DualQuat<f64>] {
        self.poses
    }

    /// The first stamp and the last, in seconds.
    #[must_use]
    pub fn range(self) -> [f64; 2] {
        [self.stamps.first(), self.stamps.last()].map(|stamp| stamp.copied().unwrap_or(f64::NAN))
    }

    /// The pose at a time in seconds: σ_k (σ_k* σ_{k+1})^s between the stamps k and k + 1, at
    /// the share s of the way (Kavan et al. 2008, ScLERP). Before the first stamp and after the
    /// last one it is their pose; at NaN it is NaN.
    #[must_use]
    pub fn at(self, time: f64) -> DualQuat<f64> {
        let after = self.stamps.partition_point(|&stamp| stamp <= time);
        let (Some(&first), Some(&last)) = (self.poses.first(), self.poses.last()) else {
            return DualQuat::IDENTITY.scale(f64::NAN);
        };
        let before = after.wrapping_sub(1);
        match (self.stamps.get(before), self.stamps.get(after)) {
            _ if time.is_nan() => first.scale(f64::NAN),
            (None, _) => first,
            (_, None) => last,
            (Some(&start), Some(&end)) => {
                self.poses[before].sclerp(self.poses[after], (time - start) / (end - start))
            }
        }
    }

    /// Of these poses the first two and the last two, and those on both sides of each time: between
    /// them the body moves as it does here, at these times and outside the stamps.
    pub(crate) fn around(self, times: impl Iterator<Item = f64>) -> OwnedTrajectory {
        let count = self.stamps.len();
        let after = times.map(|time| self.stamps.partition_point(|&stamp| stamp <= time));
        let mut wanted: Vec<_> = after.chain([1, count - 1]).collect();
        wanted.sort_unstable();
        wanted.dedup();
        let mut indices: Vec<_> =
            wanted.into_iter().flat_map(|after| [after.saturating_sub(1), after]).collect();
        indices.dedup();
        indices.retain(|&index| index < count);
        let stamps = indices.iter().map(|&index| self.stamps[index]).collect();
        let poses = indices.iter().map(|&index| self.poses[index]).collect();
        OwnedTrajectory { stamps, poses }
    }
}

/// A [`Trajectory`] with memory of its own.
#[derive(Clone, Debug)]
pub struct OwnedTrajectory {
    stamps: Vec<f64>,
    poses: Vec<DualQuat<f64>>,
}

impl OwnedTrajectory {
    /// A trajectory through `poses[k]` at the time `stamps[k]`.
    ///
    /// # Errors
    /// As for [`Trajectory::new`].
    pub fn new(stamps: Vec<f64>, poses: Vec<DualQuat<f64>>) -> Result<Self, TrajectoryError> {
        Trajectory::new(&stamps, &poses)?;
        Ok(Self { stamps, poses })
    }

    /// A trajectory of stamps in any order. Of equal stamps the first pose in the input is kept;
    /// the number of those that were dropped is the second result.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_trajectory::OwnedTrajectory;
    /// let poses = [3.0, 1.0, 2.0, 9.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
    /// let (path, dropped) = OwnedTrajectory::sorted(&[0.3, 0.1, 0.2, 0.1], &poses)?;
    /// assert_eq!((path.stamps(), dropped), (&[0.1, 0.2, 0.3][..], 1));
    /// assert_eq!(path.at(0.1), poses[1]);
    /// # Ok::<(), dq8_trajectory::TrajectoryError>(())
    /// ```
    ///
    /// # Errors
    /// If the slices differ in length, are empty, or a stamp is not finite.
    pub fn sorted(
        stamps: &[f64],
        poses: &[DualQuat<f64>],
    ) -> Result<(Self, usize), TrajectoryError> {
        same_length("poses", poses.len(), stamps.len())?;
        if let Some(index) = stamps.iter().position(|stamp| !stamp.is_finite()) {
            return Err(TrajectoryError::NotRising { index, value: stamps[index] });
        }
        let mut pairs: Vec<_> = stamps.iter().copied().zip(poses.iter().copied()).collect();
        // Stable; −0 and +0 are one time.
        pairs.sort_by(|(a, _), (b, _)| a.partial_cmp(b).unwrap_or(core::cmp::Ordering::Equal));
        pairs.dedup_by(|(later, _), (kept, _)| later == kept);
        let dropped = stamps.len() - pairs.len();
        let (stamps, poses) = pairs.into_iter().unzip();
        Ok((Self::new(stamps, poses)?, dropped))
    }

    /// The motion at a constant twist for one second, in the frame of the moving body, over a range
    /// of time in seconds: exp(tξ), which is the identity at the time 0. It is the motion that
    /// KISS-ICP (Vizzo et al. 2023, §III-A) supposes within a scan.
    ///
    /// ```
    /// use dq8::Twist;
    /// use dq8_trajectory::OwnedTrajectory;
    /// let velocity = Twist { angular: [0.0, 0.0, 40.0], linear: [0.0, 0.0, 2.0] };
    /// let path = OwnedTrajectory::of_twist(velocity, 0.0..1.0)?;
    /// // Forty radians are more than six turns, and none is lost.
    /// assert!((path.at(1.0).translation()[2] - 2.0).abs() < 1e-12);
    /// # Ok::<(), dq8_trajectory::TrajectoryError>(())
    /// ```
    ///
    /// # Errors
    /// If a number is not finite, the range does not rise, or the turn is longer than 10⁶
    /// radians.
    pub fn of_twist(twist: Twist<f64>, range: Range<f64>) -> Result<Self, TrajectoryError> {
        let numbers = twist.to_array().into_iter().chain([range.start, range.end]);
        if let Some(value) = { numbers }.find(|number| !number.is_finite()) {
            return Err(TrajectoryError::NotFinite { value });
        }
        if range.start >= range.end {
            return Err(TrajectoryError::NotRising { index: 1, value: range.end });
        }
        let [x, y, z] = twist.angular;
        let length = range.end - range.start;
        let turn = Real::sqrt(x * x + y * y + z * z) * length;
        // Also where the length or the square is infinite.
        if !(turn <= 1e6 && length.is_finite()) {
            return Err(TrajectoryError::NotFinite { value: turn });
        }
        // Each part is a small turn, for which the shorter way is the way.
        let parts = parts(turn);
        let stamp = |part: usize| {
            if part == parts {
                range.end
            } else {
                range.start + length * (part as f64 / parts as f64)
            }
        };
        let stamps: Vec<_> = (0..=parts).map(stamp).collect();
        let poses = stamps.iter().map(|&time| DualQuat::from_twist(twist.scale(time))).collect();
        Self::new(stamps, poses)
    }

    /// The trajectory, borrowed.
    #[must_use]
    pub fn view(&self) -> Trajectory<'_> {
        Trajectory { stamps: &self.stamps, poses: &self.poses }
    }

    /// The stamps in seconds.
    #[must_use]
    pub fn stamps(&self) -> &[f64] {
        &self.stamps
    }

    /// The poses.
    #[must_use]
    pub fn poses(&self) -> &[DualQuat<f64>] {
        &self.poses
    }

    /// The first stamp and the last: [`Trajectory::range`].
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        self.view().range()
    }

    /// The pose at a time in seconds: [`Trajectory::at`].
    #[must_use]
    pub fn at(&self, time: f64) -> DualQuat<f64> {
        self.view().at(time)
    }
}

impl<'a> From<&'a OwnedTrajectory> for Trajectory<'a> {
    fn from(path: &'a OwnedTrajectory) -> Self {
        path.view()
    }
}
