//! Lines, planes and points together: which pass through which, and how far apart they are.
//!
//! Directions and normals may have any length but zero; what is returned has length 1. Numbers may
//! be of any size as long as the answer is finite: no square of a coordinate is taken.
//!
//! Two directions whose sine is at most eight units of roundoff are parallel, and so are treated:
//! the rounding of unit vectors alone makes such a sine, and an answer divided by it would be
//! noise.

mod line;
mod plane;

pub use line::CommonPerpendicular;

use crate::macros::errors;
use crate::number::Real;
use crate::scalar::vector::{self, Length};

errors! {
    /// Points, lines and planes that do not determine the result.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    IncidenceError {
        /// A vector whose direction is needed is zero, or its length is not finite.
        NoDirection {
            /// The name of the vector.
            what: &'static str,
            /// Its length.
            length: f64,
        } => "{what} has no direction: its length is {length}";
        /// A number given is not finite, or the one asked for would not be.
        NotFinite {
            /// The name of the number.
            what: &'static str,
            /// Its value.
            value: f64,
        } => "{what} is {value}";
        /// Three points lie on one line: through it go many planes.
        Collinear {
            /// The sine of the angle at the first point.
            sine: f64,
        } => "the three points are on one line: the sine of their angle is {sine}";
        /// A point lies on a line, within rounding: through both go many planes.
        PointOnLine {
            /// The distance of the two.
            distance: f64,
        } => "the point is on the line, {distance} from it";
        /// Two planes are parallel, or the same.
        ParallelPlanes {
            /// The sine of the angle between them.
            sine: f64,
        } => "the planes are parallel: the sine of their angle is {sine}";
        /// A line is parallel to a plane, or lies in it.
        ParallelToPlane {
            /// The distance of the line, positive on the side of the normal.
            distance: f64,
        } => "the line is parallel to the plane, {distance} from it";
        /// Two lines are parallel, or the same.
        ParallelLines {
            /// Their distance.
            distance: f64,
        } => "the lines are parallel, {distance} apart";
        /// Two lines pass each other.
        SkewLines {
            /// Their distance.
            distance: f64,
        } => "the lines do not meet: they are {distance} apart";
    }
}

/// Eight units of roundoff: two of each direction, doubled.
fn parallel_sine<R: Real>() -> R {
    R::EPSILON * R::from(4.0)
}

/// The vector with length 1, and the length that it had.
fn unit<R: Real>(
    vector: [R; 3],
    what: &'static str,
) -> Result<([R; 3], Length<R>), IncidenceError> {
    let norm = vector::norm(vector);
    if norm > R::ZERO && vector.iter().all(|c| c.is_finite()) {
        let length = Length::of(vector, norm);
        Ok((length.divide(vector), length))
    } else {
        Err(IncidenceError::NoDirection { what, length: norm.into() })
    }
}

/// The numbers, if all are finite.
fn finite<R: Real, const N: usize>(
    numbers: [R; N],
    what: &'static str,
) -> Result<[R; N], IncidenceError> {
    match numbers.iter().find(|c| !c.is_finite()) {
        Some(&value) => Err(IncidenceError::NotFinite { what, value: value.into() }),
        None => Ok(numbers),
    }
}

/// The larger of two lengths: what the rounding of a distance is relative to.
fn size<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    vector::norm(a).max_or_nan(vector::norm(b))
}
