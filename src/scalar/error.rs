//! [`NormalizeError`], [`InverseError`] and [`MatrixError`], the errors of operations on motions
//! that have no result.

use crate::macros::errors;
use core::fmt;

/// The error of a quaternion or dual quaternion that cannot be normalized. The quaternion, or the
/// real part of the dual quaternion, is zero, or a component of the input or of the result is not
/// finite.
///
/// Fabisch (*Normalizing Dual Quaternions*, "Edge Case") leaves this case out and says that the
/// solution "would be to set p = 1 and proceed", which would turn bad input into a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct NormalizeError {
    /// The norm of the real part, or of the whole quaternion.
    pub real_norm: f64,
    pub(super) of: Normed,
}

impl fmt::Display for NormalizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("cannot normalize: ")?;
        self.of.write(self.real_norm, f)
    }
}

impl core::error::Error for NormalizeError {}

/// The error of a dual quaternion or dual number without an inverse. Its real part is zero, or a
/// component of the input or of the inverse is not finite.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct InverseError {
    /// The norm of the real part, or its absolute value for a dual number.
    pub real_norm: f64,
    pub(super) of: Normed,
}

impl fmt::Display for InverseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("no inverse: ")?;
        self.of.write(self.real_norm, f)
    }
}

impl core::error::Error for InverseError {}

/// The type whose norm the error reports.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) enum Normed {
    Quaternion,
    DualQuaternion,
    DualNumber,
}

impl Normed {
    /// Writes the reason of the error. If the norm is neither zero nor infinite, the dual part is
    /// the reason.
    fn write(self, norm: f64, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = match self {
            Self::Quaternion => "norm of the quaternion",
            Self::DualQuaternion => "norm of the real part",
            Self::DualNumber => "absolute value of the real part",
        };
        write!(f, "the {part} is {norm}")?;
        if self == Self::DualQuaternion && norm > 0.0 && norm < f64::INFINITY {
            f.write_str(", but a component is not finite, or would not be")?;
        }
        Ok(())
    }
}

errors! {
    /// The error of a matrix that is not a rigid motion.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    MatrixError {
        /// Two rows of the rotation, `row` and `column`, are not orthonormal: their scalar product
        /// is `value`, where the identity has 0 or 1.
        NotOrthonormal {
            /// The first of the two rows.
            row: usize,
            /// The second of the two rows.
            column: usize,
            /// The scalar product of the two rows.
            value: f64,
        } => "not a rotation: the product of rows {row} and {column} is {value} (non-uniform scale and shear are not \
                rigid motions: Affine::try_decompose takes them apart)";
        /// The matrix is a rotation times a factor: it scales equally in every direction.
        Scales {
            /// The factor, negative if the matrix mirrors as well.
            factor: f64,
        } => "not a rotation: the matrix scales by {factor}, which no motion does \
                (Affine::try_decompose takes the scale and the motion apart)";
        /// The rotation mirrors: its determinant is negative.
        Mirrors {
            /// The determinant.
            determinant: f64,
        } => "not a rotation: the determinant is {determinant}";
        /// An element of the translation is not finite.
        NotFinite {
            /// The row of the element.
            row: usize,
            /// The value of the element.
            value: f64,
        } => "the translation is not finite: element {row} is {value}";
        /// The last row of a 4×4 matrix is not 0 0 0 1.
        NotAffine {
            /// The column of the element that differs.
            column: usize,
            /// The value of the element.
            value: f64,
        } => "not affine: element {column} of the last row is {value}, which must be 0 0 0 1 (a matrix given by \
                columns, as by glam, nalgebra and glTF, is for try_from_cols_array_2d)";
    }
}
