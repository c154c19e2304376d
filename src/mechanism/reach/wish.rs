//! The way to the preferred posture.

use super::model::Model;
use crate::real::{Real, Scalar};
use dq8_simd::Lanes;

/// No wish is longer than this part of the longest step: what the goals leave free is so only nearby.
const SHORTER: f64 = 0.25;

impl<L: Lanes<Real: Scalar>> Model<'_, L> {
    /// The way of each freedom to the posture, in radians, the shorter one for hinges that turn endlessly; no
    /// longer than a step may be. The square of all of it.
    #[inline(always)]
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
                way = L::splat(level, value) - here;
                if freedom.range.wraps {
                    let (half, turn) =
                        (L::splat(level, L::Real::PI), zero.constant(core::f64::consts::TAU));
                    way = L::select(half.lt(way), way - turn, way);
                    way = L::select(way.lt(-half), way + turn, way);
                }
            }
            if freedom.is_slide() {
                way = way * scales.radians_per_length;
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
}
