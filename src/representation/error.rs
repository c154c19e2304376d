//! [`OrthonormalError`]: a matrix near no rotation.

use core::fmt;

/// A 3×3 matrix that has no nearest rotation, or many.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum OrthonormalError {
    /// An element is not finite, or one of the stretch overflows.
    NotFinite {
        /// The row of the element.
        row: usize,
        /// Its column; 3 is the translation.
        column: usize,
        /// The element.
        value: f64,
    },
    /// A column lies in the span of those before it, or is zero.
    Dependent {
        /// The column.
        column: usize,
        /// The sine of the angle between it and that span.
        sine: f64,
    },
    /// The matrix mirrors.
    Mirrors {
        /// The determinant of its columns, each divided by its length.
        determinant: f64,
    },
    /// The matrix squeezes space into a line or a point: many rotations are as near.
    Ambiguous {
        /// (σ₂ + σ₃)/(σ₁ + σ₂ + σ₃) of the singular values σ₁ ≥ σ₂ ≥ σ₃.
        gap: f64,
    },
}

impl fmt::Display for OrthonormalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { row, column, value } => {
                write!(f, "not finite: the element in row {row} and column {column} is {value}")
            }
            Self::Dependent { column, sine } => write!(
                f,
                "no rotation: column {column} lies in the span of those before it \
                 (the sine of the angle is {sine})"
            ),
            Self::Mirrors { determinant } => {
                write!(f, "no rotation: the determinant of the normalized columns is {determinant}")
            }
            Self::Ambiguous { gap } => write!(
                f,
                "no nearest rotation: the two smaller singular values are {gap} of the sum of all"
            ),
        }
    }
}

impl core::error::Error for OrthonormalError {}
