//! Other representations of rotations and motions, on lanes: see [`representation`](crate::representation).
//!
//! What is an error there is a mask here, `failed`, with NaN for numbers; functions that return one have
//! `_checked` at the end of their names, where the reference has `try_` at the beginning.

mod axis_angle;
mod directions;
mod euler_angles;
mod gram_schmidt;
mod rotation_translation;

pub use gram_schmidt::gram_schmidt_checked;
pub use rotation_translation::RotationTranslation;

use super::{Quat, vector};
use dq8_simd::Lanes;

/// A quaternion, NaN where the mask holds.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn quat_without<L: Lanes>(failed: L::Mask, quat: Quat<L>) -> Quat<L> {
    let nan = quat.w().constant(f64::NAN);
    Quat::from_array(vector::select(failed, [nan; 4], quat.to_array()))
}
