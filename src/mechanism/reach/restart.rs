//! Other beginnings for lanes that got stuck.
//!
//! A restart draws [`CANDIDATES`] configurations from a sequence of low discrepancy within the limits (the
//! additive recurrence of arms), all different from those before, and takes the one whose links are nearest
//! to the targets. The other lanes help to compute them. What has no ends stays as it was at the start.

use super::forward::Of;
use super::model::Model;
use crate::ik::Range;
use crate::real::{Real, Scalar};
use dq8_simd::{Lanes, MAX_LANES};

/// How many are compared: as many for any lanes, so that all come to the same result.
const CANDIDATES: usize = 4 * MAX_LANES;

impl<L: Lanes<Real: Scalar>> Model<'_, L> {
    /// Puts a lane at the nearest of the candidates of its restart number `restart`. What has been computed of
    /// the poses of other lanes is lost.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn begin_again(&mut self, lane: usize, restart: u32) {
        let mut nearest = None;
        for first in (0..CANDIDATES).step_by(L::LANES) {
            self.draw(lane, u64::from(restart) * CANDIDATES as u64 + first as u64);
            self.place(Of::Candidates);
            let squares = self.compare(Some(lane)).square.to_array();
            let mut picked = None;
            for (index, &square) in squares.as_ref().iter().enumerate() {
                if nearest.is_none_or(|nearest| square < nearest) {
                    (nearest, picked) = (Some(square), Some(index));
                }
            }
            if let Some(picked) = picked {
                let scratch = &mut self.scratch;
                for value in 0..self.reach.mechanism.values {
                    scratch.values.set_number(value, lane, scratch.candidate.number(value, picked));
                }
            }
        }
    }

    /// Puts a lane where it was nearest.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn go_back(&mut self, lane: usize) {
        let scratch = &mut self.scratch;
        for value in 0..self.reach.mechanism.values {
            scratch.values.set_number(value, lane, scratch.best.number(value, lane));
        }
    }

    /// Candidates from number `first` on, one in each lane, for a lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn draw(&mut self, lane: usize, first: u64) {
        let scratch = &mut self.scratch;
        for value in 0..self.reach.mechanism.values {
            let start = L::splat(self.level, scratch.start.number(value, lane));
            scratch.candidate.set(value, start);
        }
        for freedom in self.reach.freedoms {
            if freedom.share > 0.0 {
                let Range { low, high, .. } = freedom.range;
                for index in 0..L::LANES {
                    let number = (first + index as u64 + 1) as f64;
                    let share = 0.5 + number * freedom.share;
                    let share = <L::Real as Real>::from_f64(share - share as u64 as f64);
                    let value = low + (high - low) * share;
                    scratch.candidate.set_number(freedom.value as usize, index, value);
                }
            }
        }
    }
}
