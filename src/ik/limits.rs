//! Joint values on lanes, within the limits of their joints.

use super::{Arm, Joint};
use crate::batch::vector;
use crate::real::Real;
use dq8_simd::{Float, Lanes};

impl<R: Real + Float, const N: usize> Arm<R, N> {
    /// The joints moved, each within its limits; a joint that wraps goes on a turn less. What is not
    /// finite moves nothing.
    #[inline(always)]
    pub(super) fn moved<L: Lanes<Real = R>>(&self, values: &[L; N], changes: &[L; N]) -> [L; N] {
        let mut moved = *values;
        for ((value, &change), joint) in moved.iter_mut().zip(changes).zip(&self.joints) {
            let next = *value + change;
            let next = if joint.wraps() { wrap(joint, next) } else { next };
            let next = clamp(joint, next);
            *value = L::select(vector::is_finite(next), next, *value);
        }
        moved
    }

    /// Where a joint is at a limit that stops it.
    #[inline(always)]
    pub(super) fn is_at_limits<L: Lanes<Real = R>>(
        &self,
        level: L::Level,
        values: &[L; N],
    ) -> L::Mask {
        let zero = L::splat(level, R::ZERO);
        let mut is_at_limits = zero.lt(zero);
        for (joint, &value) in self.joints.iter().zip(values) {
            let [low, high] = vector::splat(level, joint.limits);
            if !joint.wraps() {
                is_at_limits = is_at_limits | value.le(low) | high.le(value);
            }
        }
        is_at_limits
    }
}

/// To the nearest value within the limits.
#[inline(always)]
pub(super) fn clamp<L: Lanes<Real: Real>>(joint: &Joint<L::Real>, value: L) -> L {
    let [low, high] = vector::splat(value.level(), joint.limits);
    let value = L::select(value.lt(low), low, value);
    L::select(high.lt(value), high, value)
}

/// A turn less, beyond the limits.
#[inline(always)]
fn wrap<L: Lanes<Real: Real>>(joint: &Joint<L::Real>, value: L) -> L {
    let [low, high] = vector::splat(value.level(), joint.limits);
    let turn = value.constant(core::f64::consts::TAU);
    let value = L::select(value.lt(low), value + turn, value);
    L::select(high.lt(value), value - turn, value)
}
