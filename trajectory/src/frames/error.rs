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
        Unknown { frame: String = "The name." } => "there is no frame {frame:?}";
        /// Two edges say where a frame is.
        TwoParents { frame: String = "Its name." } => "two edges say where the frame {frame:?} is";
        /// A frame lies in itself.
        Loop { frame: String = "The name of a frame of the loop." }
            => "the frame {frame:?} lies in itself, by its parents";
        /// A fixed pose is not finite.
        NotFinite { frame: String = "The frame that it is the pose of." }
            => "the fixed pose of the frame {frame:?} is not finite";
        /// The frames are of two trees.
        NotConnected {
            target: String = "The frame that poses were asked for in.",
            source: String = "The frame that poses were asked for of."
        }
            => "no edges lead from the frame {source:?} to the frame {target:?}";
        /// A time lies before the first stamp of an edge or after the last one, or is NaN, and the
        /// job refuses such times.
        Outside {
            frame: String = "The frame that is at no known pose then.",
            index: usize = "The number of the time.",
            value: f64 = "The time in seconds, on the clock of the stamps.",
            first: f64 = "The first stamp of that frame in seconds.",
            last: f64 = "The last one."
        }
            => "time {index} is {value} s, and the stamps of the frame {frame:?} go from {first} s to {last} s";
        /// A motion can go on only if there are two poses that say how.
        OnePose { frame: String = "The frame whose trajectory has one pose." }
            => "one pose of the frame {frame:?} has no velocity with which it could continue outside its stamp";
    }
}
