//! Screw motions: those of [`batch`] at one lane. No sine or arccosine of a library is asked for, and
//! nothing is singular (see `batch/even.rs`).

use super::Number;
use crate::batch;
use crate::geometry::DualVector;

/// (θ̂/2)(l + εm)
#[inline]
pub(crate) fn log<F: Number>(motion: [F; 8]) -> Option<DualVector<F>> {
    Some(batch::DualQuat::<F>::from_array(motion).log())
}

/// cos ĥ + sin ĥ (l + εm)
#[inline]
pub(crate) fn exp<F: Number>(log: DualVector<F>) -> Option<[F; 8]> {
    Some(batch::DualQuat::<F>::exp(log).to_array())
}

/// σᵗ
#[inline]
pub(crate) fn pow<F: Number>(motion: [F; 8], t: F) -> Option<[F; 8]> {
    Some(batch::DualQuat::<F>::from_array(motion).pow(t).to_array())
}
