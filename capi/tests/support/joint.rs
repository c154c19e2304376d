//! A joint as C describes it.

use dq8::Real;
use dq8_capi::joint::{Joint, JointKind};

/// A joint at the origin of the link `parent`, about z; numbers that its kind does not name are 0.
pub(crate) fn joint<R: Real>(parent: i32, kind: JointKind) -> Joint<R> {
    let (zero, one) = (R::ZERO, R::ONE);
    Joint {
        parent,
        kind: kind as i32,
        placement: [zero, zero, zero, one, zero, zero, zero, zero],
        axis: [zero, zero, one],
        pitch: zero,
        mimics: 0,
        leader: 0,
        multiplier: zero,
        offset: zero,
        limited: 0,
        limits: [zero; 2],
    }
}
