//! [`IncidenceError`]: what does not determine the result.

use core::fmt;

/// Points, lines and planes that do not determine the result.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum IncidenceError {
    /// A vector whose direction is needed is zero, or its length is not finite.
    NoDirection {
        /// The name of the vector.
        what: &'static str,
        /// Its length.
        length: f64,
    },
    /// A number given is not finite, or the one asked for would not be.
    NotFinite {
        /// The name of the number.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// Three points lie on one line: through it go many planes.
    Collinear {
        /// The sine of the angle at the first point.
        sine: f64,
    },
    /// A point lies on a line, within rounding: through both go many planes.
    PointOnLine {
        /// The distance of the two.
        distance: f64,
    },
    /// Two planes are parallel, or the same.
    ParallelPlanes {
        /// The sine of the angle between them.
        sine: f64,
    },
    /// A line is parallel to a plane, or lies in it.
    ParallelToPlane {
        /// The distance of the line, positive on the side of the normal.
        distance: f64,
    },
    /// Two lines are parallel, or the same.
    ParallelLines {
        /// Their distance.
        distance: f64,
    },
    /// Two lines pass each other.
    SkewLines {
        /// Their distance.
        distance: f64,
    },
}

impl fmt::Display for IncidenceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoDirection { what, length } => {
                write!(f, "{what} has no direction: its length is {length}")
            }
            Self::NotFinite { what, value } => write!(f, "{what} is {value}"),
            Self::Collinear { sine } => {
                write!(f, "three points on one line: the sine of their angle is {sine}")
            }
            Self::PointOnLine { distance } => {
                write!(f, "the point is on the line, {distance} from it")
            }
            Self::ParallelPlanes { sine } => {
                write!(f, "the planes are parallel: the sine of their angle is {sine}")
            }
            Self::ParallelToPlane { distance } => {
                write!(f, "the line is parallel to the plane, {distance} from it")
            }
            Self::ParallelLines { distance } => {
                write!(f, "the lines are parallel, {distance} apart")
            }
            Self::SkewLines { distance } => {
                write!(f, "the lines do not meet: they are {distance} apart")
            }
        }
    }
}

impl core::error::Error for IncidenceError {}
