//! Other representations of rotations and rigid motions, and affine maps, which also scale, shear
//! and mirror.
//!
//! The unit quaternion connects all of them. Kenwright (§3) compares Euler angles, axis and angle,
//! matrices, and quaternions with a translation. One call converts each of them to [`Quat`] or
//! [`DualQuat`] or back, so two calls convert between any two of them:
//!
//! | representation | to a quaternion or motion | back |
//! |---|---|---|
//! | Euler angles, 24 orders | [`EulerAngles::to_quat`] | [`Quat::to_euler`] |
//! | axis and angle | [`Quat::from_axis_angle`] | [`Quat::to_axis_angle`] |
//! | a coordinate axis | [`Quat::from_rotation_x`] and others | |
//! | an arc, forward and up | [`Quat::from_rotation_arc`], [`Quat::look_to`] | [`Quat::rotate`] |
//! | axis times angle | [`Quat::from_scaled_axis`] | [`Quat::to_scaled_axis`] |
//! | 3×3 matrix, near a rotation | [`Quat::try_from_matrix3`] | [`Quat::to_matrix3`] |
//! | 3×3 matrix, any | [`Polar`] | |
//! | 3×4 matrix | [`DualQuat::try_from_matrix3x4`] | [`DualQuat::to_matrix3x4`] |
//! | 4×4 matrix | [`DualQuat::try_from_matrix4`] | [`DualQuat::to_matrix4`] |
//! | rotation and translation | `DualQuat::from` | [`RotationTranslation`]`::from` |
//! | affine map | [`Affine::try_decompose`] | [`Affine::from_motion`] |
//!
//! The types of lanes in [`batch`](crate::batch) have the operations for axis and angle, coordinate
//! axes, arcs and matrices under the same names. Where an operation here returns an error, the
//! operation on lanes has a name that ends in `_checked`.

mod affine;
mod directions;
mod euler_angles;
pub(crate) mod polar;
mod rotation_translation;
mod shorthand;

pub use affine::Affine;
pub use euler_angles::{EulerAngles, EulerAxes, EulerFrame, EulerOrder, EulerSolution};
pub use polar::{Polar, gram_schmidt};
pub use rotation_translation::RotationTranslation;

use crate::macros::errors;
#[cfg(doc)]
use crate::{DualQuat, Quat};

errors! {
    /// The error of a 3×3 matrix that has no nearest rotation, or many.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    OrthonormalError {
        /// An element of the matrix is not finite, or an element of its stretch (see [`Polar`])
        /// overflows.
        NotFinite {
            /// The row of the element.
            row: usize,
            /// The column of the element; column 3 is the translation.
            column: usize,
            /// The value of the element.
            value: f64,
        } => "not finite: the element in row {row} and column {column} is {value}";
        /// A column is zero, or is a linear combination of the columns before it.
        Dependent {
            /// The index of the column.
            column: usize,
            /// The sine of the angle between the column and the span of the columns before it.
            sine: f64,
        } => "no rotation: column {column} lies in the span of those before it (the sine of the angle is {sine})";
        /// The matrix mirrors: its determinant is negative.
        Mirrors {
            /// The determinant of the matrix after each column is divided by its length.
            determinant: f64,
        } => "no rotation: the determinant of the normalized columns is {determinant}";
        /// The matrix squeezes space into a line or a point, so many rotations are equally near.
        Ambiguous {
            /// The ratio (σ₂ + σ₃)/(σ₁ + σ₂ + σ₃) of the singular values σ₁ ≥
            /// σ₂ ≥ σ₃.
            gap: f64,
        } => "no nearest rotation: the two smaller singular values are {gap} of the sum of all";
    }
}
