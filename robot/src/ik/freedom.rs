//! Freedoms: the rates that a search may change, and the values within the limits of each.

use super::problem::ReachError;
use crate::mechanism::joint::JointKind;
use crate::mechanism::step::endless;
use crate::mechanism::step::{NONE, Step};
use dq8::batch::{half_turns, vector};
use dq8::{Real, Scalar};
use dq8_simd::Lanes;

/// A rate of a mechanism as a search uses it, in the memory that a [`Reach`](super::Reach) borrows.
#[derive(Clone, Copy, Debug)]
pub struct Freedom<R> {
    pub(super) kind: Kind,
    pub(super) range: Range<R>,
    /// Where its value is; of a floating joint, the first of the seven.
    pub(super) value: u32,
    /// How much farther in its range every next beginning is, in 2⁻⁶⁴ of it; zero where the
    /// range has no end.
    pub(super) share: u64,
    /// Of the freedom for this rate, its place among those that move a goal.
    pub(super) column: u32,
    /// The freedom that carries it, how many carry it in all, the first of its entries in the
    /// system of the tree, and the first row of its twist.
    pub(super) above: u32,
    pub(super) depth: u32,
    pub(super) first: u32,
    pub(super) twist: u32,
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
        Self {
            kind: Kind::Turn,
            range: Range::NONE,
            value: NONE,
            share: 0,
            column: NONE,
            above: NONE,
            depth: 0,
            first: 0,
            twist: 0,
        }
    }
}

impl<R: Real> Freedom<R> {
    /// Whether its value is one number.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn is_single(&self) -> bool {
        matches!(self.kind, Kind::Turn | Kind::Slide)
    }

    /// Whether a change is a length.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn is_slide(&self) -> bool {
        matches!(self.kind, Kind::Slide | Kind::FloatingSlide(_))
    }

    /// Whether its range has two ends, and values between them can be told apart.
    pub(super) fn has_ends(&self) -> bool {
        let Range { low, high, .. } = self.range;
        (high - low).is_finite()
    }

    /// Its value in beginning number `number` of those that are spread evenly.
    pub(super) fn beginning(&self, number: u64) -> R {
        // Modulo 1 is what is left of a product that overflows. Its parts are numbers of any float.
        let share = HALF.wrapping_add(number.wrapping_mul(self.share));
        let (unit, mut sum) = (R::from(1.0 / 65_536.0), R::ZERO);
        for shift in [16, 32, 48] {
            sum = (sum + R::from(f32::from((share >> shift) as u16))) * unit;
        }
        let [low, high] = self.range.beginnings();
        low + (high - low) * sum
    }

    /// Rate number `index` of a joint, with the limits of the joint.
    #[inline(never)]
    fn of(step: &Step<R>, index: usize) -> Self {
        let (kind, is_hinge, value) = match step.kind {
            JointKind::Prismatic { .. } => (Kind::Slide, false, 0),
            JointKind::Planar { .. } if index < 2 => (Kind::Slide, false, index),
            JointKind::Floating if index < 3 => (Kind::FloatingTurn(index as u8), false, 0),
            JointKind::Floating => (Kind::FloatingSlide(index as u8 - 3), false, 0),
            JointKind::Screw { pitch, .. } => (Kind::Turn, pitch == R::ZERO, 0),
            _ => (Kind::Turn, true, index),
        };
        let [low, high] = step.limits.unwrap_or(endless());
        let turns = if is_hinge { Turns::Stop } else { Turns::Matter };
        let value = step.value.saturating_add(value as u32);
        let range = Range { low, high, turns };
        Self { kind, range, value, ..Self::default() }
    }
}

/// One for each rate; in the first of them, those that move a goal. How many these are.
pub(super) fn freedoms<R: Real>(
    steps: &[Step<R>],
    freedoms: &mut [Freedom<R>],
    carries: impl Fn(usize) -> bool,
) -> Result<usize, ReachError> {
    let leaders = || steps.iter().filter(|step| !step.mimics);
    for step in leaders() {
        for index in 0..step.kind.rates() {
            if let Some(slot) = freedoms.get_mut(step.rate as usize + index) {
                *slot = Freedom::of(step, index);
            }
        }
    }
    // Only those that carry a goal are columns of the system.
    for (position, step) in steps.iter().enumerate() {
        if carries(position) {
            let rates = step.rate as usize..step.rate as usize + step.kind.rates();
            for slot in freedoms.get_mut(rates).unwrap_or_default() {
                slot.column = 0;
            }
        }
    }
    // The limits of joints that move no goal do not matter, and of those that mimic neither: many
    // files have them wrong.
    for (_, step) in steps.iter().enumerate().filter(|(at, step)| step.mimics && carries(*at)) {
        if let Some(slot) = moving(freedoms, step.rate as usize) {
            slot.range = narrowed(slot.range, step);
        }
    }
    for step in leaders() {
        for index in 0..step.kind.rates() {
            if let Some(slot) = moving(freedoms, step.rate as usize + index) {
                let Range { low, high, turns } = slot.range;
                let (is_hinge, is_angle) = (turns != Turns::Matter, slot.kind == Kind::Turn);
                slot.range = Range::within([low, high], is_hinge, is_angle)
                    .ok_or_else(|| limits_error(step, [low, high]))?;
            }
        }
    }
    // The columns move to the front, in order; the slots of their rates say where they have gone. A
    // column is never behind its rate, so nothing is overwritten before it is read.
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

/// Values of low discrepancy, where ranges have two ends: the additive recurrence ½ + kα modulo 1
/// with αⱼ = g⁻ʲ, g the positive root of gᴺ⁺¹ = g + 1 for N of them, which generalises
/// the golden ratio (Roberts 2018). In integers: a controller has no `f64`, and `f32` would lose
/// what the numbers of later beginnings have in common.
fn spread<R: Real>(freedoms: &mut [Freedom<R>]) {
    let count = freedoms.iter().filter(|freedom| freedom.has_ends()).count();
    let factor = spacing(count);
    let mut power = factor;
    for freedom in freedoms.iter_mut().filter(|freedom| freedom.has_ends()) {
        freedom.share = power;
        power = times(power, factor);
    }
}

/// ½, in 2⁻⁶⁴.
const HALF: u64 = 1 << 63;

/// 1/g in 2⁻⁶⁴: the largest x for which xᴺ + xᴺ⁺¹ is less than 1, bit by bit.
fn spacing(count: usize) -> u64 {
    let mut x = 0;
    for bit in (0..64).rev() {
        let next = x | 1 << bit;
        let mut power = u64::MAX;
        for _ in 0..count {
            power = times(power, next);
        }
        if power.checked_add(times(power, next)).is_some() {
            x = next;
        }
    }
    x
}

/// The product of two numbers in 2⁻⁶⁴, but for three units: of 32 bits each, as controllers
/// multiply. Once in machine code.
#[inline(never)]
fn times(a: u64, b: u64) -> u64 {
    let low = |number: u64| number & u64::from(u32::MAX);
    let (high, cross) = ((a >> 32) * (b >> 32), [(a >> 32) * low(b), low(a) * (b >> 32)]);
    high + (cross[0] >> 32) + (cross[1] >> 32)
}

/// The freedom of a rate that moves a goal.
fn moving<R>(freedoms: &mut [Freedom<R>], rate: usize) -> Option<&mut Freedom<R>> {
    freedoms.get_mut(rate).filter(|freedom| freedom.column != NONE)
}

/// What the limits of a joint that mimics leave of the limits of the other. A turn less of that one
/// must be the same pose of this one too: it is a hinge that turns a whole number of times as much.
fn narrowed<R: Real>(range: Range<R>, step: &Step<R>) -> Range<R> {
    let is_hinge = match step.kind {
        JointKind::Screw { pitch, .. } => pitch == R::ZERO,
        kind => matches!(kind, JointKind::Revolute { .. }),
    };
    let keeps = is_hinge && is_whole(step.multiplier);
    let range = Range { turns: if keeps { range.turns } else { Turns::Matter }, ..range };
    match step.narrows([range.low, range.high]) {
        Some([low, high]) => Range { low, high, ..range },
        // Others have left no more than one value.
        None => range,
    }
}

/// Whether a number has no fraction: so far up, floats have none.
fn is_whole<R: Real>(number: R) -> bool {
    let shift = R::ONE / R::EPSILON;
    let size = number.abs();
    size >= shift || (size + shift) - shift == size
}

fn limits_error<R: Real>(step: &Step<R>, [low, high]: [R; 2]) -> ReachError {
    ReachError::Limits { joint: step.link as usize, low: low.into(), high: high.into() }
}

/// Hinges that may turn farther than this are endless.
const ENDLESS_TURNS: f32 = 16.0;
/// How far from zero those go in `f32`, radians: ten turns, where floats are 4e-6 apart, less than
/// the tolerance of 10⁻⁵ that is the default.
const FAR_SINGLE: f32 = 64.0;
/// And in `f64`, 2²⁰: 167,000 turns, where they are 10⁻¹⁰ apart.
const FAR_DOUBLE: f32 = 1_048_576.0;

/// The values that a search gives a joint.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Range<R> {
    pub(crate) low: R,
    pub(crate) high: R,
    pub(crate) turns: Turns,
}

/// What becomes of a joint where its value changes by a whole turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Turns {
    /// It is elsewhere.
    Matter,
    /// It is where it was, but there is no turn between its limits.
    Stop,
    /// It is where it was, so its limits stop nothing.
    GoOn,
    /// The same; and there are so many turns that it begins again in the one nearest to zero.
    Endless,
}

impl<R: Real> Range<R> {
    /// Zero alone.
    pub(crate) const NONE: Self = Self { low: R::ZERO, high: R::ZERO, turns: Turns::Matter };

    /// The limits, of an endless hinge as far as floats are fine enough. `None` if they are not in
    /// order, or angles that a float does not tell.
    pub(crate) fn within([low, high]: [R; 2], is_hinge: bool, is_angle: bool) -> Option<Self> {
        let turn = R::TWO * R::PI;
        let turns = match high - low {
            _ if !is_hinge => Turns::Matter,
            width if width > R::from(ENDLESS_TURNS) * turn => Turns::Endless,
            width if width >= turn => Turns::GoOn,
            _ => Turns::Stop,
        };
        let is_single = R::EPSILON > R::from(1e-10);
        let far = R::from(if is_single { FAR_SINGLE } else { FAR_DOUBLE });
        let ends = if turns == Turns::Endless { around_zero(low, high, far) } else { [low, high] };
        // Beyond 2¹⁷ radians (`f32`; `f64`: 2⁴⁶) lanes know no sine.
        let is_near = |value: R| value.abs() * R::from(64.0) * R::EPSILON <= R::ONE;
        let fits = |value: R| !is_angle || !value.is_finite() || is_near(value);
        // NaN is not in order.
        let is_range = low <= high && (low.is_finite() || low < R::ZERO);
        let is_range = is_range && (high.is_finite() || high > R::ZERO);
        if !(is_range && ends.into_iter().all(fits)) {
            return None;
        }
        let [low, high] = ends;
        Some(Self { low, high, turns })
    }

    /// Whether the ends stop nothing, because a turn less is the same pose and within them.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn wraps(&self) -> bool {
        matches!(self.turns, Turns::GoOn | Turns::Endless)
    }

    /// Where searches begin again.
    pub(super) fn beginnings(&self) -> [R; 2] {
        match self.turns {
            Turns::Endless => around_zero(self.low, self.high, R::PI),
            _ => [self.low, self.high],
        }
    }
}

/// What is within limits and not farther than `far` from zero, or else the turn within them that is
/// nearest to zero.
fn around_zero<R: Real>(low: R, high: R, far: R) -> [R; 2] {
    let turn = R::TWO * R::PI;
    let least = |a: R, b: R| if b < a { b } else { a };
    let most = |a: R, b: R| if b > a { b } else { a };
    [most(low, least(-far, high - turn)), least(high, most(far, low + turn))]
}

impl<R: Scalar> Range<R> {
    /// [`nearest`](Self::nearest) of a value that has been rounded once.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn keep<L: Lanes<Real = R>>(&self, value: L, to: L) -> L {
        self.nearest(value, to, Self::rounding(value))
    }

    /// What an angle is rounded by.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn rounding<L: Lanes<Real = R>>(value: L) -> L {
        (value.abs() + value.constant(4.0)) * value.constant(4.0 * vector::epsilon::<L>())
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn ends<L: Lanes<Real = R>>(&self, level: L::Level) -> [L; 2] {
        vector::splat(level, [self.low, self.high])
    }

    /// The value within the range where the joint is as it is at `value`, of several the nearest to
    /// `to`, which is within the range; the nearest value where there is none. Beyond an end by no
    /// more than `slack` it is at the end, and not a turn away.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn nearest<L: Lanes<Real = R>>(&self, value: L, to: L, slack: L) -> L {
        let clamped = self.clamp(value);
        if self.turns == Turns::Matter {
            return clamped;
        }
        let [low, high] = self.ends(value.level());
        let (turn, half) = (value.constant(core::f64::consts::TAU), value.constant(0.5));
        // What is near already keeps every bit.
        let way = value - to;
        let (_, rest) = half_turns(way * half);
        let is_far = (turn * half).lt(way.abs());
        let near = L::select(is_far, (rest + rest) + to, value);
        let near = L::select(near.lt(low) & low.le(near + slack), low, near);
        let near = L::select(high.lt(near) & (near - slack).le(high), high, near);
        // Half a turn from `to` is less than a turn beyond an end.
        let near = L::select(near.lt(low), near + turn, near);
        let near = L::select(high.lt(near), near - turn, near);
        L::select(low.le(near) & near.le(high), near, clamped)
    }

    /// Where a step from within the range to `value` ends at a limit: where no turn less is within
    /// it.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn stops<L: Lanes<Real = R>>(&self, value: L) -> L::Mask {
        let [low, high] = self.ends(value.level());
        let outside = value.lt(low) | high.lt(value);
        if self.turns == Turns::Matter {
            return outside;
        }
        let turn = value.constant(core::f64::consts::TAU);
        let (less, more) = (value - turn, value + turn);
        outside & (less.lt(low) | high.lt(less)) & (more.lt(low) | high.lt(more))
    }

    /// The nearest value within the range.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn clamp<L: Lanes<Real = R>>(&self, value: L) -> L {
        let [low, high] = self.ends(value.level());
        let value = L::select(value.lt(low), low, value);
        L::select(high.lt(value), high, value)
    }
}
