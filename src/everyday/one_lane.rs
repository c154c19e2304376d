//! Operations of [`batch`] at one lane. Screw motions gain because they call no library for a sine or an arccosine and
//! have no singularity (see `batch/even.rs`).

use super::Number;
use crate::batch;
use crate::geometry::DualVector;
use dq8_simd::Lanes;

/// (θ̂/2)(l + εm)
#[inline]
pub(super) fn log<F: Number>(motion: [F; 8]) -> Option<DualVector<F>> {
    Some(batch::DualQuat::<F>::from_array(motion).log())
}

/// cos ĥ + sin ĥ (l + εm)
#[inline]
pub(super) fn exp<F: Number>(log: DualVector<F>) -> Option<[F; 8]> {
    Some(batch::DualQuat::<F>::exp(log).to_array())
}

/// σᵗ, of t whose square is a number.
#[inline]
pub(super) fn pow<F: Number>(motion: [F; 8], t: F) -> Option<[F; 8]> {
    if !(t * t).lt(F::from_f64(f64::INFINITY)) {
        return None;
    }
    Some(batch::DualQuat::<F>::from_array(motion).pow(t).to_array())
}

/// σ^½ of the canonical one of ±σ
#[inline]
pub(super) fn sqrt<F: Number>(motion: [F; 8]) -> Option<[F; 8]> {
    Some(batch::DualQuat::<F>::from_array(motion).sqrt().to_array())
}

/// Exact normalization of any length, or all NaN. Out of line: hardly anything is so long or so short.
#[cold]
#[inline(never)]
pub(super) fn unit<F: Number>(motion: [F; 8]) -> [F; 8] {
    let unit = batch::DualQuat::<F>::from_array(motion).normalize();
    // A p that is zero or not finite leaves no number in q. Zero times what is not finite is NaN.
    let [x, y, z, w] = unit.dual().to_array();
    let zero = F::default();
    let finite = Lanes::eq(zero * x * y * z * w, zero);
    if finite { unit.to_array() } else { [F::from_f64(f64::NAN); 8] }
}

/// σ⁻¹ of any length, or all NaN.
#[cold]
#[inline(never)]
pub(super) fn inverse<F: Number>(motion: [F; 8]) -> [F; 8] {
    batch::DualQuat::<F>::from_array(motion).inverse_checked().0.to_array()
}
