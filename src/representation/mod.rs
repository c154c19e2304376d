//! Other representations of rotations and rigid motions, and what more than a motion a matrix can
//! hold.
//!
//! A unit quaternion is the middle of all of them. Kenwright (§3) compares Euler angles, axis and
//! angle, matrices, and quaternions with a translation; each is one call away from [`Quat`] or
//! [`DualQuat`], so any two are two calls apart:
//!
//! | representation | to a quaternion or motion | back |
//! |---|---|---|
//! | Euler angles, 24 orders | [`EulerAngles::to_quat`] | [`Quat::to_euler`] |
//! | axis and angle | [`Quat::from_axis_angle`] | [`Quat::to_axis_angle`] |
//! | directions: coordinate axes, an arc, forward and up | [`Quat::from_rotation_x`], [`Quat::from_rotation_arc`], [`Quat::look_to`] | [`Quat::rotate`] |
//! | axis times angle | [`Quat::from_scaled_axis`] | [`Quat::to_scaled_axis`] |
//! | 3×3 matrix | [`Quat::from_matrix3`], [`Quat::try_from_matrix3`], [`Polar`] | [`Quat::to_matrix3`] |
//! | 3×4, 4×4 matrix | [`DualQuat::from_matrix3x4`], [`DualQuat::try_from_matrix4`] | [`DualQuat::to_matrix3x4`], [`DualQuat::to_matrix4`] |
//! | rotation and translation | `DualQuat::from(`[`RotationTranslation`]`)` | `RotationTranslation::from` |
//! | affine map | [`Affine::try_decompose`] | [`Affine::from_motion`] |
//!
//! Lanes, in [`batch`](crate::batch), have axis and angle, coordinate axes, arcs and matrices under
//! the same names, or under ones that end in `_checked` where there is an error here.

mod affine;
mod axis_angle;
mod directions;
mod error;
mod euler_angles;
mod euler_order;
mod gram_schmidt;
pub(crate) mod polar;
mod rotation_translation;
mod shorthand;
mod symmetric;

pub use affine::Affine;
pub use error::OrthonormalError;
pub use euler_angles::{EulerAngles, EulerSolution};
pub use euler_order::{EulerAxes, EulerFrame, EulerOrder};
pub use gram_schmidt::gram_schmidt;
pub use polar::Polar;
pub use rotation_translation::RotationTranslation;

#[cfg(doc)]
use crate::{DualQuat, Quat};
