//! Trajectories: functions that sample poses at stamps, or splines, at other times, and functions
//! that move each point by the pose at its own time.

use crate::memory::{Input, Output, from_to, read};
use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use dq8::{DualQuat, Scalar, Twist};
use dq8_trajectory::{
    Basis, Frame, Job, Outside, OwnedTrajectory, Spline, Time, Trajectory, TrajectoryError,
};

/// The options of a trajectory: the clock of the times, the poses outside of the stamps, and the
/// frame of the results.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// The stamp, in seconds, of the time 0. A time t is at the stamp origin + unit * t. It is 0 if
    /// times are on the clock of the stamps.
    pub origin: f64,
    /// The seconds in one unit of the times: 1 for times in seconds, and 1e-9 for nanoseconds.
    pub unit: f64,
    /// The pose before the first stamp and after the last stamp. 0: the moving body stands still at
    /// the first or last pose. 1: it goes on as it moves between the first two or the last two
    /// poses. 2: a time before the first or after the last stamp is an error.
    pub outside: i32,
    /// The frame of the results. 0: the world. 1: the frame of the moving body at the first stamp.
    /// 2: its frame at the last stamp. 3: its frame at `time`. 4: a frame whose pose in the world
    /// is `pose`.
    pub frame: i32,
    /// The time whose pose is the frame, if `frame` is 3: in seconds, on the same clock as the
    /// stamps of the trajectory.
    pub time: f64,
    /// If `frame` is 4, the pose of the frame in the world, a unit motion.
    pub pose: [f64; 8],
}

/// Returns the status of an error, and the index that the error names, if it names an index.
fn fault(error: TrajectoryError) -> (Status, Option<usize>) {
    match error {
        TrajectoryError::NotRising { index, .. } => (Status::Times, Some(index)),
        TrajectoryError::Outside { index, .. } => (Status::Outside, Some(index)),
        TrajectoryError::ControlPose { index } => (Status::NotFinite, Some(index)),
        TrajectoryError::NoFrame { .. } => (Status::Outside, None),
        TrajectoryError::Interval { .. } => (Status::Times, None),
        TrajectoryError::Clock { .. } => (Status::NotFinite, None),
        // All arrays of times have one length here, so the poses are what is wrong.
        _ => (Status::FewPoses, None),
    }
}

/// The output for the index that an error names. It is empty if C passes null.
struct Bad(Output<usize>);

impl Bad {
    /// # Safety
    /// The output must be empty, or point to a `usize` that no other code uses.
    unsafe fn tell(&self, (status, index): (Status, Option<usize>)) -> Status {
        if let Some(index) = index {
            // SAFETY: the caller guarantees that the output is empty, or points to a `usize` that
            // no other code uses.
            unsafe { self.0.write(index) };
        }
        status
    }
}

/// # Safety
/// `options` must be null or point to options that no other thread writes during the call.
unsafe fn of<P: Copy>(options: *const Options, job: Job<P>) -> Result<Job<P>, Status> {
    if options.is_null() {
        return Ok(job);
    }
    // SAFETY: `options` is not null, so the caller guarantees that it points to options that no
    // other thread writes.
    let options: Options = unsafe { read(options)? };
    let outside = match options.outside {
        0 => Outside::Hold,
        1 => Outside::Continue,
        2 => Outside::Refuse,
        _ => return Err(Status::UnknownValue),
    };
    let frame = match options.frame {
        0 => Frame::World,
        1 => Frame::Start,
        2 => Frame::End,
        3 => Frame::At(options.time),
        4 => Frame::Pose(DualQuat::from_array(options.pose)),
        _ => return Err(Status::UnknownValue),
    };
    Ok(job.clock(options.origin, options.unit).outside(outside).frame(frame))
}

/// The arrays of `count` stamps and poses of a trajectory, as C passes them.
pub(crate) struct Known<R> {
    stamps: *const R,
    poses: *const R,
    count: usize,
}

/// The array of `count` times, with the options, and the output for the index of a wrong input.
struct At {
    options: *const Options,
    times: *const f64,
    count: usize,
    bad: *mut usize,
}

/// # Safety
/// Each array must have as many elements as its count says, and pointers that may be null must be
/// null or point to their element. No other thread may use the outputs or write the inputs during
/// the call.
unsafe fn resample<R: Scalar + Time>(
    known: Known<R>,
    at: *const R,
    out: *mut R,
    count: usize,
    bad_time: *mut usize,
) -> Done {
    let times = Input::<R>::new(known.stamps, known.count)?;
    let poses = Input::<DualQuat<R>>::new(known.poses, known.count)?;
    let at = Input::<R>::new(at, count)?;
    let out = Output::<DualQuat<R>>::new(out, count)?;
    let bad = Bad(Output::unless_null(bad_time)?);
    disjoint(&[out.span, bad.0.span], &[times.span, poses.span, at.span])?;
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that no output overlaps another array.
    let (times, poses, at, out) =
        unsafe { (times.slice(), poses.slice(), at.slice(), out.slice()) };
    let stamps = times.iter().map(|&time| time.into()).collect();
    let poses = poses.iter().map(|pose| DualQuat::from_array(pose.to_array().map(Into::into)));
    let path = OwnedTrajectory::new(stamps, poses.collect()).map_err(fault);
    let path = path.and_then(|path| match at.iter().position(|time| time.is_nan()) {
        Some(index) => Err((Status::NotFinite, Some(index))),
        None => Ok(path),
    });
    // SAFETY: the caller guarantees that `bad_time` is null or points to a `usize`, and `disjoint`
    // has checked that it overlaps no other array.
    let path = path.map_err(|fault| unsafe { bad.tell(fault) })?;
    path.job().sample(at, out).map_err(|error| fault(error).0)
}

/// # Safety
/// Each array must have as many elements as its count says, and pointers that may be null must be
/// null or point to their element. No other thread may use the outputs or write the inputs during
/// the call.
unsafe fn sample<R: Scalar>(known: Known<f64>, at: At, out: *mut R, twists: *mut R) -> Done {
    let stamps = Input::<f64>::new(known.stamps, known.count)?;
    let poses = Input::<DualQuat<f64>>::new(known.poses, known.count)?;
    let times = Input::<f64>::new(at.times, at.count)?;
    let options = Span::of(at.options, usize::from(!at.options.is_null()))?;
    let out = Output::<DualQuat<R>>::new(out, at.count)?;
    let wanted = if twists.is_null() { 0 } else { at.count };
    let twists = Output::<Twist<R>>::new(twists, wanted)?;
    let bad = Bad(Output::unless_null(at.bad)?);
    let outputs = [out.span, twists.span, bad.0.span];
    disjoint(&outputs, &[stamps.span, poses.span, times.span, options])?;
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that no output overlaps another array.
    unsafe {
        let path = Trajectory::new(stamps.slice(), poses.slice());
        let job = of(at.options, path.map_err(|error| bad.tell(fault(error)))?.job())?;
        let done = if wanted == 0 {
            job.sample(times.slice(), out.slice())
        } else {
            job.sample_with_twists(times.slice(), out.slice(), twists.slice())
        };
        done.map_err(|error| bad.tell(fault(error)))
    }
}

/// # Safety
/// Each array must have as many elements as its count says, and pointers that may be null must be
/// null or point to their element. No other thread may use the outputs or write the inputs during
/// the call.
unsafe fn moved<R: Scalar, const BACK: bool>(
    known: Known<f64>,
    at: At,
    points: *const R,
    moved: *mut R,
) -> Done {
    let stamps = Input::<f64>::new(known.stamps, known.count)?;
    let poses = Input::<DualQuat<f64>>::new(known.poses, known.count)?;
    let times = Input::<f64>::new(at.times, at.count)?;
    let options = Span::of(at.options, usize::from(!at.options.is_null()))?;
    let out = Output::<[R; 3]>::new(moved, at.count)?;
    let cloud = Input::<[R; 3]>::new(points, at.count)?;
    let bad = Bad(Output::unless_null(at.bad)?);
    disjoint(&[out.span, bad.0.span], &[stamps.span, poses.span, times.span, options])?;
    disjoint(&[bad.0.span], &[cloud.span])?;
    // SAFETY: the caller guarantees that each array has as many elements as its count says.
    // `disjoint` has checked all pairs of arrays for overlaps except `points` and `moved`, which
    // `from_to` checks.
    unsafe {
        let path = Trajectory::new(stamps.slice(), poses.slice());
        let path = path.map_err(|error| bad.tell(fault(error)))?;
        let (job, times) = (of(at.options, path.job())?, times.slice());
        let told = |error| bad.tell(fault(error));
        from_to(
            points,
            moved,
            at.count,
            |points: &[[R; 3]], moved: &mut [[R; 3]]| {
                let done = if BACK {
                    job.skew(times, points, moved)
                } else {
                    job.deskew(times, points, moved)
                };
                done.map_err(told)
            },
            |points: &mut [[R; 3]]| {
                let done = if BACK {
                    job.skew_in_place(times, points)
                } else {
                    job.deskew_in_place(times, points)
                };
                done.map_err(told)
            },
        )
    }
}

/// The knots of a spline: the time of the first knot and the interval, in seconds, and the integer
/// by which C names a [`Basis`].
struct Knots {
    start: f64,
    every: f64,
    basis: i32,
}

/// # Safety
/// Each array must have as many elements as its count says, and pointers that may be null must be
/// null or point to their element. No other thread may use the outputs or write the inputs during
/// the call.
unsafe fn spline<R: Scalar>(
    (control, control_count): (*const f64, usize),
    knots: Knots,
    at: At,
    out: *mut R,
    [twists, accelerations]: [*mut R; 2],
) -> Done {
    let control = Input::<DualQuat<f64>>::new(control, control_count)?;
    let times = Input::<f64>::new(at.times, at.count)?;
    let options = Span::of(at.options, usize::from(!at.options.is_null()))?;
    let out = Output::<DualQuat<R>>::new(out, at.count)?;
    let wanted = |to: *mut R| if to.is_null() { 0 } else { at.count };
    let to_twists = Output::<Twist<R>>::new(twists, wanted(twists))?;
    let to_accelerations = Output::<Twist<R>>::new(accelerations, wanted(accelerations))?;
    let bad = Bad(Output::unless_null(at.bad)?);
    let outputs = [out.span, to_twists.span, to_accelerations.span, bad.0.span];
    disjoint(&outputs, &[control.span, times.span, options])?;
    let basis = match knots.basis {
        0 => Basis::Smooth,
        1 => Basis::Through,
        _ => return Err(Status::UnknownValue),
    };
    // SAFETY: the caller guarantees that each array has as many elements as its count says, and
    // `disjoint` has checked that no output overlaps another array.
    unsafe {
        let spline = Spline::new(knots.start, knots.every, control.slice(), basis);
        let spline = spline.map_err(|error| bad.tell(fault(error)))?;
        let (job, times) = (of(at.options, spline.job())?, times.slice());
        let done = match (wanted(twists), wanted(accelerations)) {
            (0, 0) => job.sample(times, out.slice()),
            (_, 0) => job.sample_with_twists(times, out.slice(), to_twists.slice()),
            (0, _) => {
                let mut twists = vec![Twist::ZERO; times.len()];
                let to = to_accelerations.slice();
                job.sample_with_accelerations(times, out.slice(), &mut twists, to)
            }
            _ => {
                let (twists, to) = (to_twists.slice(), to_accelerations.slice());
                job.sample_with_accelerations(times, out.slice(), twists, to)
            }
        };
        done.map_err(|error| bad.tell(fault(error)))
    }
}

macro_rules! functions {
    ($R:ident $lanes:tt) => {
        export_one! { $R
            /// Samples a trajectory at other times. `times` and `poses` hold `pose_count` rising
            /// times and the unit poses at these times. `at` holds `count` times, and `out` gets
            /// the poses at them. The trajectory moves along one screw from each pose to the next,
            /// by the shorter way. Before the first time it stays at the first pose, and after the
            /// last time at the last pose.
            ///
            /// Returns DQ8_STATUS_TIMES if an element of `times` is not finite or not later than
            /// the element before it, and DQ8_STATUS_NOT_FINITE if an element of `at` is NaN. In
            /// both cases it sets `bad_time`, which may be null, to the index of the element.
            /// Returns DQ8_STATUS_FEW_POSES if there is no pose.
            resample(
                times: *const $R, poses: *const $R, pose_count: usize, at: *const $R, out: *mut $R,
                count: usize, bad_time: *mut usize,
            ) = super::resample(
                Known { stamps: times, poses, count: pose_count }, at, out, count, bad_time,
            )
        }
        export_one! { $R
            /// Samples the poses and velocities of a trajectory at `count` times. The trajectory
            /// has `pose_count` unit `poses` at rising `stamps` in seconds, and moves along one
            /// screw from each pose to the next, by the shorter way. `out` gets the pose at each of
            /// the `times`. `twists`, which may be null, gets the body twist at each time: angular
            /// x y z, then linear x y z, per second. If `options` is null, times are in seconds,
            /// results are in the world, and the moving body stands still before the first stamp
            /// and after the last stamp.
            ///
            /// Returns DQ8_STATUS_TIMES if a stamp is not finite or not later than the stamp before
            /// it, and DQ8_STATUS_OUTSIDE if the options refuse a time or the time of the frame. It
            /// sets `bad_time`, which may be null, to the index of the stamp or time. Returns
            /// DQ8_STATUS_FEW_POSES if there is no pose, or if there is only one pose and `outside`
            /// is 1. The pose at a time that is NaN is NaN.
            trajectory::sample(
                stamps: *const f64, poses: *const f64, pose_count: usize, options: *const Options,
                times: *const f64, out: *mut $R, twists: *mut $R, count: usize,
                bad_time: *mut usize,
            ) = super::sample(
                Known { stamps, poses, count: pose_count },
                At { options, times, count, bad: bad_time },
                out,
                twists,
            )
        }
        export_one! { $R
            /// Moves points, which a moving body has measured, into one frame. The body measured
            /// point i (x, y, z) in its own frame at `times[i]`, and the pose of the trajectory at
            /// this time moves the point. The field `frame` of the options selects the frame of the
            /// results. The result is a scan as if it had been measured at one moment. `moved` may
            /// be `points`. Trajectory, options and errors are those of dq8_trajectory_sample.
            trajectory::deskew(
                stamps: *const f64, poses: *const f64, pose_count: usize, options: *const Options,
                times: *const f64, points: *const $R, moved: *mut $R, count: usize,
                bad_time: *mut usize,
            ) = super::moved::<$R, false>(
                Known { stamps, poses, count: pose_count },
                At { options, times, count, bad: bad_time },
                points,
                moved,
            )
        }
        export_one! { $R
            /// Computes the inverse of dq8_trajectory_deskew: moves points of one frame into the
            /// frame of the body, in which it would have measured point i at `times[i]`.
            trajectory::skew(
                stamps: *const f64, poses: *const f64, pose_count: usize, options: *const Options,
                times: *const f64, points: *const $R, moved: *mut $R, count: usize,
                bad_time: *mut usize,
            ) = super::moved::<$R, true>(
                Known { stamps, poses, count: pose_count },
                At { options, times, count, bad: bad_time },
                points,
                moved,
            )
        }
        export_one! { $R
            /// Samples the poses of a cubic spline, and its twists, at `count` times. `out` gets
            /// the pose at each of the `times`. `twists` gets the body twist at this time: angular
            /// x y z, then linear x y z, per second. `accelerations` gets the derivative of the
            /// body twist with respect to time. Either may be null. The spline has `control_count`
            /// unit control poses, four or more. Control pose k belongs to the time start + every *
            /// (k - 1), in seconds. `basis` is 0 for a B-spline, which passes near the control
            /// poses, and 1 for a Catmull-Rom spline, which passes through all control poses but
            /// the first and the last. Options are those of dq8_trajectory_sample.
            ///
            /// Returns DQ8_STATUS_TIMES if the interval is not positive, DQ8_STATUS_NOT_FINITE if a
            /// control pose is not finite, and DQ8_STATUS_OUTSIDE if the options refuse a time. It
            /// sets `bad_index`, which may be null, to the index of the control pose or time.
            /// Returns DQ8_STATUS_FEW_POSES if there are fewer than four control poses.
            spline::poses(
                control: *const f64, control_count: usize, start: f64, every: f64, basis: i32,
                options: *const Options, times: *const f64, out: *mut $R, twists: *mut $R,
                accelerations: *mut $R, count: usize, bad_index: *mut usize,
            ) = super::spline(
                (control, control_count),
                Knots { start, every, basis },
                At { options, times, count, bad: bad_index },
                out,
                [twists, accelerations],
            )
        }
    };
}
for_both_numbers!(functions);
