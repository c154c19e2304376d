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
        NotRising {
            /// The number of the stamp.
            index: usize,
            /// Its value in seconds.
            value: f64,
        } => "stamp {index} is {value} s: stamps must be finite, and each later than the one before";
        /// A twist or its range of time has no trajectory.
        NotFinite {
            /// The number that is not finite, or too large.
            value: f64,
        } => "{value} cannot be part of a motion at constant velocity";
        /// A time lies before the first stamp or after the last one, or is NaN, and the job refuses
        /// such times.
        Outside {
            /// The number of the time.
            index: usize,
            /// The time in seconds, on the clock of the stamps.
            value: f64,
            /// The first stamp in seconds.
            first: f64,
            /// The last stamp in seconds.
            last: f64,
        } => "time {index} is {value} s, and the stamps go from {first} s to {last} s";
        /// A motion can go on only if there are two poses that say how.
        OnePose => "one pose has no velocity with which it could continue outside its stamp";
        /// The frame was asked for at a time that is not finite, or outside the stamps where that
        /// is refused.
        NoFrame {
            /// The time in seconds.
            time: f64,
        } => "there is no frame at {time} s";
        /// A spline needs four control poses.
        TooFewPoses {
            /// The number of control poses.
            poses: usize,
        } => "{poses} control poses: a spline needs at least four";
        /// A control pose is not finite.
        ControlPose {
            /// The number of the pose.
            index: usize,
        } => "control pose {index} is not finite";
        /// A spline has no such times.
        Interval {
            /// The time of the first knot in seconds.
            start: f64,
            /// The interval of the knots in seconds.
            every: f64,
        } => "knots every {every} s from {start} s on: times must be finite, and the interval positive and larger than their rounding";
        /// The clock has a number that is not finite, or a unit of zero.
        Clock {
            /// The number.
            value: f64,
        } => "the clock has {value}: its origin and unit must be finite, the unit not zero";
    }
}
