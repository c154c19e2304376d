//! What a search is for: the target, how near is near enough, and what keeps its steps short.

use super::joint::UNIT;
use super::least_squares::epsilon;
use super::residual::{Residual, Weights, distance};
use super::step::StepLimits;
use super::{Arm, Options};
use crate::batch::{DualQuat, vector};
use crate::real::Scalar;
use dq8_simd::Lanes;

/// What all lanes seek.
#[derive(Clone, Copy)]
pub(super) struct Goal<L> {
    pub(super) target: DualQuat<L>,
    pub(super) weights: Weights<L>,
    pub(super) step_limits: StepLimits<L>,
    angular_tolerance: L,
    linear_tolerance: L,
}

impl<L: Lanes> Goal<L> {
    #[inline(always)]
    pub(super) fn is_reached(&self, residual: &Residual<L>) -> L::Mask {
        residual.angular.le(self.angular_tolerance) & residual.linear.le(self.linear_tolerance)
    }
}

impl<R: Scalar, const N: usize> Arm<R, N> {
    #[inline(always)]
    pub(super) fn goal<L: Lanes<Real = R>>(
        &self,
        target: DualQuat<L>,
        options: &Options<R>,
    ) -> Goal<L> {
        let level = target.real().w().level();
        let zero = L::splat(level, R::ZERO);
        let eighth = L::splat(level, self.length) * zero.constant(0.125);
        let length = match options.length_per_radian {
            Some(length) => L::splat(level, length),
            None => L::select(zero.lt(eighth), eighth, zero.constant(1.0)),
        };
        let damping = L::splat(level, options.damping);
        Goal {
            target,
            weights: Weights { length, radians_per_length: zero.constant(1.0) / length },
            step_limits: StepLimits {
                longest: L::splat(level, options.longest_step()),
                least_damping: damping * damping,
            },
            angular_tolerance: L::splat(level, options.angular_tolerance),
            linear_tolerance: L::splat(level, options.linear_tolerance),
        }
    }

    /// The target, exactly unit, and the lanes that have one and a start. The others get the identity,
    /// so that nothing they compute is slow or traps.
    ///
    /// Unit, because a norm of 1 + δ moves 2qp* by 2δ of itself and the logarithm by δ, so that the two
    /// errors of a [`Residual`] would never vanish together.
    #[inline(always)]
    pub(super) fn validated<L: Lanes<Real = R>>(
        &self,
        target: DualQuat<L>,
        start: &[L; N],
    ) -> (DualQuat<L>, L::Mask) {
        let level = target.real().w().level();
        let far = distance(target.translation(), vector::splat(level, self.centre));
        let mut valid = target.is_unit(far.constant(f64::from(UNIT))) & vector::is_finite(far);
        for value in *start {
            valid = valid & vector::is_finite(value);
        }
        let identity = DualQuat::identity(level).to_array();
        let target = DualQuat::from_array(vector::select(valid, target.to_array(), identity));
        (target.normalize(), valid)
    }

    /// Targets beyond the arm's length, drawn to its edge; and which they are. From beyond they would
    /// pull the harder the farther they are.
    #[inline(always)]
    pub(super) fn clamp_to_reach<L: Lanes<Real = R>>(
        &self,
        target: DualQuat<L>,
        tolerance: L,
    ) -> (DualQuat<L>, L::Mask) {
        let level = tolerance.level();
        let centre: [L; 3] = vector::splat(level, self.centre);
        let length = L::splat(level, self.length);
        let at = target.translation();
        let far = distance(at, centre);
        // Both have been rounded.
        let rounding = length.constant(1.0 + 64.0 * epsilon::<L>());
        let beyond = (length * rounding + tolerance).lt(far);
        let share = length / far;
        let mut edge = centre;
        for ((edge, at), centre) in edge.iter_mut().zip(at).zip(centre) {
            *edge = (at - centre).mul_add(share, centre);
        }
        let edge = DualQuat::from_rotation_translation(target.real(), edge);
        let clamped = vector::select(beyond, edge.to_array(), target.to_array());
        (DualQuat::from_array(clamped), beyond)
    }
}
