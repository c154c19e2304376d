//! Trajectories: poses at times, sampled at other times.

use crate::memory::{Input, Output};
use crate::span::disjoint;
use crate::status::{Done, Status};
use dq8::{DualQuat, Scalar};
use dq8_trajectory::{OwnedTrajectory, Time, TrajectoryError};

/// The poses of a trajectory and their times.
struct Known<R> {
    times: *const R,
    poses: *const R,
    count: usize,
}

/// # Safety
/// The same as for [`Input::slice`], [`Output::slice`] and [`Output::write`].
unsafe fn resample<R: Scalar + Time>(
    known: Known<R>,
    at: *const R,
    out: *mut R,
    count: usize,
    bad_time: *mut usize,
) -> Done {
    let times = Input::<R>::new(known.times, known.count)?;
    let poses = Input::<DualQuat<R>>::new(known.poses, known.count)?;
    let at = Input::<R>::new(at, count)?;
    let out = Output::<DualQuat<R>>::new(out, count)?;
    let bad = Output::<usize>::unless_null(bad_time)?;
    disjoint(&[out.span, bad.span], &[times.span, poses.span, at.span])?;
    // SAFETY: the caller promises this, and the arrays are disjoint.
    let (times, poses, at, out) =
        unsafe { (times.slice(), poses.slice(), at.slice(), out.slice()) };
    let stamps = times.iter().map(|&time| time.into()).collect();
    let poses = poses.iter().map(|pose| DualQuat::from_array(pose.to_array().map(Into::into)));
    let (status, index) = match OwnedTrajectory::new(stamps, poses.collect()) {
        Ok(path) => match at.iter().position(|time| time.is_nan()) {
            Some(index) => (Status::NotFinite, index),
            None => return path.job().sample(at, out).map_err(|_| Status::Length),
        },
        Err(TrajectoryError::NotRising { index, .. }) => (Status::Times, index),
        // The trajectory has no pose.
        Err(_) => return Err(Status::Length),
    };
    // SAFETY: the caller promises this, and the arrays are disjoint.
    unsafe { bad.write(index) };
    Err(status)
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Samples a trajectory at other times. `times` and `poses` hold `pose_count` rising
            /// times and the unit poses at these. `at` holds `count` times, and `out` gets the
            /// poses there: along one screw from each pose to the next, by the shorter way. Before
            /// the first time it is the first pose, and after the last time the last one.
            ///
            /// Returns DQ8_STATUS_TIMES if one of `times` is not later than the one before or not
            /// finite, and DQ8_STATUS_NOT_FINITE if one of `at` is NaN, and sets `bad_time`, which
            /// may be null, to its index. Returns DQ8_STATUS_LENGTH if there is no pose.
            resample(
                times: *const $R, poses: *const $R, pose_count: usize, at: *const $R, out: *mut $R,
                count: usize, bad_time: *mut usize,
            ) = super::resample(Known { times, poses, count: pose_count }, at, out, count, bad_time)
        }
    };
}
for_both_numbers!(functions);
