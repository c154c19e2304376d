//! Linear blending.

use super::DualQuat;
use crate::real::Real;

impl<R: Real> DualQuat<R> {
    /// Normalised linear interpolation by the shorter way: (1−t)a ± tb, exactly normalised, the
    /// sign such that the two do not point apart (Tarini, slide 127). `t` = 0 gives `self`, 1 gives
    /// ±`other`. Cheaper than [`sclerp`](Self::sclerp), with the same path of the real part but not
    /// the same speed.
    ///
    /// Every component is NaN if the result cannot be normalised.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let a = DualQuat::from_translation([0.0_f32, 0.0, 0.0]);
    /// let b = DualQuat::from_translation([8.0, 0.0, 0.0]);
    /// assert_eq!(a.nlerp(-b, 0.25).translation(), [2.0, 0.0, 0.0]);
    /// ```
    #[must_use]
    pub fn nlerp(self, other: Self, t: R) -> Self {
        let near = other.toward(self);
        (self.scale(R::ONE - t) + near.scale(t)).normalize()
    }

    /// Dual quaternion linear blending, Σ ±wᵢσᵢ exactly normalised, each sign turned toward the
    /// first motion (Kavan et al. 2008, "DLB"). The weights need not sum to one.
    ///
    /// `None` without influences; every component is NaN if the sum cannot be normalised, as when
    /// the weights cancel.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let a = DualQuat::from_translation([0.0_f32, 0.0, 0.0]);
    /// let b = DualQuat::from_translation([8.0, 0.0, 0.0]);
    /// assert_eq!(DualQuat::dlb(&[(a, 3.0), (b, 1.0)]).unwrap().translation(), [2.0, 0.0, 0.0]);
    /// ```
    #[must_use]
    pub fn dlb(influences: &[(Self, R)]) -> Option<Self> {
        let (&(first, weight), others) = influences.split_first()?;
        let mut sum = first.scale(weight);
        for &(motion, weight) in others {
            sum = sum + motion.toward(first).scale(weight);
        }
        Some(sum.normalize())
    }

    /// Of σ and −σ, the same motion, the one on the side of `pivot`.
    pub(super) fn toward(self, pivot: Self) -> Self {
        if self.real().dot(pivot.real()) < R::ZERO { -self } else { self }
    }
}
