use super::error::ArmError;
use super::joint::{Joint, chain};
use super::seed::{SEEDS, Seed, seeds};
use crate::real::Real;
use crate::scalar::{DualQuat, vector};

/// A serial arm of `N` joints: exp(½ξ₁q₁) … exp(½ξ_N q_N) home (Brockett 1984; Lynch & Park, *Modern
/// Robotics*, 2017, eq. 4.14).
///
/// An arm holds 128 of its own poses, spread evenly over its joints, from which
/// [`reach`](Self::reach) begins again where it got stuck: `128(N + 8)` numbers.
#[derive(Clone, Debug)]
pub struct Arm<R, const N: usize> {
    pub(super) joints: [Joint<R>; N],
    pub(super) home: DualQuat<R>,
    /// A point that no joint moves sideways, and how far the end can be from it.
    pub(super) centre: [R; 3],
    pub(super) length: R,
    pub(super) seeds: [Seed<R, N>; SEEDS],
}

impl<R: Real, const N: usize> Arm<R, N> {
    /// From joints, the one at the base first, and the pose of the end where all of them are zero.
    ///
    /// # Errors
    /// If the screw of a joint is not what [`Joint::screw`] asks for, its limits are not in order or
    /// let it slide without end, or `home` is not unit.
    ///
    /// ```
    /// use dq8::ik::{Arm, ArmError, Joint};
    /// use dq8::DualQuat;
    /// let joint = Joint::revolute([0.0_f32, 0.0, 2.0], [0.0; 3]);
    /// let error = Arm::new([joint], DualQuat::IDENTITY).unwrap_err();
    /// assert_eq!(error, ArmError::Screw { joint: 0, angular: 2.0, linear: 0.0 });
    /// ```
    pub fn new(joints: [Joint<R>; N], home: DualQuat<R>) -> Result<Self, ArmError> {
        let tolerance = R::from(1e-5);
        for (index, joint) in joints.iter().enumerate() {
            let angular = vector::norm(joint.screw.angular);
            let linear = vector::norm(joint.screw.linear);
            let unit = if joint.is_slide() { linear } else { angular };
            let is_screw = (unit - R::ONE).abs() <= tolerance && linear.is_finite();
            if !is_screw {
                let (angular, linear) = (angular.into(), linear.into());
                return Err(ArmError::Screw { joint: index, angular, linear });
            }
            let [low, high] = joint.limits;
            let slides = joint.is_slide() || joint.pitch().abs() > tolerance;
            let ends = low.is_finite() && high.is_finite();
            let in_order = low <= high && low < R::ONE / R::ZERO && high > -R::ONE / R::ZERO;
            if !in_order || slides && !ends {
                return Err(ArmError::Limits { joint: index, low: low.into(), high: high.into() });
            }
        }
        if !home.is_unit(tolerance) {
            return Err(ArmError::Home { norm: home.real().norm().into() });
        }
        let (centre, length) = span(&joints, home.translation());
        Ok(Self { seeds: seeds(&joints, home), joints, home, centre, length })
    }

    /// The joints, the one at the base first.
    #[must_use]
    pub fn joints(&self) -> &[Joint<R>; N] {
        &self.joints
    }

    /// The pose of the end, one product after the other.
    #[must_use]
    pub fn forward(&self, values: &[R; N]) -> DualQuat<R> {
        chain(&self.joints, self.home, values)
    }

    /// A point, and a distance from it that the end never exceeds: the sum of the shortest ways from
    /// axis to axis and on to the end, and of what slides add. Farther targets are out of reach; nearer
    /// ones may be.
    #[must_use]
    pub fn reach_bound(&self) -> ([R; 3], R) {
        (self.centre, self.length)
    }
}

/// [`Arm::reach_bound`]. A point on the axis of a hinge belongs to the links on both sides of it, so
/// the way to a point on the next axis is as long in every pose.
fn span<R: Real, const N: usize>(joints: &[Joint<R>; N], end: [R; 3]) -> ([R; 3], R) {
    let mut length = R::ZERO;
    let mut way: Option<([R; 3], [R; 3])> = None;
    for joint in joints {
        let [low, high] = joint.limits;
        let most = low.abs().max_or_nan(high.abs());
        if joint.is_slide() {
            length += most;
            continue;
        }
        let pitch = joint.pitch().abs();
        if pitch > R::ZERO && most.is_finite() {
            length += pitch * most;
        }
        let axis = joint.screw.angular;
        let nearest_origin = vector::cross(axis, joint.screw.linear);
        let (first, last) = way.unwrap_or((nearest_origin, nearest_origin));
        let along = vector::scale(axis, vector::dot(axis, last));
        let next = vector::add(nearest_origin, along);
        length += vector::norm(vector::sub(next, last));
        way = Some((if way.is_some() { first } else { next }, next));
    }
    let (first, last) = way.unwrap_or((end, end));
    (first, length + vector::norm(vector::sub(end, last)))
}
