//! Other beginnings for lanes that got stuck.
//!
//! A restart draws [`CANDIDATES`] configurations from a sequence of low discrepancy within the
//! limits, all different from those before, and takes the one whose links are nearest to the
//! targets. The other lanes help to compute them. What has no ends stays as it was at the start.

use super::forward::Of;
use super::lane::Lane;
use super::model::Model;
use dq8::Scalar;
use dq8_simd::{Lanes, MAX_LANES};

/// How many are compared: as many for any lanes, so that all come to the same result. With half as
/// many, fewer than 998 of 1,000 random targets of an arm of seven axes are reached.
const CANDIDATES: usize = 4 * MAX_LANES;

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Model<'_, L, TRACK> {
    /// Puts a lane at the nearest of the candidates of its next restart. What has been computed of
    /// the poses of other lanes is lost.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn begin_again(&mut self, lane: usize, search: &mut Lane<L::Real>) {
        let restart = search.restarts;
        search.restarts += 1;
        let mut nearest = None;
        for first in (0..CANDIDATES).step_by(L::LANES) {
            // Numbers that no other restart has. They depend on the restart alone, neither on the
            // lane nor on how many lanes there are, so that results do not either.
            self.draw(lane, u64::from(restart) * CANDIDATES as u64 + first as u64);
            self.place_or_call(Of::Candidates);
            let squares = self.compare(Some(lane)).square.to_array();
            let mut picked = None;
            for (index, &square) in squares.as_ref().iter().enumerate() {
                if nearest.is_none_or(|nearest| square < nearest) {
                    (nearest, picked) = (Some(square), Some(index));
                }
            }
            // At once: the next ones overwrite these.
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
            // What has no ends has no share of the sequence.
            if freedom.share > 0 {
                for index in 0..L::LANES {
                    let value = freedom.beginning(first + index as u64 + 1);
                    scratch.candidate.set_number(freedom.value as usize, index, value);
                }
            }
        }
    }
}
