//! Joint values within the limits of their joints.

use crate::batch::even::half_turns;
use crate::batch::vector;
use crate::real::{Real, Scalar};
use dq8_simd::Lanes;

/// Hinges that may turn farther than this are endless. At half of it, eight turns from zero, a float
/// in single precision is still finer than the tolerance of 10⁻⁵ that is the default.
const ENDLESS_TURNS: f32 = 16.0;

/// The values that a search gives a joint.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Range<R> {
    pub(crate) low: R,
    pub(crate) high: R,
    /// Whether the ends stop nothing, because a turn less is the same pose and within them.
    pub(crate) wraps: bool,
}

impl<R: Real> Range<R> {
    /// Zero alone.
    pub(crate) const NONE: Self = Self { low: R::ZERO, high: R::ZERO, wraps: false };

    /// The limits, and of an endless hinge the turn within them that is nearest to zero. `None` if they
    /// are not in order, or angles that a float does not tell.
    pub(crate) fn within([low, high]: [R; 2], is_hinge: bool, is_angle: bool) -> Option<Self> {
        let turn = R::TWO * R::PI;
        let wraps = is_hinge && high - low >= turn;
        let is_endless = wraps && high - low > R::from(ENDLESS_TURNS) * turn;
        let ends = if is_endless { turn_nearest_to_zero(low, high) } else { [low, high] };
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
        Some(Self { low, high, wraps })
    }
}

impl<R: Real> Range<R> {
    /// Whether both ends are numbers.
    pub(super) fn is_finite(&self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }
}

fn turn_nearest_to_zero<R: Real>(low: R, high: R) -> [R; 2] {
    let centre = if low > -R::PI {
        low + R::PI
    } else if high < R::PI {
        high - R::PI
    } else {
        R::ZERO
    };
    let (first, last) = (centre - R::PI, centre + R::PI);
    // Rounding may have left the limits.
    [if first < low { low } else { first }, if last > high { high } else { last }]
}

impl<R: Scalar> Range<R> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn ends<L: Lanes<Real = R>>(&self, level: L::Level) -> [L; 2] {
        vector::splat(level, [self.low, self.high])
    }

    /// The same pose within the range where a joint wraps, the nearest value elsewhere.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn enter<L: Lanes<Real = R>>(&self, value: L) -> L {
        let [low, high] = self.ends(value.level());
        let outside = value.lt(low) | high.lt(value);
        let entered = if self.wraps {
            let half = value.constant(0.5);
            let centre = (low + high) * half;
            let (_, rest) = half_turns((value - centre) * half);
            L::select(outside, (rest + rest) + centre, value)
        } else {
            value
        };
        self.clamp(entered)
    }

    /// Where a step to `value` leads: a joint that wraps goes on a turn less.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn go_on<L: Lanes<Real = R>>(&self, value: L) -> L {
        if !self.wraps {
            return self.clamp(value);
        }
        let [low, high] = self.ends(value.level());
        let turn = value.constant(core::f64::consts::TAU);
        let value = L::select(value.lt(low), value + turn, value);
        self.clamp(L::select(high.lt(value), value - turn, value))
    }

    /// The nearest value within the range.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn clamp<L: Lanes<Real = R>>(&self, value: L) -> L {
        let [low, high] = self.ends(value.level());
        let value = L::select(value.lt(low), low, value);
        L::select(high.lt(value), high, value)
    }
}
