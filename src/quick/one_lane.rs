//! Operations that call [`batch`] with one lane. For screw motions they are faster than the scalar
//! reference, because they call no library for a sine or an arccosine, and need no special case
//! near a singularity (see `batch/even.rs`).

use super::Number;
use crate::batch;
use crate::batch::vector::splat;
use crate::geometry::DualVector;
use dq8_simd::{Float, Lanes, Portable, Unfused};

/// Returns the logarithm of a unit motion, (θ̂/2)(l + εm).
#[inline]
pub(super) fn log<F: Number>(motion: [F; 8]) -> Option<DualVector<F>> {
    Some(batch::DualQuat::<F>::from_array(motion).log())
}

/// Returns the exponential of a dual vector ĥ(l + εm), which is cos ĥ + sin ĥ (l + εm).
#[inline]
pub(super) fn exp<F: Number>(log: DualVector<F>) -> Option<[F; 8]> {
    Some(batch::DualQuat::<F>::exp(log).to_array())
}

/// Returns σᵗ of a unit motion σ, or `None` if t² is not finite.
#[inline]
pub(super) fn pow<F: Number>(motion: [F; 8], t: F) -> Option<[F; 8]> {
    if !(t * t).lt(F::from_f64(f64::INFINITY)) {
        return None;
    }
    Some(batch::DualQuat::<F>::from_array(motion).pow(t).to_array())
}

/// Returns the square root of the canonical one of σ and −σ.
#[inline]
pub(super) fn sqrt<F: Number>(motion: [F; 8]) -> Option<[F; 8]> {
    Some(batch::DualQuat::<F>::from_array(motion).sqrt().to_array())
}

/// Solves a limb of two bones: both rotations, the bend, and the distance by which the target is
/// out of reach.
#[inline]
pub(super) fn limb<F: Number>(
    root: [F; 3],
    lengths: [F; 2],
    target: [F; 3],
    pole: [F; 3],
) -> Option<([[F; 4]; 2], [F; 2])> {
    let level = Unfused(Portable);
    let lanes = |point| splat::<Together<F>, 3>(level, point);
    let limb =
        batch::TwoBone::reach(lanes(root), splat(level, lengths), lanes(target), lanes(pole));
    let turn = |[x, y, z, w]: [Together<F>; 4]| [first(x), first(y), first(z), first(w)];
    let turns = [turn(limb.upper.to_array()), turn(limb.lower.to_array())];
    Some((turns, [first(limb.bend), first(limb.beyond)]))
}

/// Vectors of which only the first lane is used. A formula with many cases is quicker on lanes,
/// which compute all cases and select, than with branches.
type Together<F> = <F as Float>::Lanes<Unfused<Portable>>;

#[inline(always)]
fn first<L: Lanes>(lanes: L) -> L::Real {
    lanes.to_array().as_ref().first().copied().unwrap_or_default()
}

/// Normalizes a dual quaternion of any length exactly. Returns NaN in all components if it cannot
/// be normalized. This function is not inlined, because only rare lengths need it.
#[cold]
#[inline(never)]
pub(super) fn unit<F: Number>(motion: [F; 8]) -> [F; 8] {
    let unit = batch::DualQuat::<F>::from_array(motion).normalize();
    // If p is zero or not finite, some component of q is NaN or infinite. Zero times such a
    // component is NaN.
    let [x, y, z, w] = unit.dual().to_array();
    let zero = F::default();
    let finite = Lanes::eq(zero * x * y * z * w, zero);
    if finite { unit.to_array() } else { [F::from_f64(f64::NAN); 8] }
}

/// Returns the inverse of a dual quaternion of any length, or NaN in all components if there is
/// none.
#[cold]
#[inline(never)]
pub(super) fn inverse<F: Number>(motion: [F; 8]) -> [F; 8] {
    batch::DualQuat::<F>::from_array(motion).inverse_checked().0.to_array()
}
