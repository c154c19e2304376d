//! Poses at stamps, points moved by them, and splines.

use crate::argument::{Of, Read, Written, count, names, one_of, passes, reads, writes};
use crate::function::Function;
use crate::shape::Shape;
use dq8::{DualQuat, Twist};
use dq8_capi::Status;
use dq8_capi::trajectory::{Options, double, single};
use dq8_trajectory::{Basis, Frame, Job, Outside, Spline, Trajectory, TrajectoryError};

/// A trajectory in Rust, or the error in its stamps.
type Path<'s> = Result<Trajectory<'s>, TrajectoryError>;

fn options() -> Of<Options, Read> {
    let pose = DualQuat::from_translation([1.0, -2.0, 0.5]).to_array();
    let some = Options { origin: 0.25, unit: 0.5, outside: 1, frame: 3, time: 0.75, pose };
    reads::<Options>(1)
        .unless_null(0)
        .only(move |_| some)
        .fault(Status::UnknownValue, None, |options| options[0].outside = 3)
        .fault(Status::UnknownValue, None, |options| options[0].frame = -1)
        .fault(Status::NotFinite, None, |options| options[0].unit = 0.0)
        .fault(Status::Outside, None, |options| options[0].time = f64::NAN)
}

/// The job that the options of [`options`] are.
fn of<P: Copy>(options: &[Options], job: Job<P>) -> Job<P> {
    let [options] = options else { return job };
    let job = job.clock(options.origin, options.unit).outside(Outside::Continue);
    job.frame(Frame::At(options.time))
}

/// The status of an error that random numbers may cause.
fn status(error: TrajectoryError) -> Status {
    match error {
        TrajectoryError::ControlPose { .. } => Status::NotFinite,
        TrajectoryError::NotRising { .. } | TrajectoryError::Interval { .. } => Status::Times,
        _ => Status::FewPoses,
    }
}

macro_rules! add {
    ($shape:ident $to:ident $R:ident $of:ident) => {{
        let (n, at) = ($shape.times.len(), $shape.count);
        let known = $shape.times.clone();
        let stamps = move || {
            let known = known.clone();
            reads::<f64>(n)
                .only(move |i| known[i])
                .fault(Status::Times, Some(2), |stamps| stamps[2] = stamps[1])
                .fault(Status::Times, Some(1), |stamps| stamps[1] = f64::NAN)
        };
        let path = |stamps, poses| -> Path<'_> { Trajectory::new(stamps, poses) };
        let cloud = |count| -> Of<[$R; 3], Read> { reads(count) };
        let moved = |count| -> Of<[$R; 3], Written> { writes(count) };
        functions! { $to:
            concat!("dq8_trajectory_sample_", stringify!($R)), $of::sample = (
                stamps: stamps(), poses: reads::<DualQuat<f64>>(n),
                pose_count: count(n).wrong(0, Status::FewPoses), options: options(),
                times: reads::<f64>(at), out: writes::<DualQuat<$R>>(at),
                twists: writes::<Twist<$R>>(at).unless_null(1), count: count(at), bad_time: names(),
            ) => {
                let job = of(options, path(stamps, poses).map_err(status)?.job());
                if twists.is_empty() {
                    job.sample(times, out).map_err(status)
                } else {
                    job.sample_with_twists(times, out, twists).map_err(status)
                }
            };
            concat!("dq8_trajectory_deskew_", stringify!($R)), $of::deskew = (
                stamps: stamps(), poses: reads::<DualQuat<f64>>(n),
                pose_count: count(n).wrong(0, Status::FewPoses), options: options(),
                times: reads::<f64>(at), points: cloud(at), moved: moved(at).over("points"),
                count: count(at), bad_time: names(),
            ) => of(options, path(stamps, poses).map_err(status)?.job())
                .deskew(times, points, moved).map_err(status);
            concat!("dq8_trajectory_skew_", stringify!($R)), $of::skew = (
                stamps: stamps(), poses: reads::<DualQuat<f64>>(n),
                pose_count: count(n).wrong(0, Status::FewPoses), options: options(),
                times: reads::<f64>(at), points: cloud(at), moved: moved(at).over("points"),
                count: count(at), bad_time: names(),
            ) => of(options, path(stamps, poses).map_err(status)?.job())
                .skew(times, points, moved).map_err(status);
            concat!("dq8_spline_poses_", stringify!($R)), $of::poses = (
                control: reads::<DualQuat<f64>>(5)
                    .fault(Status::NotFinite, Some(3), |control| control[3] = DualQuat::ZERO.scale(f64::NAN)),
                control_count: count(5).wrong(3, Status::FewPoses), start: passes(0.5),
                every: passes(0.25).wrong(0.0, Status::Times),
                basis: one_of([0, 1]).wrong(2, Status::UnknownValue), options: options(),
                times: reads::<f64>(at), out: writes::<DualQuat<$R>>(at),
                twists: writes::<Twist<$R>>(at).unless_null(1),
                accelerations: writes::<Twist<$R>>(at).unless_null(2), count: count(at), bad_index: names(),
            ) => {
                let basis = if basis == 0 { Basis::Smooth } else { Basis::Through };
                let spline = Spline::new(start, every, control, basis).map_err(status)?;
                let mut others = [(); 2].map(|()| vec![Twist::<$R>::ZERO; times.len()]);
                let [a, b] = &mut others;
                let done = of(options, spline.job()).sample_with_accelerations(times, out, a, b);
                for (to, from) in [(twists, a), (accelerations, b)] {
                    if !to.is_empty() {
                        to.copy_from_slice(from);
                    }
                }
                done.map_err(status)
            };
        }
    }};
}

pub(super) fn add(shape: &Shape, to: &mut Vec<Function>) {
    add!(shape to f32 single);
    add!(shape to f64 double);
}
