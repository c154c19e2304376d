//! [`Stretch`]: a time of constant velocity, of which trajectories are made.

use crate::screw::parts;
use crate::segments::Outside;
use crate::{Trajectory, TrajectoryError};
use alloc::vec::Vec;
use dq8::{DualQuat, Real, Twist};

/// A time of constant velocity, from its start on.
pub(crate) struct Stretch {
    pub(crate) start: f64,
    pub(crate) pose: DualQuat<f64>,
    /// For one second, in the frame of the moving body.
    pub(crate) velocity: Twist<f64>,
}

impl Stretch {
    /// The pose at a time in seconds, as if the stretch had no end.
    pub(crate) fn at(&self, time: f64) -> DualQuat<f64> {
        self.pose * DualQuat::from_twist(self.velocity.scale(time - self.start))
    }
}

/// The time before the first stamp, the ways between the poses, cut into parts that turn little,
/// and the time after the last stamp.
pub(crate) fn stretches(
    path: Trajectory<'_>,
    outside: Outside,
) -> Result<Vec<Stretch>, TrajectoryError> {
    let (stamps, poses) = (path.stamps(), path.poses());
    let mut between = Vec::with_capacity(stamps.len());
    for (pair, stamps) in poses.windows(2).zip(stamps.windows(2)) {
        let length = stamps[1] - stamps[0];
        let way = pair[0].twist_to(pair[1]);
        let velocity = Twist::from_array(way.to_array().map(|number| number / length));
        let [x, y, z] = way.angular;
        // The shorter way turns by π at most. Of poses that are not unit it may turn by anything,
        // which must not become that much memory.
        let parts = parts(Real::sqrt(x * x + y * y + z * z).min(core::f64::consts::PI));
        for part in 0..parts {
            let start = stamps[0] + length * (part as f64 / parts as f64);
            // The start is rounded, and the pose is the one at the rounded start.
            let share = (start - stamps[0]) / length;
            let pose = pair[0] * DualQuat::from_twist(way.scale(share));
            between.push(Stretch { start, pose, velocity });
        }
    }
    let [before, after] = match (outside, between.first().zip(between.last())) {
        (Outside::Continue, Some((first, last))) => [first.velocity, last.velocity],
        (Outside::Continue, None) => return Err(TrajectoryError::OnePose),
        _ => [Twist::ZERO; 2],
    };
    let [first, last] = path.range();
    let before = Stretch { start: first, pose: poses[0], velocity: before };
    let after = Stretch { start: last, pose: poses[poses.len() - 1], velocity: after };
    Ok([before].into_iter().chain(between).chain([after]).collect())
}
