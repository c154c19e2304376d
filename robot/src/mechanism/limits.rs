//! The limits of values: of a joint, and of what mimics it.
//!
//! A joint that mimics another has limits of its own in many files, copied from its leader without the sign or the
//! factor between them. They bind the leader where they leave a part of its range. Where they would leave nothing, or one
//! value alone, the file cannot mean them, and the joint has none.

use super::step::Step;
use super::tree::Mechanism;
use dq8::storage::same_length;
use dq8::{Real, ShapeError};

/// The part of the `leader`'s range in which a follower, at `multiplier` times its value and `offset`, is within its own
/// limits. `None` if that is not more than one value.
pub(crate) fn shared<R: Real>(
    [low, high]: [R; 2],
    limits: [R; 2],
    multiplier: R,
    offset: R,
) -> Option<[R; 2]> {
    // NaN and infinities of a multiplier of zero share nothing.
    let [a, b] = limits.map(|limit| (limit - offset) / multiplier);
    let [least, most] = if a <= b { [a, b] } else { [b, a] };
    let low = if least > low { least } else { low };
    let high = if most < high { most } else { high };
    (multiplier != R::ZERO && low < high).then_some([low, high])
}

impl<R: Real> Step<R> {
    /// [`shared`] with the limits of this joint, which mimics another; all of the range if it has none.
    pub(crate) fn narrows(&self, range: [R; 2]) -> Option<[R; 2]> {
        match self.limits {
            Some(limits) => shared(range, limits, self.multiplier, self.offset),
            None => Some(range),
        }
    }
}

/// From −∞ to ∞.
pub(crate) fn endless<R: Real>() -> [R; 2] {
    [-R::ONE / R::ZERO, R::ONE / R::ZERO]
}

impl<R: Real> Mechanism<'_, R> {
    /// The least and the largest of each value, infinite where there is no limit: the limits of its joint, and of each joint
    /// that mimics it, as far as those leave more than one value of the range.
    ///
    /// ```
    /// use dq8::DualQuat;
    /// use dq8_robot::{Joint, OwnedMechanism};
    /// let finger = Joint::prismatic(None, DualQuat::IDENTITY, [0.0, 1.0, 0.0]).with_limits([0.0, 0.04]);
    /// let other = finger.with_limits([0.0, 0.06]).mimicking(0, 2.0, 0.0);
    /// let hand = OwnedMechanism::new(&[finger, other])?;
    /// let mut limits = [[0.0; 2]];
    /// hand.view().value_limits(&mut limits)?;
    /// assert_eq!(limits, [[0.0, 0.03]]); // where the other is at 0.06
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If there are not as many limits as values; nothing is written.
    pub fn value_limits(&self, limits: &mut [[R; 2]]) -> Result<(), ShapeError> {
        same_length("limits", limits.len(), self.values)?;
        limits.fill(endless());
        let slots = |step: &Step<R>| step.value as usize..step.value as usize + step.kind.values();
        for step in self.steps.iter().filter(|step| !step.mimics) {
            if let (Some(own), Some(slots)) = (step.limits, limits.get_mut(slots(step))) {
                slots.fill(own);
            }
        }
        for step in self.steps.iter().filter(|step| step.mimics) {
            if let Some(slot) = limits.get_mut(step.value as usize) {
                *slot = step.narrows(*slot).unwrap_or(*slot);
            }
        }
        Ok(())
    }
}
