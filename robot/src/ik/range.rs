//! Joint values within the limits of their joints.

use dq8::batch::{half_turns, vector};
use dq8::{Real, Scalar};
use dq8_simd::Lanes;

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
