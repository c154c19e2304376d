//! Linear blending, and the iteration for the intrinsic mean of motions, which starts from a linear
//! blend.

use super::{DualQuat, Quat, vector};
use crate::geometry::{DualVector, Mean};
use crate::number::Real;
use crate::quick;

impl<R: Real> Quat<R> {
    /// Normalized linear interpolation from `self` (a) to ±`other` (b) by the shorter way:
    /// (1−t)a ± tb, normalized (Shoemake 1985). `t` = 0 gives `self`, and 1 gives ±`other`. It
    /// takes the same path as [`slerp`](Self::slerp) and is cheaper, but its speed is not constant.
    /// The result is NaN if the sum is zero.
    #[inline]
    #[doc(alias("lerp"))]
    pub fn nlerp(self, other: Self, t: R) -> Self {
        let near = if self.dot(other) < R::ZERO { -other } else { other };
        (self.scale(R::ONE - t) + near.scale(t)).normalize()
    }
}

impl<R: Real> DualQuat<R> {
    /// Normalized linear interpolation from `self` (a) to ±`other` (b) by the shorter way:
    /// (1−t)a ± tb, exactly normalized, with the sign for which the real parts have a scalar
    /// product that is not negative (Tarini, slide 127). `t` = 0 gives `self`, and 1 gives
    /// ±`other`. It is cheaper than [`sclerp`](Self::sclerp); the real part takes the same path,
    /// but not with the same speed.
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

    /// Dual quaternion linear blending, Σ ±wᵢσᵢ exactly normalized, with the sign for which
    /// ±σᵢ is nearer to the first motion (Kavan et al. 2008, "DLB"). It is cheaper than the
    /// intrinsic mean [`dib`](Self::dib). For two motions, the rotation of the blend differs from
    /// that of the intrinsic mean by at most 8.15°.
    ///
    /// The weights need not sum to one, because the sum is normalized: multiplying all weights by
    /// the same factor (not zero) gives the same motion. A negative weight moves the blend away
    /// from the motion that has this weight. Where the weights sum to zero, the result is of no use
    /// and often NaN. If weights are so small that their products with components are subnormal,
    /// the result loses digits.
    ///
    /// Returns `None` if there are no influences. Every component is NaN if the sum cannot be
    /// normalized, because its real part is zero (as when the weights cancel) or a component is not
    /// finite.
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

    /// Blends like [`dlb`](Self::dlb), but chooses each sign by the weighted sum of the motions
    /// before it: ±σᵢ is nearer to this sum. This is for influences that do not cluster about
    /// the first one, or whose first weight may be zero. A motion exactly half a turn from the sum
    /// keeps its sign. The result depends on the order of the influences if they span more than
    /// half a turn. The weights need not sum to one, but no partial sum of the weights should be
    /// negative: otherwise the partial sum of the motions would point away from the motions in it.
    /// Tarini's slide 127 chooses the sign for two motions; this function is one way to extend the
    /// rule to more motions.
    ///
    /// Returns `None` if there are no influences. Every component is NaN if the sum cannot be
    /// normalized.
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

    /// Returns whichever of σ and −σ is nearer to `pivot`. Both are the same motion.
    #[inline]
    pub(super) fn toward(self, pivot: Self) -> Self {
        if self.real().dot(pivot.real()) < R::ZERO { -self } else { self }
    }
}

/// Returns the weighted sum of influences, each with the sign for which it is nearer to the first
/// motion. [`DualQuat::dlb`] is this sum, normalized.
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
    /// Dual quaternion iterative blending. It finds the intrinsic mean b of unit motions σᵢ, the
    /// motion at which the weighted screws to all of them cancel, Σ wᵢ log(b*σᵢ) = 0 (Kavan
    /// et al. 2008, "DIB"; for rotations Buss and Fillmore 2001).
    ///
    /// The iteration starts from the linear blend [`dlb`](Self::dlb) and sets b ← b exp(x) with
    /// x = Σ wᵢ log(b*σᵢ) / Σ wᵢ. It ends when the step x = a + εb turns by no more than
    /// `tolerance`, 2|a| ≤ `tolerance` radians, and moves by no more than `tolerance` times the
    /// longest translation, |b| ≤ `tolerance`·max |qᵢ| (|tᵢ| = 2|qᵢ|). Angle and length
    /// are compared separately, so the test does not depend on the unit of length. The smallest
    /// tolerance that rounding allows is a few [`EPSILON`](Real::EPSILON). If `tolerance` times the
    /// longest translation is below the smallest float, only a step of zero is short enough, and
    /// `converged` may be `false`.
    ///
    /// Each step multiplies the error by a factor that shrinks with the square of the spread:
    /// influences within 40° of a common pose take at most 3 steps to an error of 10⁻⁶ and 8
    /// steps to 2·10⁻¹⁵. The mean of two motions is their [`sclerp`](Self::sclerp), found in
    /// one step. The mean moves with the influences, c·dib(σᵢ) = dib(cσᵢ), and likewise for
    /// a motion c on the right. Each logarithm takes the shorter way, so signs do not matter. If
    /// influences lie more than a quarter of a turn from the mean, there may be several means.
    ///
    /// The weights need not sum to one; multiplying all weights by one factor gives the same
    /// motion. If they sum to zero, there is no mean: components are NaN, or `converged` is
    /// `false`. NaN and infinities in a motion or a weight give NaN. The function returns `None` if
    /// there are no influences.
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

    /// Returns the mean logarithm Σ wᵢ log(σ*σᵢ) / Σ wᵢ.
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

/// Computes [`DualQuat::dib`] of influences from an iterator. The C interface needs an iterator,
/// because it gets the weights in a separate array.
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
        // `goes_on` is not the negation of `converged`: for NaN both are `false`, because no
        // further step can help.
        let goes_on = turn > tolerance || slide > tolerance * longest;
        if !goes_on || made == max_iterations {
            return Some(Mean { motion, iterations, converged });
        }
        motion = motion * DualQuat::exp(step);
        made += 1;
        iterations += R::ONE;
    }
}
