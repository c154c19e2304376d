//! Other beginnings for lanes that got stuck.
//!
//! A restart draws [`CANDIDATES`] configurations from a sequence of low discrepancy within the limits, all
//! different from those before, and takes the one whose links are nearest to the targets. The other lanes help to
//! compute them. What has no ends stays as it was at the start.
//!
//! An arm keeps the poses of [`KEPT`] configurations, and a restart takes the nearest that has not been taken.
//! Instead of a sorted list, which no lane could have for itself without memory, each lane remembers how far its
//! last one was, and looks for the nearest beyond it.

use super::beginnings::{Beginnings, KEPT};
use super::forward::{Of, put};
use super::lane::Lane;
use super::model::Model;
use super::scratch::TARGET;
use crate::mechanism::placed::Placed;
use crate::real::{Real, Scalar};
use dq8_simd::{Lanes, MAX_LANES};

/// How many are compared: as many for any lanes, so that all come to the same result.
const CANDIDATES: usize = 4 * MAX_LANES;

impl<L: Lanes<Real: Scalar>> Model<'_, L> {
    /// Puts a lane where it begins again, and says whether there is such a beginning. What has been computed of
    /// the poses of other lanes is lost.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn begin_again(&mut self, index: usize, lane: &mut Lane<L::Real>) -> bool {
        let begins = match self.reach.kept {
            Some(kept) => self.take_kept(index, lane, &kept),
            None => self.take_candidate(index, lane.restarts),
        };
        lane.restarts += u32::from(begins);
        begins
    }

    /// Of the poses that are farther from the target than the last one, the nearest.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn take_kept(
        &mut self,
        lane: usize,
        search: &mut Lane<L::Real>,
        kept: &Beginnings<'_, L::Real>,
    ) -> bool {
        // Kept poses take the place of computed ones, a lane each, and are compared with the target of one lane.
        let zero = L::splat(self.level, L::Real::ZERO);
        let (mut nearest, mut picked) = (None, 0);
        for first in (0..KEPT).step_by(L::LANES) {
            let mut pose = [zero; 7];
            for (lanes, row) in pose.iter_mut().zip(&kept.poses.0) {
                let mut array = zero.to_array();
                for (slot, &number) in array.as_mut().iter_mut().zip(row.iter().skip(first)) {
                    *slot = number;
                }
                *lanes = L::load(self.level, &array);
            }
            let [x, y, z, w, hx, hy, hz] = pose;
            let pose = Placed { rotation: [x, y, z, w], half: [hx, hy, hz] };
            put(&mut self.scratch.goals, TARGET, pose);
            let squares = self.compare(Some(lane)).square.to_array();
            for (index, &square) in squares.as_ref().iter().enumerate() {
                // Those up to the last one have been taken: the order is by distance. Of two at the same distance one is
                // passed over.
                let is_next = search.beginning.is_none_or(|last| last < square);
                if is_next && square < nearest.unwrap_or(L::Real::ONE / L::Real::ZERO) {
                    (nearest, picked) = (Some(square), first + index);
                }
            }
        }
        if nearest.is_none() {
            return false;
        }
        search.beginning = nearest;
        let count = self.reach.mechanism.values;
        let values = kept.values.get(picked * count..).unwrap_or_default();
        for (row, &value) in values.iter().enumerate().take(count) {
            self.scratch.values.set_number(row, lane, value);
        }
        true
    }

    /// Puts a lane at the nearest of the candidates of its restart number `restart`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn take_candidate(&mut self, lane: usize, restart: u32) -> bool {
        let mut nearest = None;
        for first in (0..CANDIDATES).step_by(L::LANES) {
            // Numbers that no other restart has. They depend on the restart alone, neither on the lane nor on how many
            // lanes there are, so that results do not either.
            self.draw(lane, u64::from(restart) * CANDIDATES as u64 + first as u64);
            self.place(Of::Candidates);
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
        true
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
