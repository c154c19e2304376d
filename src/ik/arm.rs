use super::error::ArmError;
use super::joint::{Joint, UNIT, chain};
use super::limits::Range;
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
    /// The way of each joint along its axis for a radian.
    pub(super) pitches: [R; N],
    pub(super) ranges: [Range<R>; N],
    pub(super) home: DualQuat<R>,
    /// A point that no joint moves sideways, and how far the end can be from it.
    pub(super) centre: [R; 3],
    pub(super) length: R,
    pub(super) seeds: [Seed<R, N>; SEEDS],
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
        let (mut joints, mut pitches, mut ranges) = (joints, [R::ZERO; N], [Range::NONE; N]);
        for index in 0..N {
            let (joint, pitch) = joints[index].checked(index)?;
            ranges[index] = Range::of(&joint, pitch, index)?;
            (joints[index], pitches[index]) = (joint, pitch);
        }
        if !home.is_unit(R::from(UNIT)) {
            return Err(ArmError::Home { norm: home.real().norm().into() });
        }
        // What is unit to rounding stays as it is, to the bit.
        let home = if home.is_normalized() { home } else { home.normalize() };
        let (centre, length) = span(&joints, &pitches, &ranges, home.translation());
        let seeds = seeds(&joints, &ranges, home);
        Ok(Self { joints, pitches, ranges, home, centre, length, seeds })
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
        (self.centre, self.length)
    }
}

/// [`Arm::reach_bound`]. A point on the axis of a hinge belongs to the links on both sides of it, so
/// the way to a point on the next axis is as long in every pose.
fn span<R: Real, const N: usize>(
    joints: &[Joint<R>; N],
    pitches: &[R; N],
    ranges: &[Range<R>; N],
    end: [R; 3],
) -> ([R; 3], R) {
    let mut length = R::ZERO;
    let mut way: Option<([R; 3], [R; 3])> = None;
    for ((joint, pitch), range) in joints.iter().zip(pitches).zip(ranges) {
        let most = range.low.abs().max_or_nan(range.high.abs());
        if joint.is_slide() {
            length += most;
            continue;
        }
        length += pitch.abs() * most;
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
