//! Trajectories: poses at times, sampled at other times; points that are each moved by the pose at
//! their own time; splines.

use crate::memory::{Input, Output, from_to, read};
use crate::span::{Span, disjoint};
use crate::status::{Done, Status};
use dq8::{DualQuat, Scalar, Twist};
use dq8_trajectory::{
    Basis, Frame, Job, Outside, OwnedTrajectory, Spline, Time, Trajectory, TrajectoryError,
};

/// The clock of the times, the frame that results come out in, and what is outside the stamps.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// The time t is the stamp origin + unit * t, in seconds; 0 and 1 for times in seconds.
    pub origin: f64,
    /// The seconds of a unit of the times, such as 1e-9.
    pub unit: f64,
    /// Before the first stamp and after the last one: 0 if the body stands there, 1 if it goes on
    /// as it moved there, 2 if such a time is refused.
    pub outside: i32,
    /// 0: the world. 1: the body at the first stamp, 2: at the last one, 3: at `time`. 4: a frame
    /// with the pose `pose`.
    pub frame: i32,
    /// In seconds, on the clock of the stamps.
    pub time: f64,
    /// Unit, in the world.
    pub pose: [f64; 8],
}

/// The status of an error, and the index that it names.
fn fault(error: TrajectoryError) -> (Status, Option<usize>) {
    match error {
        TrajectoryError::NotRising { index, .. } => (Status::Times, Some(index)),
        TrajectoryError::Outside { index, .. } => (Status::Outside, Some(index)),
        TrajectoryError::ControlPose { index } => (Status::NotFinite, Some(index)),
        TrajectoryError::NoFrame { .. } => (Status::Outside, None),
        TrajectoryError::Interval { .. } => (Status::Times, None),
        TrajectoryError::Clock { .. } => (Status::NotFinite, None),
        // There is no pose, or one where more are needed.
        _ => (Status::Length, None),
    }
}

/// The place of the index that an error names.
struct Bad(Output<usize>);

impl Bad {
    /// # Safety
    /// The caller must keep the conditions of [`Output::write`].
    unsafe fn tell(&self, (status, index): (Status, Option<usize>)) -> Status {
        if let Some(index) = index {
            // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the
            // functions called here.
            unsafe { self.0.write(index) };
        }
        status
    }
}

/// # Safety
/// The options are there, or null.
unsafe fn of<P: Copy>(options: *const Options, job: Job<P>) -> Result<Job<P>, Status> {
    if options.is_null() {
        return Ok(job);
    }
    // SAFETY: the caller keeps the conditions under `# Safety`, which are those of the functions
    // called here.
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

/// Poses at stamps, or control poses.
pub(crate) struct Known<R> {
    stamps: *const R,
    poses: *const R,
    count: usize,
}

/// Times, and what goes with them.
struct At {
    options: *const Options,
    times: *const f64,
    count: usize,
    bad: *mut usize,
}

/// # Safety
/// The caller must keep the conditions of [`Input::slice`], [`Output::slice`] and
/// [`Output::write`].
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
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
    let (times, poses, at, out) =
        unsafe { (times.slice(), poses.slice(), at.slice(), out.slice()) };
    let stamps = times.iter().map(|&time| time.into()).collect();
    let poses = poses.iter().map(|pose| DualQuat::from_array(pose.to_array().map(Into::into)));
    let path = OwnedTrajectory::new(stamps, poses.collect()).map_err(fault);
    let path = path.and_then(|path| match at.iter().position(|time| time.is_nan()) {
        Some(index) => Err((Status::NotFinite, Some(index))),
        None => Ok(path),
    });
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
    let path = path.map_err(|fault| unsafe { bad.tell(fault) })?;
    path.job().sample(at, out).map_err(|error| fault(error).0)
}

/// # Safety
/// The caller must keep the conditions of [`Input::slice`], [`Output::slice`] and
/// [`Output::write`].
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
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
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
/// The caller must keep the conditions of [`Input::slice`], [`Output::slice`] and
/// [`Output::write`].
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
    // SAFETY: the caller guarantees that the memory is valid, and the outputs are disjoint from the
    // inputs, or `points` and `moved` are the same array.
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

/// Knots: the time of the first one and the interval, in seconds, and the number of a [`Basis`].
struct Knots {
    start: f64,
    every: f64,
    basis: i32,
}

/// # Safety
/// The caller must keep the conditions of [`Input::slice`], [`Output::slice`] and
/// [`Output::write`].
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
    // SAFETY: the caller guarantees that the memory is valid, and the outputs have been checked to
    // overlap nothing.
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
            ) = super::resample(
                Known { stamps: times, poses, count: pose_count }, at, out, count, bad_time,
            )
        }
        export_one! { $R
            /// The unit poses of a trajectory at the `times`, `count` of them as of `out` and of
            /// `twists`, which may be null: the velocities there for one second, in the frame of
            /// the body, angular first. The trajectory has `pose_count` unit `poses` at rising
            /// `stamps` in seconds, and goes along one screw from each to the next, by the shorter
            /// way. `options` may be null: times are seconds, results are in the world, and the
            /// body stands before the first stamp and after the last one.
            ///
            /// DQ8_STATUS_TIMES if a stamp is not later than the one before or not finite,
            /// DQ8_STATUS_OUTSIDE if a time is refused or the frame has none; `bad_time`, which may
            /// be null, is set to the stamp or time. DQ8_STATUS_LENGTH if there is no pose, or one
            /// where the body is to go on. NaN makes NaN of its pose.
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
            /// Points, x y z, that the body of a trajectory measured, each at its own time: moved
            /// into one frame, by the pose at that time. `moved` may be `points`. A scan is thereby
            /// as if it had been measured at one moment. Trajectory, options and errors are those
            /// of dq8_trajectory_sample.
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
            /// The inverse of dq8_trajectory_deskew: points of one frame as the body would have
            /// measured them, each at its own time.
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
            /// A cubic spline at the `times`, `count` of them as of `out` and, each unless it is
            /// null, of `twists` and `accelerations`: velocities for one second in the frame of the
            /// body, angular first, and how fast they change. The spline has `control_count` unit
            /// control poses, four or more: number k at the time start + every * (k - 1), in
            /// seconds. `basis` is 0 for a B-spline, which goes near them, 1 for that of Catmull
            /// and Rom, which goes through all but the first and the last. Options are those of
            /// dq8_trajectory_sample.
            ///
            /// DQ8_STATUS_TIMES if the interval is not positive, DQ8_STATUS_NOT_FINITE if a control
            /// pose is not finite, DQ8_STATUS_OUTSIDE if a time is refused; `bad_index`, which may
            /// be null, is set to the control pose or time. DQ8_STATUS_LENGTH if there are fewer
            /// than four.
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
