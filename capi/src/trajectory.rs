//! Trajectories: poses at times, sampled at other times.

use crate::memory::{Input, Output};
use crate::span::apart;
use crate::status::{Done, Status};
use dq8::slices::TrajectoryError;
use dq8::{Backend, DualQuat, Scalar};

/// Poses at times.
struct Known<R> {
    times: *const R,
    poses: *const R,
    count: usize,
}

/// # Safety
/// As for [`Input::slice`], [`Output::slice`] and [`Output::write`].
unsafe fn resample<R: Scalar>(
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
    let Err(error) = Backend::best().resample(times, poses, at, out) else { return Ok(()) };
    let (status, index) = match error {
        TrajectoryError::NotRising { index, .. } => (Status::Times, index),
        TrajectoryError::NotATime { index } => (Status::NotFinite, index),
        // There is no pose.
        _ => return Err(Status::Length),
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
