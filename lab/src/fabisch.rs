//! Formulas of Fabisch, as printed, and the four mistakes that he warns of. Not for use.

use dq8::{Dual, DualQuat};

/// s + εt = pᵀp + 2ε pᵀq.
pub fn squared_norm(sigma: DualQuat<f64>) -> Dual<f64> {
    let (p, q) = (sigma.real(), sigma.dual());
    Dual::new(p.dot(p), 2.0 * p.dot(q))
}

/// Mistake 1: both parts divided by the norm of the real one, orthogonality ignored.
pub fn by_the_real_norm_alone(sigma: DualQuat<f64>) -> DualQuat<f64> {
    sigma.scale(1.0 / sigma.real().norm())
}

/// Mistake 2: only the real part divided.
pub fn only_the_real_part(sigma: DualQuat<f64>) -> DualQuat<f64> {
    let over = 1.0 / sigma.real().norm();
    DualQuat::new(sigma.real().scale(over), sigma.dual())
}

/// Mistake 3: no square root taken.
pub fn without_the_root(sigma: DualQuat<f64>) -> DualQuat<f64> {
    let squared = squared_norm(sigma);
    sigma.scale_dual(Dual::ONE / squared)
}

/// Mistake 4: uq + vp of the direct solution with the p that has been divided already.
pub fn with_the_updated_real_part(sigma: DualQuat<f64>) -> DualQuat<f64> {
    let (p, q) = (sigma.real(), sigma.dual());
    let u = 1.0 / p.norm();
    let (v, updated) = (-p.dot(q) * u.powi(3), p.scale(u));
    DualQuat::new(updated, q.scale(u) + updated.scale(v))
}
