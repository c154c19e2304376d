use core::fmt;

/// What [`TwoBone`](crate::ik::TwoBone) cannot bend.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum LimbError {
    /// A bone of negative or infinite length, or NaN.
    Length {
        /// The bone, 0 for the one at the root.
        bone: usize,
        /// Its length.
        value: f64,
    },
    /// A coordinate that is not finite.
    NotFinite {
        /// Of what.
        what: &'static str,
        /// The axis.
        index: usize,
        /// The coordinate.
        value: f64,
    },
}

impl fmt::Display for LimbError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { bone, value } => write!(f, "bone {bone} cannot have the length {value}"),
            Self::NotFinite { what, index, value } => {
                write!(f, "the {what} is not finite: coordinate {index} is {value}")
            }
        }
    }
}

impl core::error::Error for LimbError {}
