//! Arms of six hinges, and what can be asked of them.

use super::error::SolutionsError;
use super::family::{Family, Geometry};
use super::problem::Reach;
use super::starts;
use crate::mechanism::step::UNIT;
use dq8::{DualQuat, Real};

/// An arm of six hinges that carries the only goal of a [`Reach`], a whole pose: what it is, found
/// once, to say all of the ways in which it reaches a target.
///
/// Arms of two [families](Family), which nearly all of industry is made of, have up to eight, and
/// all of them are found, by formula. A turn of a hinge more or less is no other way: of those
/// within the limits the nearest to the start is given. Each is checked by the mechanism itself,
/// which is then at the target but for rounding; so a target may be out of reach by 64 units of the
/// last place (2⁻⁵² or 2⁻²³) of the arm's size. For other arms there are searches from
/// many starts: some 99 of 100 are found. Where axes miss a family by 10⁻³ at most, as of arms
/// whose angles were typed with few digits, the starts are what its formula finds, which are far
/// fewer.
///
#[doc = include_str!("six_axes.svg")]
///
/// ```
/// use dq8::DualQuat;
/// use dq8_robot::ik::{Family, Goal, OwnedReach, SixAxisArm};
/// use dq8_robot::{Joint, OwnedMechanism};
/// // A UR5, stretched along x where all values are zero.
/// let (y, z) = ([0.0_f64, 1.0, 0.0], [0.0, 0.0, 1.0]);
/// let hinges = [
///     (z, [0.0, 0.0, 0.0892]),
///     (y, [0.0, 0.1358, 0.0]),
///     (y, [0.425, -0.1197, 0.0]),
///     (y, [0.3922, 0.0, 0.0]),
///     ([0.0, 0.0, -1.0], [0.0, 0.093, 0.0]),
///     (y, [0.0, 0.0, -0.0947]),
/// ];
/// let mut joints: Vec<_> = (0_usize..6)
///     .map(|i| (i.checked_sub(1), DualQuat::from_translation(hinges[i].1), hinges[i].0))
///     .map(|(on, at, axis)| Joint::revolute(on, at, axis).with_limits([-6.28, 6.28]))
///     .collect();
/// joints.push(Joint::fixed(Some(5), DualQuat::from_translation([0.0, 0.0823, 0.0])));
/// let reach = OwnedReach::new(OwnedMechanism::new(&joints)?, [Goal::pose(6)])?;
/// let arm = SixAxisArm::new(reach.view())?;
/// assert_eq!(arm.family(), Family::ThreeParallel);
///
/// let values = [0.4, -1.2, 1.5, -0.8, 1.1, 0.2];
/// let target = reach.view().mechanism().link_pose(&values, 6)?;
/// // The families need no memory to compute in.
/// let found = arm.solutions(target, &values, &mut [])?;
/// assert!(found.len() == 8 && found.is_complete && !found[0].singular.any());
/// assert!(found[0].distance < 1e-12 && found[1].distance > 0.1);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SixAxisArm<'a, R> {
    pub(super) reach: Reach<'a, R>,
    pub(super) geometry: Geometry<R>,
}

impl<'a, R: Real> SixAxisArm<'a, R> {
    /// Looks at the axes. Those that are to be parallel, or to meet, may be apart by 10⁻⁸
    /// radians and of the arm's size (`f32`: 10⁻⁵). A posture has no part in it.
    ///
    /// # Errors
    /// If there are other goals, or it is none of a whole pose, or what carries its link are not
    /// six hinges with values of their own and fixed joints.
    pub fn new(reach: Reach<'a, R>) -> Result<Self, SolutionsError> {
        let reach = Reach { posture: None, ..reach };
        Ok(Self { geometry: Geometry::of(&reach)?, reach })
    }

    /// How its axes lie.
    #[must_use]
    pub fn family(&self) -> Family {
        if self.geometry.is_exact() { self.geometry.family } else { Family::Other }
    }

    /// Where the values of the six hinges are among all of the mechanism.
    #[must_use]
    pub fn values(&self) -> [usize; 6] {
        let mut values = [0; 6];
        for (slot, freedom) in values.iter_mut().zip(self.reach.freedoms) {
            *slot = freedom.value as usize;
        }
        values
    }

    /// How many numbers [`solutions`](Self::solutions) needs to compute in: none for the two
    /// families.
    #[must_use]
    pub fn scratch_len(&self) -> usize {
        self.with_values(self.reach.scratch_len())
    }

    /// How many a [`SolutionsJob`](super::SolutionsJob) needs, with any instructions: none for the
    /// two families.
    #[must_use]
    pub fn batch_scratch_len(&self) -> usize {
        self.with_values(self.reach.batch_scratch_len())
    }

    fn with_values(&self, scratch: usize) -> usize {
        let is_other = self.family() == Family::Other;
        if is_other { scratch.saturating_add(starts::values(&self.reach)) } else { 0 }
    }
}

pub(super) fn check<R: Real>(
    targets: &[DualQuat<R>],
    starts: &[[R; 6]],
) -> Result<(), SolutionsError> {
    for (index, target) in targets.iter().enumerate() {
        for number in target.to_array() {
            if !number.is_finite() {
                return Err(SolutionsError::Target { index, value: number.into() });
            }
        }
        if !target.is_unit(R::from(UNIT)) {
            return Err(SolutionsError::NotUnit { index, norm: target.real().norm().into() });
        }
    }
    for (index, start) in starts.iter().enumerate() {
        for (hinge, value) in start.iter().enumerate() {
            if !value.is_finite() {
                return Err(SolutionsError::Start { index, hinge, value: (*value).into() });
            }
        }
    }
    Ok(())
}
