//! The intrinsic mean of motions.

use super::blend::weighted_sum;
use super::{DualQuat, vector};
use crate::geometry::{DualVector, Mean};
use crate::number::Real;

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
        // Not the opposite of `converged`: with NaN there is nothing to go on for.
        let goes_on = turn > tolerance || slide > tolerance * longest;
        if !goes_on || made == max_iterations {
            return Some(Mean { motion, iterations, converged });
        }
        motion = motion * DualQuat::exp(step);
        made += 1;
        iterations += R::ONE;
    }
}
