//! The reference implementation, with which tests compare the lanes: one vertex at a time, by the
//! formulas of the papers.

use crate::number::Real;
use crate::scalar::DualQuat;

/// Returns the linear blend Σ wᵢMᵢ of 3×4 matrices Mᵢ with their weights wᵢ.
///
/// ```
/// use dq8::DualQuat;
/// use dq8::skinning::linear_blend;
/// let [a, b] = [0.0_f32, 8.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]).to_matrix3x4());
/// assert_eq!(linear_blend(&[(a, 0.75), (b, 0.25)])[0], [1.0, 0.0, 0.0, 2.0]);
/// ```
#[must_use]
pub fn linear_blend<R: Real>(influences: &[([[R; 4]; 3], R)]) -> [[R; 4]; 3] {
    let mut sum = [[R::ZERO; 4]; 3];
    for &(matrix, weight) in influences {
        for (sum, row) in sum.iter_mut().zip(matrix) {
            for (sum, number) in sum.iter_mut().zip(row) {
                *sum += weight * number;
            }
        }
    }
    sum
}

/// Returns the dual quaternion blend Σ ±wᵢσᵢ of motions σᵢ with their weights wᵢ,
/// exactly normalized. The signs are those of UsdSkel: a motion is negated if its real part points
/// away from that of the pivot, the first motion with the greatest weight. If the real parts are at
/// right angles, half a turn lies between the motion and the pivot. Then both count with the sign
/// that makes their first nonzero component of (w, x, y, z) positive.
///
/// A single motion of weight 1 is returned as it is. The result is `None` without influences, and
/// all its components are NaN if the sum cannot be normalized.
///
/// ```
/// use dq8::DualQuat;
/// use dq8::skinning::dual_blend;
/// let [a, b] = [0.0_f32, 8.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
/// let blend = dual_blend(&[(a, 0.25), (-b, 0.75)]).unwrap();
/// assert_eq!(blend.translation(), [6.0, 0.0, 0.0]);
/// ```
#[must_use]
pub fn dual_blend<R: Real>(influences: &[(DualQuat<R>, R)]) -> Option<DualQuat<R>> {
    let (&(mut pivot, mut greatest), others) = influences.split_first()?;
    for &(motion, weight) in others {
        if weight > greatest {
            (pivot, greatest) = (motion, weight);
        }
    }
    let (mut sum, mut total) = (DualQuat::ZERO, R::ZERO);
    for &(motion, weight) in influences {
        let dot = motion.real().dot(pivot.real());
        let away =
            if dot == R::ZERO { is_negative(motion) != is_negative(pivot) } else { dot < R::ZERO };
        sum = sum + motion.scale(if away { -weight } else { weight });
        total += weight;
    }
    Some(if greatest == R::ONE && total == R::ONE { pivot } else { sum.normalize() })
}

/// Returns `true` if the first nonzero component of (w, x, y, z) of the real part is negative.
fn is_negative<R: Real>(motion: DualQuat<R>) -> bool {
    let [x, y, z, w] = motion.real().to_array();
    [w, x, y, z].into_iter().find(|&c| c != R::ZERO).is_some_and(|c| c < R::ZERO)
}
