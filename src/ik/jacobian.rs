//! Where the end of an arm is on lanes, and how it moves with each joint.

use super::{Arm, Joint};
use crate::batch::even::cos_sin;
use crate::batch::{DualQuat, Quat, vector};
use crate::geometry::Twist;
use crate::real::{Real, Scalar};
use dq8_simd::Lanes;

impl<R: Scalar, const N: usize> Arm<R, N> {
    /// [`forward`](Self::forward) on lanes.
    #[inline(always)]
    #[must_use]
    pub fn forward_lanes<L: Lanes<Real = R>>(
        &self,
        level: L::Level,
        values: &[L; N],
    ) -> DualQuat<L> {
        self.forward_jacobian(level, values).0
    }

    /// The pose of the end, and the spatial Jacobian: column j is the screw of joint j where the
    /// joints before it have moved it, Ad(exp(½ξ₁q₁) … exp(½ξⱼ₋₁qⱼ₋₁)) ξⱼ, so that the spatial twist of
    /// the end is Σ q̇ⱼ column(j) (Lynch & Park 2017, eq. 5.11); the same as
    /// [`Job::jacobian`](crate::Job::jacobian).
    #[inline(always)]
    #[must_use]
    pub fn forward_jacobian<L: Lanes<Real = R>>(
        &self,
        level: L::Level,
        values: &[L; N],
    ) -> (DualQuat<L>, [Twist<L>; N]) {
        let mut pose = DualQuat::identity(level);
        let zero = L::splat(level, R::ZERO);
        let mut columns = [Twist::from_array([zero; 6]); N];
        let joints = self.joints.iter().zip(&self.pitches);
        for ((column, (joint, &pitch)), &value) in columns.iter_mut().zip(joints).zip(values) {
            let screw = Twist::from_array(vector::splat(level, joint.screw.to_array()));
            *column = pose.adjoint(screw);
            pose = pose * motion(level, joint, pitch, value);
        }
        (pose * DualQuat::splat(level, self.home.to_array()), columns)
    }
}

/// [`Joint::motion`] of a joint with a unit screw: the angle is that of `value` itself, to its last
/// place, where the length of the twist ξ·value would be one rounding of many turns away from it.
///
/// With h half the angle and a pitch p, cos ĥ + sin ĥ (ω + εm) for ĥ = h + εph and m = v − pω. The joint
/// is the same in all lanes, so the cases cost a branch that is always the same.
#[inline(always)]
fn motion<L: Lanes<Real: Scalar>>(
    level: L::Level,
    joint: &Joint<L::Real>,
    pitch: L::Real,
    value: L,
) -> DualQuat<L> {
    let (zero, half) = (value.constant(0.0), value * value.constant(0.5));
    let linear = vector::splat(level, joint.screw.linear);
    if joint.is_slide() {
        let slide = vector::scale(linear, half);
        let one = value.constant(1.0);
        return DualQuat::new(Quat::from_parts([zero; 3], one), Quat::from_parts(slide, zero));
    }
    let axis = vector::splat(level, joint.screw.angular);
    let (cos, sin) = cos_sin(half);
    let (turn, moment) = (vector::scale(axis, sin), vector::scale(linear, sin));
    let dual = if pitch == L::Real::ZERO {
        Quat::from_parts(moment, zero)
    } else {
        let pitch = L::splat(level, pitch);
        let slide = pitch * half;
        // cos h·ph ω + sin h (v − pω), and −sin h·ph
        let along = cos.mul_add(slide, -(sin * pitch));
        Quat::from_parts(vector::scale_onto(axis, along, moment), -(sin * slide))
    };
    DualQuat::new(Quat::from_parts(turn, cos), dual)
}
