//! Cosines and sines of one configuration: they come first, as many at a time as there are lanes for.

use super::step::Step;
use super::values::half_turn;
use dq8::Real;
use dq8::seams::Number;
use dq8_simd::{Float, Lanes, Portable, Unfused};

pub(crate) const LEVEL: Unfused<Portable> = Unfused(Portable);
/// Eight angles.
type Eight<R> = <R as Float>::Packed<Unfused<Portable>>;
/// What a register holds.
type Native<R> = <R as Float>::Lanes<Unfused<Portable>>;

/// The values, and cosine and sine of half of some that follow each other.
pub(crate) struct Turns<'v, R> {
    pub(crate) values: &'v [R],
    first: usize,
    cos: [R; 8],
    sin: [R; 8],
}

impl<'v, R: Real + Number> Turns<'v, R> {
    #[inline(always)]
    pub(crate) fn new(values: &'v [R]) -> Self {
        Self { values, first: 0, cos: [R::ZERO; 8], sin: [R::ZERO; 8] }
    }

    /// From the values of a step on, at once: nothing else can be computed before. Where they are: a copy of what has just
    /// been written in fours that overlap would wait for the memory.
    #[inline(always)]
    pub(crate) fn begin(&mut self, step: Option<&Step<R>>) {
        self.compute(step.map_or(0, |step| step.value as usize));
    }

    /// Cosine and sine of half of value number `index`.
    #[inline(always)]
    pub(crate) fn half_turn(&mut self, index: usize) -> [R; 2] {
        // One at a time, where lanes hold one number.
        let some = if Native::<R>::LANES == 1 { 1 } else { 8 };
        if index.wrapping_sub(self.first) >= some {
            self.compute_others(index);
        }
        let at = index.wrapping_sub(self.first) % some;
        [self.cos[at], self.sin[at]]
    }

    #[cold]
    #[inline(never)]
    fn compute_others(&mut self, index: usize) {
        self.compute(index);
    }

    /// Those of this value and of as many of the next ones as there are.
    #[inline(always)]
    fn compute(&mut self, index: usize) {
        if Native::<R>::LANES == 1 {
            self.first = index;
            let value = self.values.get(index).copied().unwrap_or(R::NAN);
            [self.cos[0], self.sin[0]] = half_turn_of(value);
            return;
        }
        self.first = index.min(self.values.len().saturating_sub(4));
        let rest = self.values.get(self.first..).unwrap_or_default();
        // The last four again, rather than fewer than four.
        let second = rest.len().wrapping_sub(4).min(4);
        let high = rest.get(second..).and_then(<[R]>::first_chunk::<4>);
        let some = match (rest.first_chunk::<4>(), high) {
            (Some(&[a, b, c, d]), Some(&[e, f, g, h])) => {
                Eight::<R>::load(LEVEL, &[a, b, c, d, e, f, g, h])
            }
            _ => Eight::<R>::load_partial(LEVEL, rest, R::ZERO),
        };
        let [cos, sin] = half_turn(some * some.constant(0.5));
        for (to, from) in [(&mut self.cos, cos.to_array()), (&mut self.sin, sin.to_array())] {
            to[..4].copy_from_slice(&from[..4]);
            to[second..][..4].copy_from_slice(&from[4..]);
        }
    }
}

/// Cosine and sine of half an angle.
pub(crate) fn half_turn_of<R: Real + Number>(angle: R) -> [R; 2] {
    let angle = Native::<R>::splat(LEVEL, angle);
    half_turn(angle * angle.constant(0.5)).map(|of| of.to_array().as_ref()[0])
}
