//! Linear blends of rotations and motions, and the intrinsic mean of motions, whose iteration
//! starts from a linear blend.

use super::length::Length;
use super::{DualQuat, Quat, vector};
use crate::geometry::{DualVector, Mean};
use dq8_simd::{Lanes, Mask};

impl<L: Lanes> Quat<L> {
    /// Returns (1−t)a ± tb divided by its norm, with a = `self` and b = `other`. The sign is
    /// that of the shorter way from a to ±b; `t` may differ from lane to lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn nlerp(self, other: Self, t: L) -> Self {
        let away = other.dot(self).lt(t.constant(0.0));
        let start = self.scale(t.constant(1.0) - t);
        other.scale_onto(L::select(away, -t, t), start).normalize()
    }
}

impl<L: Lanes> DualQuat<L> {
    /// Returns (1−t)a ± tb divided by its dual norm, with a = `self` and b = `other`. The sign
    /// is that of the shorter way from a to ±b; `t` may differ from lane to lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn nlerp(self, other: Self, t: L) -> Self {
        let weight = other.weight_toward(self, t);
        let start = self.scale(t.constant(1.0) - t);
        other.scale_onto(weight, start).normalize()
    }

    /// Returns Σ ±wᵢσᵢ divided by its dual norm, for influences (σᵢ, wᵢ). Each sign is
    /// chosen so that ±σᵢ is on the side of the first motion. Returns `None` if there are no
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

    /// Returns Σ ±wᵢσᵢ divided by its dual norm, for influences (σᵢ, wᵢ). Each sign is
    /// chosen so that ±σᵢ is on the side of the sum of the earlier influences. Returns `None`
    /// if there are no influences.
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

    /// Returns sσ + onto, with s = `factor`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn scale_onto(self, factor: L, onto: Self) -> Self {
        Self::new(
            self.real().scale_onto(factor, onto.real()),
            self.dual().scale_onto(factor, onto.dual()),
        )
    }

    /// Returns `weight`, negated in the lanes where σ and `pivot` lie on opposite sides: the
    /// scalar product of their real parts is negative.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn weight_toward(self, pivot: Self, weight: L) -> L {
        let away = self.real().dot(pivot.real()).lt(weight.constant(0.0));
        L::select(away, -weight, weight)
    }
}

impl<L: Lanes> DualQuat<L> {
    /// Returns the intrinsic mean b of influences (σᵢ, wᵢ), for which Σ wᵢ log(b*σᵢ)
    /// = 0. The iteration b ← b exp(Σ wᵢ log(b*σᵢ) / Σ wᵢ) starts from
    /// [`dlb`](Self::dlb) and ends when a step is at most `tolerance`. Returns `None` if there are
    /// no influences.
    ///
    /// A lane that has reached its mean keeps it while other lanes still iterate, and each lane
    /// counts its own iterations. So neither the mean nor the number of iterations of a lane
    /// depends on other lanes.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn dib(
        influences: &[(Self, L)],
        tolerance: L,
        max_iterations: u32,
    ) -> Option<Mean<Self, L, L::Mask>> {
        let mut motion = Self::dlb(influences)?;
        let (zero, one) = (tolerance.constant(0.0), tolerance.constant(1.0));
        let (mut total, mut longest) = (zero, zero);
        for &(pose, weight) in influences {
            total = total + weight;
            let length = pose.dual().norm();
            longest = L::select(longest.lt(length), length, longest);
        }
        let length_tolerance = tolerance * longest;
        let (mut made, mut iterations) = (0, zero);
        loop {
            let step = motion.mean_log(influences, total);
            let half_turn = Length::of(step.real, one).value();
            let turn = half_turn + half_turn;
            let slide = Length::of(step.dual, one).value();
            // `goes_on` is not the negation of `converged`: both are `false` in lanes that are NaN,
            // where no further step can help.
            let goes_on = tolerance.lt(turn) | length_tolerance.lt(slide);
            if made == max_iterations || !goes_on.any() {
                let converged = turn.le(tolerance) & slide.le(length_tolerance);
                return Some(Mean { motion, iterations, converged });
            }
            let moved = motion * Self::exp(step);
            motion = Self::from_array(vector::select(goes_on, moved.to_array(), motion.to_array()));
            made += 1;
            iterations = iterations + L::select(goes_on, one, zero);
        }
    }

    /// Returns Σ wᵢ log(σ*σᵢ) / Σ wᵢ, the step from σ to the mean; `total` is Σ wᵢ.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn mean_log(self, influences: &[(Self, L)], total: L) -> DualVector<L> {
        let zero = total.constant(0.0);
        let mut mean = DualVector { real: [zero; 3], dual: [zero; 3] };
        let inverse = self.conjugate();
        for &(pose, weight) in influences {
            let log = (inverse * pose).log();
            let share = weight / total;
            mean.real = vector::scale_onto(log.real, share, mean.real);
            mean.dual = vector::scale_onto(log.dual, share, mean.dual);
        }
        mean
    }
}
