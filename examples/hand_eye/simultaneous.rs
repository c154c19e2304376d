//! Rotation and translation at once: K. Daniilidis, *Hand-eye calibration using dual quaternions*,
//! International Journal of Robotics Research 18 (1999).

use crate::calibration::{CalibrationError, Pair, check, equations};
use dq8::DualQuat;
use nalgebra::Vector4;

/// X of A X = X B, in the least squares of the stacked equations of all motions.
///
/// The vector parts of A X − X B = 0 are six linear equations in the eight components of X = q +
/// εq′. Of X they are zero, and of εq: two right singular vectors (u₁, v₁) and (u₂, v₂)
/// have singular values of zero, or near it with noise. X is that sum λ₁(u₁, v₁) +
/// λ₂(u₂, v₂) which is unit: q·q = 1 and q·q′ = 0.
///
/// Lengths and angles stand in the same equations, so the unit of length is their weight: choose it
/// so that errors in translation are about as large as those in radians.
pub(crate) fn solve(pairs: &[Pair]) -> Result<DualQuat<f64>, CalibrationError> {
    check(pairs)?;
    let rows = equations(pairs).svd(false, true).v_t.expect("it was asked for");
    let half = |row, from| Vector4::from_fn(|c, _| rows[(row, from + c)]);
    let [(u1, v1), (u2, v2)] = [6, 7].map(|row| (half(row, 0), half(row, 4)));

    // λ₁² u₁·v₁ + λ₁λ₂ (u₁·v₂ + u₂·v₁) + λ₂² u₂·v₂ = 0 has two
    // solutions: X, and εq with no real part.
    let ratios = roots(u1.dot(&v1), u1.dot(&v2) + u2.dot(&v1), u2.dot(&v2));
    let sums = ratios.map(|[l1, l2]| (u1 * l1 + u2 * l2, v1 * l1 + v2 * l2));
    let [first, second] = sums;
    let (q, q_dual) = if first.0.norm() > second.0.norm() { first } else { second };
    let [w, x, y, z] = q.into();
    let [dw, dx, dy, dz] = q_dual.into();
    // What is left of the two conditions: the length, and rounding.
    Ok(DualQuat::from_wxyz([w, x, y, z, dw, dx, dy, dz]).normalize().canonical())
}

/// (λ₁, λ₂) of length 1 with a λ₁² + b λ₁λ₂ + c λ₂² = 0, without the difference
/// that would cancel. Noise can leave no real solution; the nearest is the double one.
pub(crate) fn roots(a: f64, b: f64, c: f64) -> [[f64; 2]; 2] {
    let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
    let sum = -0.5 * (b + root.copysign(b));
    [[sum, a], [c, sum]].map(|[x, y]| {
        let length = x.hypot(y);
        if length > 0.0 { [x / length, y / length] } else { [1.0, 0.0] }
    })
}
