use dq8::ShapeError;
use dq8::internal::errors;

errors! {
    /// Stamps, poses, times or points that do not fit together. Nothing has been written.
    #[derive(Clone, Debug, PartialEq)]
    TrajectoryError {
        /// Slices that do not fit each other.
        Shape(error: ShapeError) => "{error}";
        /// A trajectory needs a pose.
        Empty => "a trajectory needs at least one pose";
        /// A stamp is not finite, or not later than the one before.
        NotRising { index: usize = "The number of the stamp.", value: f64 = "Its value in seconds." }
            => "stamp {index} is {value} s: stamps must be finite, and each later than the one before";
        /// A twist or its range of time has no trajectory.
        NotFinite { value: f64 = "The number that is not finite, or too large." }
            => "{value} cannot be part of a motion at constant velocity";
        /// A time lies before the first stamp or after the last one, or is NaN, and the job refuses
        /// such times.
        Outside {
            index: usize = "The number of the time.",
            value: f64 = "The time in seconds, on the clock of the stamps.",
            first: f64 = "The first stamp in seconds.",
            last: f64 = "The last stamp in seconds."
        }
            => "time {index} is {value} s, and the stamps go from {first} s to {last} s";
        /// A motion can go on only if there are two poses that say how.
        OnePose => "one pose has no velocity with which it could continue outside its stamp";
        /// The frame was asked for at a time that is not finite, or outside the stamps where that
        /// is refused.
        NoFrame { time: f64 = "The time in seconds." } => "there is no frame at {time} s";
        /// A spline needs four control poses.
        TooFewPoses { poses: usize = "The number of control poses." } => "{poses} control poses: a spline needs at least four";
        /// A control pose is not finite.
        ControlPose { index: usize = "The number of the pose." } => "control pose {index} is not finite";
        /// A spline has no such times.
        Interval { start: f64 = "The time of the first knot in seconds.", every: f64 = "The interval of the knots in seconds." }
            => "knots every {every} s from {start} s on: times must be finite, and the interval positive and larger than their rounding";
        /// The clock has a number that is not finite, or a unit of zero.
        Clock { value: f64 = "The number." } => "the clock has {value}: its origin and unit must be finite, the unit not zero";
    }
}
