//! [`PackedError`]: what packed clips cannot hold, and bytes that are none.

use crate::errors::errors;
use crate::storage::shape::ShapeError;

errors! {
    /// Frames that packed clips cannot hold, or bytes that are no packed clips.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    PackedError {
        /// Frames that do not fit the joints.
        Shape(error: ShapeError) => "{error}";
        /// A rotation that is not unit, or not finite.
        NotUnit {
            clip: usize = "The clip.",
            frame: usize = "The frame.",
            joint: usize = "The joint.",
            length: f64 = "The length of its quaternion."
        }
            => "joint {joint} in frame {frame} of clip {clip} has a rotation of length {length}, not 1";
        /// A clip whose frames a second are no positive number.
        Rate { clip: usize = "The clip.", rate: f64 = "Its frames a second." }
            => "clip {clip} has {rate} frames a second, which must be a positive number that `f32` holds";
        /// A translation whose numbers are not finite, or differ from those of other frames by more
        /// than `f32` holds.
        Beyond {
            clip: usize = "The clip.",
            frame: usize = "The frame.",
            joint: usize = "The joint.",
            value: f32 = "The number."
        }
            => "joint {joint} in frame {frame} of clip {clip} is at {value}, which no range of translations holds";
        /// More keys than 32 bits count, or more tracks than 15 bits.
        TooLarge => "the clips have more keys than 32 bits count, or more tracks than 15 bits";
        /// Bytes that are no packed clips of this version.
        Bytes { offset: usize = "Where the first of them is that is wrong.", what: &'static str = "What is wrong." }
            => "these are no packed clips: {what}, at byte {offset}";
    }
}
