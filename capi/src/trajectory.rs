//! Trajectories: poses at times, sampled at other times.

use crate::memory::{Input, Output};
use crate::span::apart;
use crate::status::{Done, Status};
use dq8::{DualQuat, Scalar};
use dq8_trajectory::{OwnedTrajectory, Time, TrajectoryError};

/// Poses at times.
struct Known<R> {
    times: *const R,
    poses: *const R,
    count: usize,
}

/// # Safety
/// As for [`Input::slice`], [`Output::slice`] and [`Output::write`].
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
    apart(&[out.span, bad.span], &[times.span, poses.span, at.span])?;
    // SAFETY: promised, and apart.
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
        // There is no pose.
        Err(_) => return Err(Status::Length),
    };
    // SAFETY: promised, and apart.
    unsafe { bad.write(index) };
    Err(status)
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// A trajectory, the unit `poses` at the rising `times`, both `pose_count`, sampled at
            /// the times `at`, `count` of them as of `out`: along one screw from each pose to the
            /// next, by the shorter way. Before the first pose it is that one, and behind the last
            /// one that.
            ///
            /// DQ8_STATUS_TIMES if a time is not later than the one before or not finite,
            /// DQ8_STATUS_NOT_FINITE if one to sample at is NaN; `bad_time`, which may be null, is
            /// set to it. DQ8_STATUS_LENGTH if there is no pose.
            resample(
                times: *const $R, poses: *const $R, pose_count: usize, at: *const $R, out: *mut $R,
                count: usize, bad_time: *mut usize,
            ) = super::resample(Known { times, poses, count: pose_count }, at, out, count, bad_time)
        }
    };
}
for_both_numbers!(functions);
