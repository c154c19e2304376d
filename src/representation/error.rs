//! [`OrthonormalError`]: a matrix near no rotation.

use crate::errors::errors;

errors! {
    /// A 3×3 matrix that has no nearest rotation, or many.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    OrthonormalError {
        /// An element is not finite, or one of the stretch overflows.
        NotFinite {
            row: usize = "The row of the element.",
            column: usize = "Its column; 3 is the translation.",
            value: f64 = "The element."
        }
            => "not finite: the element in row {row} and column {column} is {value}";
        /// A column lies in the span of those before it, or is zero.
        Dependent { column: usize = "The column.", sine: f64 = "The sine of the angle between it and that span." }
            => "no rotation: column {column} lies in the span of those before it (the sine of the angle is {sine})";
        /// The matrix mirrors.
        Mirrors { determinant: f64 = "The determinant of its columns, each divided by its length." }
            => "no rotation: the determinant of the normalized columns is {determinant}";
        /// The matrix squeezes space into a line or a point: many rotations are as near.
        Ambiguous { gap: f64 = "(σ₂ + σ₃)/(σ₁ + σ₂ + σ₃) of the singular values σ₁ ≥ σ₂ ≥ σ₃." }
            => "no nearest rotation: the two smaller singular values are {gap} of the sum of all";
    }
}
