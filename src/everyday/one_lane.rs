//! Operations of [`batch`] at one lane. Screw motions gain because they call no library for a sine or an arccosine and
//! have no singularity (see `batch/even.rs`).

use super::Number;
use crate::batch;
use crate::geometry::DualVector;

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

/// σ^½ of the one of ±σ with p_w ≥ 0
#[inline]
pub(super) fn sqrt<F: Number>(motion: [F; 8]) -> Option<[F; 8]> {
    Some(batch::DualQuat::<F>::from_array(motion).sqrt().to_array())
}
