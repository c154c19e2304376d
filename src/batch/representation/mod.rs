//! Other representations of rotations and motions, on lanes: see [`representation`](crate::representation).
//!
//! What is an error there is a mask here, `failed`, with NaN for numbers; functions that return one have
//! `_checked` at the end of their names, where the reference has `try_` at the beginning.

mod affine;
mod axis_angle;
mod directions;
mod euler_angles;
mod gram_schmidt;
mod polar;
mod rotation_translation;
mod symmetric;

pub use affine::Affine;
pub use gram_schmidt::gram_schmidt_checked;
pub use polar::Polar;
pub use rotation_translation::RotationTranslation;

use super::{Quat, vector};
use dq8_simd::Lanes;

/// A 3×3 matrix, NaN where the mask holds.
#[cfg_attr(not(opt_level_0), inline(always))]
fn without<L: Lanes>(failed: L::Mask, mut rows: [[L; 3]; 3]) -> [[L; 3]; 3] {
    let nan = rows[0][0].constant(f64::NAN);
    for row in &mut rows {
        *row = vector::select(failed, [nan; 3], *row);
    }
    rows
}

/// A quaternion, NaN where the mask holds.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn quat_without<L: Lanes>(failed: L::Mask, quat: Quat<L>) -> Quat<L> {
    let nan = quat.w().constant(f64::NAN);
    Quat::from_array(vector::select(failed, [nan; 4], quat.to_array()))
}

/// Lanes in which all elements of a matrix are finite.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn all_finite<L: Lanes>([a, b, c]: [[L; 3]; 3]) -> L::Mask {
    vector::are_finite(a) & vector::are_finite(b) & vector::are_finite(c)
}
