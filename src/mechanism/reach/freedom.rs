//! What a search may change: the rates of joints that move a goal.

use super::error::ReachError;
use crate::ik::{Range, ratio};
use crate::mechanism::joint::JointKind;
use crate::mechanism::step::{NONE, Step};
use crate::real::Real;

/// A rate of a mechanism as a search uses it, in the memory that a [`Reach`](super::Reach) borrows.
#[derive(Clone, Copy, Debug)]
pub struct Freedom<R> {
    pub(super) kind: Kind,
    pub(super) range: Range<R>,
    /// Where its value is; of a floating joint, the first of the seven.
    pub(super) value: u32,
    /// How much farther in its range every next beginning is, as a part of it; zero where the range has
    /// no end.
    pub(super) share: f64,
    /// Of the freedom for this rate, its place among those that move a goal.
    pub(super) column: u32,
}

/// What changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// An angle.
    Turn,
    /// A length.
    Slide,
    /// The rotation of a floating joint, about an axis of its link.
    FloatingTurn(u8),
    /// Its translation, along one.
    FloatingSlide(u8),
}

impl<R: Real> Default for Freedom<R> {
    /// Memory to be written.
    fn default() -> Self {
        Self { kind: Kind::Turn, range: Range::NONE, value: NONE, share: 0.0, column: NONE }
    }
}

impl<R: Real> Freedom<R> {
    /// Whether a change is a length.
    #[inline(always)]
    pub(super) fn is_slide(&self) -> bool {
        matches!(self.kind, Kind::Slide | Kind::FloatingSlide(_))
    }

    /// The lengths among its values.
    pub(super) fn lengths<'v>(&self, values: &'v [R]) -> &'v [R] {
        let first = self.value as usize;
        let (first, count) = if self.kind == Kind::Slide { (first, 1) } else { (first + 4, 3) };
        values.get(first..first + count).unwrap_or_default()
    }

    /// Rate number `index` of a joint.
    fn of(step: &Step<R>, index: usize) -> Result<Self, ReachError> {
        let whole = [-R::ONE / R::ZERO, R::ONE / R::ZERO];
        let (kind, is_hinge, value) = match step.kind {
            JointKind::Prismatic { .. } => (Kind::Slide, false, 0),
            JointKind::Planar { .. } if index < 2 => (Kind::Slide, false, index),
            JointKind::Floating if index < 3 => (Kind::FloatingTurn(index as u8), false, 0),
            JointKind::Floating => (Kind::FloatingSlide(index as u8 - 3), false, 0),
            JointKind::Screw { pitch, .. } => (Kind::Turn, pitch == R::ZERO, 0),
            _ => (Kind::Turn, true, index),
        };
        let limits = step.limits.unwrap_or(whole);
        let range = Range::within(limits, is_hinge, kind == Kind::Turn)
            .ok_or_else(|| limits_error(step, limits))?;
        let value = step.value.saturating_add(value as u32);
        Ok(Self { kind, range, value, share: 0.0, column: NONE })
    }
}

/// One for each rate; in the first of them, those that move a goal. How many these are.
pub(super) fn freedoms<R: Real>(
    steps: &[Step<R>],
    freedoms: &mut [Freedom<R>],
    carries: impl Fn(usize) -> bool,
) -> Result<usize, ReachError> {
    for step in steps.iter().filter(|step| !step.mimics) {
        for index in 0..step.kind.rates() {
            if let Some(slot) = freedoms.get_mut(step.rate as usize + index) {
                *slot = Freedom::of(step, index)?;
            }
        }
    }
    for (position, step) in steps.iter().enumerate() {
        let Some(slot) = freedoms.get_mut(step.rate as usize) else { continue };
        if step.mimics {
            slot.range = narrowed(slot.range, step)?;
        }
        if carries(position) {
            let rates = step.rate as usize..step.rate as usize + step.kind.rates();
            for slot in freedoms.get_mut(rates).unwrap_or_default() {
                slot.column = 0;
            }
        }
    }
    let mut count = 0;
    for rate in 0..freedoms.len() {
        let Some(&freedom) = freedoms.get(rate) else { continue };
        if freedom.column == NONE {
            continue;
        }
        if let Some(slot) = freedoms.get_mut(count) {
            *slot = Freedom { column: slot.column, ..freedom };
        }
        if let Some(slot) = freedoms.get_mut(rate) {
            slot.column = count as u32;
        }
        count += 1;
    }
    spread(freedoms.get_mut(..count).unwrap_or_default());
    Ok(count)
}

/// Values of low discrepancy, as for arms (Roberts 2018), where ranges have two ends.
fn spread<R: Real>(freedoms: &mut [Freedom<R>]) {
    let has_ends = |freedom: &Freedom<R>| {
        let Range { low, high, .. } = freedom.range;
        low.is_finite() && high.is_finite()
    };
    let factor = 1.0 / ratio(freedoms.iter().filter(|freedom| has_ends(freedom)).count());
    let mut power = 1.0;
    for freedom in freedoms {
        if has_ends(freedom) {
            power *= factor;
            freedom.share = power;
        }
    }
}

/// What the limits of a joint that mimics leave of the range of the other.
fn narrowed<R: Real>(range: Range<R>, step: &Step<R>) -> Result<Range<R>, ReachError> {
    let Some(limits) = step.limits.filter(|_| step.multiplier != R::ZERO) else { return Ok(range) };
    let [a, b] = limits.map(|limit| (limit - step.offset) / step.multiplier);
    let [low, high] = if a <= b { [a, b] } else { [b, a] };
    let low = if low > range.low { low } else { range.low };
    let high = if high < range.high { high } else { range.high };
    let wraps = range.wraps && low == range.low && high == range.high;
    if low <= high { Ok(Range { low, high, wraps }) } else { Err(limits_error(step, limits)) }
}

fn limits_error<R: Real>(step: &Step<R>, [low, high]: [R; 2]) -> ReachError {
    ReachError::Limits { joint: step.link as usize, low: low.into(), high: high.into() }
}
