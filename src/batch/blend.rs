//! Linear blending.

use super::{DualQuat, Quat};
use dq8_simd::Lanes;

impl<L: Lanes> Quat<L> {
    /// (1−t)a ± tb exactly normalized, by the shorter way; `t` may differ from lane to lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn nlerp(self, other: Self, t: L) -> Self {
        let away = other.dot(self).lt(t.constant(0.0));
        let start = self.scale(t.constant(1.0) - t);
        other.scale_onto(L::select(away, -t, t), start).normalize()
    }
}

impl<L: Lanes> DualQuat<L> {
    /// (1−t)a ± tb exactly normalized, by the shorter way; `t` may differ from lane to lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn nlerp(self, other: Self, t: L) -> Self {
        let weight = other.weight_toward(self, t);
        let start = self.scale(t.constant(1.0) - t);
        other.scale_onto(weight, start).normalize()
    }

    /// Σ ±wᵢσᵢ exactly normalized, each sign turned toward the first motion; `None` without
    /// influences.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn dlb(influences: &[(Self, L)]) -> Option<Self> {
        let (&(first, weight), others) = influences.split_first()?;
        let mut sum = first.scale(weight);
        for &(motion, weight) in others {
            sum = motion.scale_onto(motion.weight_toward(first, weight), sum);
        }
        Some(sum.normalize())
    }

    /// Σ ±wᵢσᵢ exactly normalized, each sign turned toward the sum so far; `None` without
    /// influences.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn dlb_running(influences: &[(Self, L)]) -> Option<Self> {
        let (&(first, weight), others) = influences.split_first()?;
        let mut sum = first.scale(weight);
        for &(motion, weight) in others {
            sum = motion.scale_onto(motion.weight_toward(sum, weight), sum);
        }
        Some(sum.normalize())
    }

    /// sσ + onto
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn scale_onto(self, factor: L, onto: Self) -> Self {
        Self::new(
            self.real().scale_onto(factor, onto.real()),
            self.dual().scale_onto(factor, onto.dual()),
        )
    }

    /// `weight`, negated where σ points away from `pivot`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn weight_toward(self, pivot: Self, weight: L) -> L {
        let away = self.real().dot(pivot.real()).lt(weight.constant(0.0));
        L::select(away, -weight, weight)
    }
}
