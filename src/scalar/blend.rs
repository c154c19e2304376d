//! Linear blending, and the intrinsic mean of motions, which starts from it.

use super::{DualQuat, Quat, vector};
use crate::geometry::{DualVector, Mean};
use crate::number::Real;
use crate::quick;

impl<R: Real> Quat<R> {
    /// Normalized linear interpolation by the shorter way: (1−t)a ± tb, normalized (Shoemake
    /// 1985). `t` = 0 gives `self`, 1 gives ±`other`. On the same arc as [`slerp`](Self::slerp),
    /// cheaper, and not at constant speed. NaN if the sum is zero.
    #[inline]
    #[doc(alias("lerp"))]
    pub fn nlerp(self, other: Self, t: R) -> Self {
        let near = if self.dot(other) < R::ZERO { -other } else { other };
        (self.scale(R::ONE - t) + near.scale(t)).normalize()
    }
}

impl<R: Real> DualQuat<R> {
    /// Normalized linear interpolation by the shorter way: (1−t)a ± tb, exactly normalized, the
    /// sign such that the two do not point apart (Tarini, slide 127). `t` = 0 gives `self`, 1 gives
    /// ±`other`. Cheaper than [`sclerp`](Self::sclerp), with the same path of the real part but
    /// not the same speed.
    ///
    /// Every component is NaN if the result cannot be normalized.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let a = DualQuat::from_translation([0.0_f32, 0.0, 0.0]);
    /// let b = DualQuat::from_translation([8.0, 0.0, 0.0]);
    /// assert_eq!(a.nlerp(-b, 0.25).translation(), [2.0, 0.0, 0.0]);
    /// ```
    #[inline]
    #[must_use]
    #[doc(alias("lerp"))]
    pub fn nlerp(self, other: Self, t: R) -> Self {
        if let Some(sum) = R::quick(quick::Lerp(self.to_array(), other.to_array(), t)) {
            return Self::from_array(sum).normalize();
        }
        let near = other.toward(self);
        (self.scale(R::ONE - t) + near.scale(t)).normalize()
    }

    /// Dual quaternion linear blending, Σ ±wᵢσᵢ exactly normalized, each sign turned toward
    /// the first motion (Kavan et al. 2008, "DLB"). Cheaper than [`dib`](Self::dib), the mean in
    /// earnest, from which the blend of two motions turns away by at most 8.15°.
    ///
    /// The weights need not sum to one, because the sum is normalized: all of them times any number
    /// but zero give the same motion. A negative weight moves the blend away from its motion. Where
    /// weights sum to zero the result is of no use, and often NaN. Weights that are so small that a
    /// product with a component is below the normal numbers lose digits, as such numbers do.
    ///
    /// `None` without influences; every component is NaN if the sum cannot be normalized: its real
    /// part is zero, as when the weights cancel, or a component is not finite.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// let a = DualQuat::from_translation([0.0_f32, 0.0, 0.0]);
    /// let b = DualQuat::from_translation([8.0, 0.0, 0.0]);
    /// assert_eq!(DualQuat::dlb(&[(a, 3.0), (b, 1.0)]).unwrap().translation(), [2.0, 0.0, 0.0]);
    /// ```
    #[inline]
    #[must_use]
    #[doc(alias("blend"))]
    pub fn dlb(influences: &[(Self, R)]) -> Option<Self> {
        Some(weighted_sum(influences.iter().copied())?.normalize())
    }

    /// Blends like [`dlb`](Self::dlb), but turns each sign toward the sum of the motions before it.
    /// This is for influences that do not cluster about the first one, or whose first weight may be
    /// zero. Where the two are exactly at right angles (half a turn apart) the sign is kept. The
    /// result depends on the order of the influences where they span more than half a turn. The
    /// weights need not sum to one, but no sum on the way should be negative: it would point away
    /// from its motions. Tarini's slide 127 turns signs for two; for more, this is one way to go
    /// on.
    ///
    /// `None` without influences; every component is NaN if the sum cannot be normalized.
    ///
    /// ```
    /// use dq8::{DualQuat, Quat};
    /// let turn = |angle| DualQuat::from_rotation(Quat::from_axis_angle([0.0, 0.0, 1.0], angle));
    /// // 200° are more than half a turn from 0°, but not from the sum of 0° and 120°.
    /// let influences = [0.0_f64, 120.0, 200.0].map(|angle| (turn(angle.to_radians()), 1.0));
    /// let degrees = |blend: Option<DualQuat<f64>>| blend.unwrap().to_screw().angle.to_degrees();
    /// assert!((degrees(DualQuat::dlb_running(&influences)) - 108.8).abs() < 0.1);
    /// assert!((degrees(DualQuat::dlb(&influences)) - 8.1).abs() < 0.1);
    /// ```
    #[inline]
    #[must_use]
    pub fn dlb_running(influences: &[(Self, R)]) -> Option<Self> {
        let (&(first, weight), others) = influences.split_first()?;
        let mut sum = first.scale(weight);
        for &(motion, weight) in others {
            sum = sum + motion.toward(sum).scale(weight);
        }
        Some(sum.normalize())
    }

    /// σ or −σ, the same motion: the one on the side of `pivot`.
    #[inline]
    pub(super) fn toward(self, pivot: Self) -> Self {
        if self.real().dot(pivot.real()) < R::ZERO { -self } else { self }
    }
}

/// The sum of influences, each with the sign that turns it toward the first: normalized,
/// [`DualQuat::dlb`].
#[inline]
pub fn weighted_sum<R: Real>(
    mut influences: impl Iterator<Item = (DualQuat<R>, R)>,
) -> Option<DualQuat<R>> {
    let (first, weight) = influences.next()?;
    let mut sum = first.scale(weight);
    for (motion, weight) in influences {
        sum = sum + motion.toward(first).scale(weight);
    }
    Some(sum)
}

impl<R: Real> DualQuat<R> {
    /// Dual quaternion iterative blending: the intrinsic mean b of unit motions σᵢ, which is
    /// where the weighted screws to all of them cancel, Σ wᵢ log(b*σᵢ) = 0 (Kavan et al.
    /// 2008, "DIB"; for rotations Buss and Fillmore 2001).
    ///
    /// From the linear blend [`dlb`](Self::dlb), b ← b exp(x) with x = Σ wᵢ log(b*σᵢ) / Σ
    /// wᵢ until the step x = a + εb turns by no more than `tolerance`, 2|a| ≤ `tolerance`
    /// radians, and moves by no more than `tolerance` times the longest translation, |b| ≤
    /// `tolerance`·max |qᵢ| (|tᵢ| = 2|qᵢ|). The two are compared apart, and neither depends
    /// on the unit of length. A tolerance of a few [`EPSILON`](Real::EPSILON) is as small as
    /// rounding allows. Where the longest translation times it is below the smallest number, no
    /// step but zero is short enough, and `converged` may be false.
    ///
    /// Each step multiplies the error by a factor that shrinks with the square of the spread:
    /// influences within 40° of a common pose take at most 3 steps to 10⁻⁶ and 8 to
    /// 2·10⁻¹⁵. The mean of two is [`sclerp`](Self::sclerp), in one step. It moves with the
    /// influences, c·dib(σᵢ) = dib(cσᵢ), and the same for a motion c on the right. Each log
    /// takes the shorter way, so signs do not matter; where influences lie more than a quarter of a
    /// turn from the mean, there may be several.
    ///
    /// The weights need not sum to one; all of them times any number give the same motion. Where
    /// they sum to zero the mean does not exist: components are NaN, or `converged` is false. NaN
    /// and infinities in a motion or a weight give NaN. `None` without influences.
    ///
    /// ```
    /// use dq8::{DualQuat, Quat};
    /// let turn = |angle| DualQuat::from_rotation(Quat::from_axis_angle([0.0, 0.0, 1.0], angle));
    /// let poses = [(turn(0.3_f64), 1.0), (turn(0.6), 1.0), (turn(1.2), 1.0)];
    /// let mean = DualQuat::dib(&poses, 1e-12, 16).unwrap();
    /// assert!(mean.converged && mean.iterations <= 4.0);
    /// assert!((mean.motion.to_screw().angle - 0.7).abs() < 1e-12); // (0.3 + 0.6 + 1.2) / 3
    /// ```
    #[inline]
    #[must_use]
    #[cfg_attr(dq8_debug_assert_unit, track_caller)]
    #[doc(alias("average", "mean", "karcher_mean", "frechet_mean"))]
    pub fn dib(
        influences: &[(Self, R)],
        tolerance: R,
        max_iterations: u32,
    ) -> Option<Mean<Self, R, bool>> {
        for &(pose, _) in influences {
            crate::scalar::must_be_unit::motions("DualQuat::dib", [pose]);
        }
        dib(influences.iter().copied(), tolerance, max_iterations)
    }

    /// Σ wᵢ log(σ*σᵢ) / Σ wᵢ
    #[inline]
    fn mean_log(self, influences: impl Iterator<Item = (Self, R)>, total: R) -> DualVector<R> {
        let mut mean = DualVector { real: [R::ZERO; 3], dual: [R::ZERO; 3] };
        for (pose, weight) in influences {
            let log = (self.conjugate() * pose).log();
            mean = mean + log.scale(weight / total);
        }
        mean
    }
}

/// [`DualQuat::dib`] of influences that are not in one slice: C has weights apart.
#[inline]
#[doc(alias("average", "mean", "karcher_mean", "frechet_mean"))]
pub fn dib<R: Real>(
    influences: impl Iterator<Item = (DualQuat<R>, R)> + Clone,
    tolerance: R,
    max_iterations: u32,
) -> Option<Mean<DualQuat<R>, R, bool>> {
    let mut motion = weighted_sum(influences.clone())?.normalize();
    let (mut total, mut longest) = (R::ZERO, R::ZERO);
    for (pose, weight) in influences.clone() {
        total += weight;
        longest = longest.max_or_nan(pose.dual().norm());
    }
    let (mut made, mut iterations) = (0, R::ZERO);
    loop {
        let step = motion.mean_log(influences.clone(), total);
        let turn = R::TWO * vector::norm(step.real);
        let slide = vector::norm(step.dual);
        let converged = turn <= tolerance && slide <= tolerance * longest;
        // This is not the negation of `converged`: both are false for NaN, which needs no further
        // step.
        let goes_on = turn > tolerance || slide > tolerance * longest;
        if !goes_on || made == max_iterations {
            return Some(Mean { motion, iterations, converged });
        }
        motion = motion * DualQuat::exp(step);
        made += 1;
        iterations += R::ONE;
    }
}
