use super::error::ArmError;
use super::joint::{Joint, chain};
use crate::geometry::Twist;
use crate::mechanism::reach::{Chain, ChainError};
use crate::mechanism::{self, UNIT};
use crate::real::Real;
use crate::scalar::{DualQuat, vector};

/// A serial arm of `N` joints: exp(½ξ₁q₁) … exp(½ξ_N q_N) home (Brockett 1984; Lynch & Park, *Modern
/// Robotics*, 2017, eq. 4.14).
///
/// An arm holds 128 of its own poses, spread evenly over its joints, from which
/// [`reach`](Self::reach) begins again where it got stuck: `128(N + 7)` numbers.
#[derive(Clone, Debug)]
pub struct Arm<R, const N: usize> {
    joints: [Joint<R>; N],
    home: DualQuat<R>,
    /// The same as a mechanism.
    pub(super) chain: Chain<R, N>,
}

impl<R: Real, const N: usize> Arm<R, N> {
    /// From joints, the one at the base first, and the pose of the end where all of them are zero.
    ///
    /// Screws and pose are made exactly unit, so that numbers with four decimals will do.
    ///
    /// # Errors
    /// If the screw of a joint or `home` is farther from unit than 10⁻³, or limits are not in order, let
    /// what slides go without end, or are angles so large that a float does not tell them (beyond 2¹⁷
    /// radians for `f32`, 2⁴⁶ for `f64`; an endless hinge may have any).
    ///
    /// ```
    /// use dq8::ik::{Arm, ArmError, Joint};
    /// use dq8::DualQuat;
    /// let joint = Joint::revolute([0.0_f32, 0.0, 2.0], [0.0; 3]);
    /// let error = Arm::new([joint], DualQuat::IDENTITY).unwrap_err();
    /// assert_eq!(error, ArmError::Screw { joint: 0, angular: 2.0, linear: 0.0 });
    /// ```
    pub fn new(joints: [Joint<R>; N], home: DualQuat<R>) -> Result<Self, ArmError> {
        let (mut joints, mut pitches) = (joints, [R::ZERO; N]);
        for index in 0..N {
            (joints[index], pitches[index]) = joints[index].checked(index)?;
        }
        if !home.is_unit(R::from(UNIT)) {
            return Err(ArmError::Home { norm: home.real().norm().into() });
        }
        // What is unit to rounding stays as it is, to the bit.
        let home = if home.is_normalized() { home } else { home.normalize() };
        let (at, centre, length) = frames(&joints, &pitches, home.translation());
        let to = DualQuat::from_translation;
        let mut links = [mechanism::Joint::fixed(None, DualQuat::IDENTITY); N];
        let (mut parent, mut before) = (None, [R::ZERO; 3]);
        for ((link, joint), (&at, &pitch)) in
            links.iter_mut().zip(&joints).zip(at.iter().zip(&pitches))
        {
            let placement = to(vector::sub(at, before));
            *link = mechanism::Joint::new(parent, placement, joint.kind(pitch))
                .with_limits(joint.limits);
            (parent, before) = (Some(parent.map_or(0, |parent| parent + 1)), at);
        }
        let tool = to(vector::sub([R::ZERO; 3], before)) * home;
        let chain = Chain::new(&links, tool, (centre, length)).map_err(|error| {
            let named = match error {
                ChainError::Limits(index) => joints.get(index).map(|j| j.limits_error(index)),
                ChainError::Joint(index) => joints.get(index).map(|j| j.screw_error(index)),
                ChainError::Tool => None,
            };
            named.unwrap_or(ArmError::Home { norm: home.real().norm().into() })
        })?;
        Ok(Self { joints, home, chain })
    }

    /// The joints, the one at the base first, with unit screws.
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
        self.chain.bound()
    }
}

/// Where the joints are in a mechanism; and [`Arm::reach_bound`].
///
/// The frame of a hinge is at the point of its axis that is nearest to the frame before, that of a slide where
/// the frame before is. A point on the axis of a hinge belongs to the links on both sides of it, so the way to a
/// point on the next axis is as long in every pose.
fn frames<R: Real, const N: usize>(
    joints: &[Joint<R>; N],
    pitches: &[R; N],
    end: [R; 3],
) -> ([[R; 3]; N], [R; 3], R) {
    let nearest_to = |joint: &Joint<R>, point| {
        let Twist { angular: axis, linear } = joint.screw;
        let along = vector::scale(axis, vector::dot(axis, point));
        vector::add(vector::cross(axis, linear), along)
    };
    let first = joints.iter().find(|joint| !joint.is_slide());
    let first = first.map_or(end, |joint| nearest_to(joint, [R::ZERO; 3]));
    let (mut at, mut length, mut last) = ([first; N], R::ZERO, first);
    for ((at, joint), &pitch) in at.iter_mut().zip(joints).zip(pitches) {
        let most = joint.limits[0].abs().max_or_nan(joint.limits[1].abs());
        if joint.is_slide() {
            length += most;
        } else {
            // Limits of hinges may be infinite.
            length += if pitch == R::ZERO { R::ZERO } else { pitch.abs() * most };
            let next = nearest_to(joint, last);
            length += vector::norm(vector::sub(next, last));
            last = next;
        }
        *at = last;
    }
    (at, first, length + vector::norm(vector::sub(end, last)))
}
