//! Lines, planes and points together: joins, intersections and distances.
//!
//! Directions and normals in the input may have any length but zero; in results they have length 1.
//! Coordinates may be of any size as long as the result is finite, because no square of a
//! coordinate is computed.
//!
//! Two directions count as parallel if the sine of their angle is at most eight roundoffs (a
//! roundoff is half of `EPSILON`). The rounding of unit vectors alone can produce such a sine, so a
//! result divided by it would be meaningless.

mod line;
mod plane;

pub use line::CommonPerpendicular;

use crate::macros::errors;
use crate::number::Real;
use crate::scalar::vector::{self, Length};

errors! {
    /// The error of points, lines and planes that do not determine the result.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    IncidenceError {
        /// A vector that must have a direction is zero, or its length is not finite.
        NoDirection {
            /// The name of the vector.
            what: &'static str,
            /// The length of the vector.
            length: f64,
        } => "{what} has no direction: its length is {length}";
        /// A value of the input or of the result is not finite.
        NotFinite {
            /// The name of the value.
            what: &'static str,
            /// The value that is not finite.
            value: f64,
        } => "{what} is {value}";
        /// Three points lie on one line, so many planes contain them.
        Collinear {
            /// The sine of the angle at the first point, between the directions to the other two
            /// points.
            sine: f64,
        } => "the three points are on one line: the sine of their angle is {sine}";
        /// A point lies on a line within rounding, so many planes contain both.
        PointOnLine {
            /// The distance between the point and the line.
            distance: f64,
        } => "the point is on the line, {distance} from it";
        /// Two planes are parallel, or the same.
        ParallelPlanes {
            /// The sine of the angle between the planes.
            sine: f64,
        } => "the planes are parallel: the sine of their angle is {sine}";
        /// A line is parallel to a plane, or lies in it.
        ParallelToPlane {
            /// The distance of the line from the plane, positive on the side of the normal.
            distance: f64,
        } => "the line is parallel to the plane, {distance} from it";
        /// Two lines are parallel, or the same.
        ParallelLines {
            /// The distance between the lines.
            distance: f64,
        } => "the lines are parallel, {distance} apart";
        /// Two lines are skew: they do not intersect and are not parallel.
        SkewLines {
            /// The distance between the lines.
            distance: f64,
        } => "the lines do not meet: they are {distance} apart";
    }
}

/// Returns eight roundoffs: each of the two directions has an error of two roundoffs, and the
/// factor two is a margin.
fn parallel_sine<R: Real>() -> R {
    R::EPSILON * R::from(4.0)
}

/// Returns the vector scaled to length 1, and the length that it had.
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

/// Returns the values if all of them are finite.
fn finite<R: Real, const N: usize>(
    numbers: [R; N],
    what: &'static str,
) -> Result<[R; N], IncidenceError> {
    match numbers.iter().find(|c| !c.is_finite()) {
        Some(&value) => Err(IncidenceError::NotFinite { what, value: value.into() }),
        None => Ok(numbers),
    }
}

/// Returns the larger of the lengths of two vectors, to which the rounding error of their distance
/// is proportional.
fn size<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    vector::norm(a).max_or_nan(vector::norm(b))
}
