use crate::TrajectoryError;
use alloc::string::String;
use dq8::internal::errors;

errors! {
    /// Frames that make no tree, or a question that they have no answer to. Nothing has been
    /// written.
    #[derive(Clone, Debug, PartialEq)]
    FramesError {
        /// Lengths, a clock or a frame of the job that do not fit.
        Job(error: TrajectoryError) => "{error}";
        /// No edge names this frame.
        Unknown {
            /// The name.
            frame: String,
        } => "there is no frame {frame:?}";
        /// Two edges say where a frame is.
        TwoParents {
            /// Its name.
            frame: String,
        } => "two edges say where the frame {frame:?} is";
        /// A frame lies in itself.
        Loop {
            /// The name of a frame of the loop.
            frame: String,
        } => "the frame {frame:?} lies in itself, by its parents";
        /// A fixed pose is not finite.
        NotFinite {
            /// The frame that it is the pose of.
            frame: String,
        } => "the fixed pose of the frame {frame:?} is not finite";
        /// The frames are of two trees.
        NotConnected {
            /// The frame that poses were asked for in.
            target: String,
            /// The frame that poses were asked for of.
            source: String,
        } => "no edges lead from the frame {source:?} to the frame {target:?}";
        /// A time lies before the first stamp of an edge or after the last one, or is NaN, and the
        /// job refuses such times.
        Outside {
            /// The frame that is at no known pose then.
            frame: String,
            /// The number of the time.
            index: usize,
            /// The time in seconds, on the clock of the stamps.
            value: f64,
            /// The first stamp of that frame in seconds.
            first: f64,
            /// The last one.
            last: f64,
        } => "time {index} is {value} s, and the stamps of the frame {frame:?} go from {first} s to {last} s";
        /// A motion can go on only if there are two poses that say how.
        OnePose {
            /// The frame whose trajectory has one pose.
            frame: String,
        } => "one pose of the frame {frame:?} has no velocity with which it could continue outside its stamp";
    }
}
