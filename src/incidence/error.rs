//! [`IncidenceError`]: what does not determine the result.

use crate::errors::errors;

errors! {
    /// Points, lines and planes that do not determine the result.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    IncidenceError {
        /// A vector whose direction is needed is zero, or its length is not finite.
        NoDirection { what: &'static str = "The name of the vector.", length: f64 = "Its length." }
            => "{what} has no direction: its length is {length}";
        /// A number given is not finite, or the one asked for would not be.
        NotFinite { what: &'static str = "The name of the number.", value: f64 = "Its value." } => "{what} is {value}";
        /// Three points lie on one line: through it go many planes.
        Collinear { sine: f64 = "The sine of the angle at the first point." }
            => "three points on one line: the sine of their angle is {sine}";
        /// A point lies on a line, within rounding: through both go many planes.
        PointOnLine { distance: f64 = "The distance of the two." } => "the point is on the line, {distance} from it";
        /// Two planes are parallel, or the same.
        ParallelPlanes { sine: f64 = "The sine of the angle between them." }
            => "the planes are parallel: the sine of their angle is {sine}";
        /// A line is parallel to a plane, or lies in it.
        ParallelToPlane { distance: f64 = "The distance of the line, positive on the side of the normal." }
            => "the line is parallel to the plane, {distance} from it";
        /// Two lines are parallel, or the same.
        ParallelLines { distance: f64 = "Their distance." } => "the lines are parallel, {distance} apart";
        /// Two lines pass each other.
        SkewLines { distance: f64 = "Their distance." } => "the lines do not meet: they are {distance} apart";
    }
}
