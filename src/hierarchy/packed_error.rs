//! [`PackedError`]: what packed clips cannot hold, and bytes that are none.

use crate::storage::shape::ShapeError;
use core::fmt;

/// Frames that packed clips cannot hold, or bytes that are no packed clips.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum PackedError {
    /// Frames that do not fit the joints.
    Shape(ShapeError),
    /// A rotation that is not unit, or not finite.
    NotUnit {
        /// The clip.
        clip: usize,
        /// The frame.
        frame: usize,
        /// The joint.
        joint: usize,
        /// The length of its quaternion.
        length: f64,
    },
    /// A rotation too far from that of the frame before: it must turn by less than 60°.
    TooFar {
        /// The clip.
        clip: usize,
        /// The frame.
        frame: usize,
        /// The joint.
        joint: usize,
        /// By how much it turns.
        degrees: f64,
    },
    /// A translation whose numbers are not finite, or differ from those of other frames by more than `f32` holds.
    Beyond {
        /// The clip.
        clip: usize,
        /// The frame.
        frame: usize,
        /// The joint.
        joint: usize,
        /// The number.
        value: f32,
    },
    /// More keys than 32 bits count, or more tracks than 15.
    TooLarge,
    /// Bytes that are no packed clips of this version.
    Bytes {
        /// Where the first of them is that is wrong.
        offset: usize,
        /// What is wrong.
        what: &'static str,
    },
}

impl fmt::Display for PackedError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shape(error) => error.fmt(f),
            Self::NotUnit { clip, frame, joint, length } => write!(
                f,
                "joint {joint} in frame {frame} of clip {clip} has a rotation of length {length}, not 1"
            ),
            Self::TooFar { clip, frame, joint, degrees } => write!(
                f,
                "joint {joint} turns by {degrees:.1}° to frame {frame} of clip {clip}, which must be less than 60° (more \
                 frames a second make it less)"
            ),
            Self::Beyond { clip, frame, joint, value } => write!(
                f,
                "joint {joint} in frame {frame} of clip {clip} is at {value}, which no range of translations holds"
            ),
            Self::TooLarge => f.write_str(
                "the clips have more keys than 32 bits count, or more tracks than 15 bits",
            ),
            Self::Bytes { offset, what } => {
                write!(f, "these are no packed clips: {what}, at byte {offset}")
            }
        }
    }
}

impl core::error::Error for PackedError {}

impl From<ShapeError> for PackedError {
    fn from(error: ShapeError) -> Self {
        Self::Shape(error)
    }
}
