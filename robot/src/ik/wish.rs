//! The way to the preferred posture.

use super::model::Model;
use dq8::batch::half_turns;
use dq8::batch::vector;
use dq8::{Real, Scalar};
use dq8_simd::Lanes;

/// No wish is longer than this part of the longest step: what the goals leave free is so only nearby. A planar
/// arm of five hinges ends where its point allows nothing nearer from 49 of 50 starts in 25 iterations; with a
/// quarter from 48 in 45, with the whole from 45 in 17.
const SHORTER: f64 = 0.5;

impl<L: Lanes<Real: Scalar>> Model<'_, L> {
    /// The way of each freedom to the posture, or to the limit before it, in radians; the shorter one for hinges
    /// that turn endlessly; no longer than a part of a step may be. The square of all of it.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn wish(&mut self) -> L {
        let (level, reach, scales) = (self.level, self.reach, self.scales);
        let zero = L::splat(level, L::Real::ZERO);
        let (mut square, mut most) = (zero, scales.longest * zero.constant(SHORTER));
        let Some(posture) = reach.posture else { return zero };
        for (index, freedom) in reach.freedoms.iter().enumerate() {
            let mut way = zero;
            if let (true, Some(&value)) = (freedom.is_single(), posture.get(freedom.value as usize))
            {
                let here = self.scratch.values.get(level, freedom.value as usize);
                let value = L::splat(level, value);
                if freedom.range.wraps() {
                    let (_, rest) = half_turns((value - here) * zero.constant(0.5));
                    way = rest + rest;
                } else {
                    way = freedom.range.clamp(value) - here;
                }
            }
            if freedom.is_slide() {
                way = way * scales.radians_per_length;
            }
            // A way too long for a float leads nowhere.
            way = L::select(vector::is_finite(way), way, zero);
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

    /// Lanes that have not arrived forget the posture: it would draw them off.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn keep_wishes(&mut self, arrived: L::Mask) {
        let wishes = if self.reach.posture.is_some() { self.reach.freedoms.len() } else { 0 };
        for index in 0..wishes {
            let wish = self.scratch.wishes.get(self.level, index);
            self.scratch.wishes.set(index, L::select(arrived, wish, wish.constant(0.0)));
        }
    }
}
