//! Cosines and sines of one configuration: they come first, as many at a time as there are lanes
//! for.

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
    /// So many at a time. Where lanes hold one number, a loop that keeps its constants in
    /// registers, over fewer that may not be needed.
    const SOME: usize = if Native::<R>::LANES == 1 { 4 } else { 8 };

    #[inline(always)]
    pub(crate) fn new(values: &'v [R]) -> Self {
        Self { values, first: 0, cos: [R::NAN; 8], sin: [R::NAN; 8] }
    }

    /// From the values of a step on, at once: nothing else can be computed before. Where they are:
    /// a copy of what has just been written in fours that overlap would wait for the memory.
    #[inline(always)]
    pub(crate) fn begin(&mut self, step: Option<&Step<R>>) {
        let index = step.map_or(0, |step| step.value as usize);
        if Native::<R>::LANES == 1 {
            self.compute_others(index);
        } else {
            self.compute(index);
        }
    }

    /// Cosine and sine of half of value number `index`.
    #[inline(always)]
    pub(crate) fn half_turn(&mut self, index: usize) -> [R; 2] {
        if index.wrapping_sub(self.first) >= Self::SOME {
            self.compute_others(index);
        }
        let at = index.wrapping_sub(self.first) % Self::SOME;
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
            let rest = self.values.get(index..).unwrap_or_default();
            let turns = self.cos.iter_mut().zip(&mut self.sin).take(Self::SOME);
            for ((cos, sin), &value) in turns.zip(rest) {
                [*cos, *sin] = half_turn_of(value);
            }
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
