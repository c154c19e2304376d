//! The limits of values: of a joint, and of what mimics it.
//!
//! A joint that mimics another has limits of its own in many files, copied from its leader without
//! the sign or the factor between them. They bind the leader where they leave a part of its range.
//! Where they would leave nothing, or one value alone, the file cannot mean them, and the joint has
//! none.

use super::step::Step;
use dq8::Real;

/// The part of the `leader`'s range in which a follower, at `multiplier` times its value and
/// `offset`, is within its own limits. `None` if that is not more than one value.
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
    /// [`shared`] with the limits of this joint, which mimics another; all of the range if it has
    /// none.
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
