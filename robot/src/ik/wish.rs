//! The way to the preferred posture.

use super::freedom::Freedom;
use super::model::Model;
use dq8::batch::{half_turns, vector};
use dq8::{Real, Scalar};
use dq8_simd::Lanes;

/// No wish is longer than this part of the longest step: what the goals leave free is so only
/// nearby. A planar arm of five hinges ends where its point allows nothing nearer from 49 of 50
/// starts in 25 iterations; with a quarter from 48 in 45, with the whole from 45 in 17.
const SHORTER: f64 = 0.5;

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// The way of each freedom to the posture, or to the limit before it, in radians; the shorter
    /// one for hinges that turn endlessly; no longer than a part of a step may be. The square of
    /// all of it.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn wish(&mut self) -> L {
        let (level, reach, scales) = (self.level, self.reach, self.scales);
        let zero = L::splat(level, L::Real::ZERO);
        if self.weighs() {
            return self.weighed_wish();
        }
        let (mut square, mut most) = (zero, scales.longest * zero.constant(SHORTER));
        let Some(posture) = reach.posture else { return zero };
        for (index, freedom) in reach.freedoms.iter().enumerate() {
            let mut way = zero;
            if let Some(&value) = posture.get(freedom.value as usize) {
                way = self.way_to(freedom, L::splat(level, value));
            }
            self.scratch.wishes.set(index, way);
            square = way.mul_add(way, square);
            most = L::select(most.lt(way.abs()), way.abs(), most);
        }
        let shrink = scales.longest * zero.constant(SHORTER) / most;
        for index in 0..reach.freedoms.len() {
            self.scratch.wishes.set(index, self.scratch.wishes.get(level, index) * shrink);
        }
        square
    }

    /// The way of a freedom to a value, in radians; none of what floats.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn way_to(&self, freedom: &Freedom<L::Real>, value: L) -> L {
        let zero = value.constant(0.0);
        if !freedom.is_single() {
            return zero;
        }
        let here = self.scratch.values.get(self.level, freedom.value as usize);
        let mut way = if freedom.range.wraps() {
            let (_, rest) = half_turns((value - here) * zero.constant(0.5));
            rest + rest
        } else {
            freedom.range.clamp(value) - here
        };
        if freedom.is_slide() {
            way = way * self.scales.radians_per_length;
        }
        // A way too long for a float leads nowhere.
        L::select(vector::is_finite(way), way, zero)
    }

    /// The sum of the ways to the posture and back to the start, by the squares of their weights.
    /// Of the squares of both as much.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn weighed_wish(&mut self) -> L {
        let (level, reach) = (self.level, self.reach);
        let [to_posture, to_start] = [self.follows.posture, self.follows.start];
        let mut square = to_start.constant(0.0);
        for (index, freedom) in reach.freedoms.iter().enumerate() {
            let row = freedom.value as usize;
            let way = self.way_to(freedom, self.scratch.start.get(level, row));
            let mut wish = way * to_start;
            square = way.mul_add(wish, square);
            if let Some(&value) = reach.posture.and_then(|posture| posture.get(row)) {
                let way = self.way_to(freedom, L::splat(level, value));
                let asked = way * to_posture;
                (square, wish) = (way.mul_add(asked, square), wish + asked);
            }
            self.scratch.wishes.set(index, wish);
        }
        square
    }

    /// Lanes that have not arrived forget the posture, which would draw them off, unless it has a
    /// weight: then a wish is a part of the damping.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn keep_wishes(&mut self, arrived: L::Mask, damping: L) {
        if self.weighs() {
            for index in 0..self.reach.freedoms.len() {
                let wish = self.scratch.wishes.get(self.level, index);
                self.scratch.wishes.set(index, wish / damping);
            }
            return;
        }
        let wishes = if self.reach.posture.is_some() { self.reach.freedoms.len() } else { 0 };
        for index in 0..wishes {
            let wish = self.scratch.wishes.get(self.level, index);
            self.scratch.wishes.set(index, L::select(arrived, wish, wish.constant(0.0)));
        }
    }
}
