//! [`FitError`]: points that do not say how they were moved.

use crate::errors::errors;

errors! {
    /// Points that have no best map, or many.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    FitError {
        /// Slices that go together have different lengths.
        Length {
            what: &'static str = "`moved` or `weights`.",
            found: usize = "Its length.",
            expected: usize = "The number of points."
        }
            => "{what} has the length {found}, for {expected} points";
        /// A coordinate is not finite.
        NotFinite {
            what: &'static str = "`points` or `moved`.",
            index: usize = "The number of the point.",
            value: f64 = "The coordinate."
        }
            => "point {index} of {what} is not finite: a coordinate is {value}";
        /// A weight is negative or not finite.
        Weight { index: usize = "The number of the pair.", value: f64 = "The weight." }
            => "the weight of pair {index} is {value}: it must be finite and not negative";
        /// There is no pair, or all weights are zero.
        Empty => "no pair of points has a weight";
        /// An axis has no direction.
        Axis { length: f64 = "Its length." } => "the axis has no direction: its length is {length}";
        /// Many rotations fit equally well within rounding.
        Ambiguous {
            pairs: usize = "The number of pairs whose weight is not zero.",
            rank: usize = "The rank of Σ w y xᵀ: 0 where one of the sets is in a point, 1 where one is on a line."
        }
            => "{pairs} pairs do not say how the points turned: the rank is {rank}, and many rotations fit equally well";
        /// A square of a distance, or the map itself, overflows.
        Overflow => "the points are too far apart: a square of a distance overflows";
    }
}
