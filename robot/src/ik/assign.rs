//! Configurations into lanes, and back.

use super::lane::Lane;
use super::report::{Outcome, Report};
use super::scratch::GOAL;
use super::search::{Search, with_lane};
use dq8::{Real, Scalar};
use dq8_simd::Lanes;

impl<L: Lanes<Real: Scalar>, const TRACK: bool> Search<'_, L, TRACK> {
    /// Gives a lane the next configuration that can be sought; it is idle if there is none.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn refill(&mut self, lane: usize) {
        // Configurations that cannot be sought are reported on the way and take no place in a lane.
        let mut next = Lane::IDLE;
        let last = self.lanes.get(lane).copied().unwrap_or(Lane::IDLE);
        let (mut before, mut rest) = (last.configuration, last.rest);
        while next.configuration.is_none()
            && let Some(configuration) = self.following(before, &mut rest)
        {
            match self.load(lane, configuration) {
                Some(out_of_reach) => {
                    next = Lane::new(configuration, out_of_reach);
                    next.rest = rest;
                }
                None => self.report(configuration, &Lane::IDLE, Outcome::Invalid),
            }
            before = Some(configuration);
        }
        if let Some(slot) = self.lanes.get_mut(lane) {
            *slot = next;
        }
    }

    /// The next frame of a clip, with the values of the one before, or the first of the next clip;
    /// where there are no clips, the next configuration.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn following(&mut self, before: Option<usize>, rest: &mut usize) -> Option<usize> {
        // Only what tracks has clips.
        if TRACK && let (Some(before), 1..) = (before, *rest) {
            *rest -= 1;
            let count = self.model.reach.mechanism.values;
            let pair = self.work.values.get_mut(before * count..).unwrap_or_default();
            if let Some((from, to)) = pair.split_at_mut_checked(count) {
                for (to, &from) in to.iter_mut().zip(from.iter()) {
                    *to = from;
                }
            }
            return Some(before + 1);
        }
        let first = self.next;
        let mut frames = 1;
        if TRACK && let Some(clips) = self.work.clips {
            // Of those without a frame nothing is asked.
            let left = clips.get(self.clip..)?;
            let skipped = left.iter().position(|&frames| frames > 0)?;
            frames = left.get(skipped).copied()?;
            self.clip += skipped + 1;
        }
        *rest = frames - 1;
        self.next += frames;
        (first < self.work.reports.len()).then_some(first)
    }

    /// Puts the targets and the start of a configuration into a lane, and says whether a target is
    /// beyond the length of what carries the link. `None` if they are not what a search can begin
    /// with.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load(&mut self, lane: usize, configuration: usize) -> Option<bool> {
        let options = self.work.options;
        // Who does not track, does not know them.
        let weighs = options.posture_weight > L::Real::ZERO || options.start_weight > L::Real::ZERO;
        if !options.is_valid() || (weighs && !TRACK) {
            return None;
        }
        let (reach, scratch) = (self.model.reach, &mut self.model.scratch);
        let count = reach.mechanism.values;
        let values = self.work.values.get(configuration * count..)?.get(..count)?;
        // Only what moves a goal is looked at: a neighbour of the arm may hold anything.
        for freedom in reach.freedoms {
            let size = if freedom.is_single() { 1 } else { 7 };
            let own = values.get(freedom.value as usize..)?.get(..size)?;
            if !own.iter().all(|value| value.is_finite()) {
                return None;
            }
        }
        let (goals, mut beyond) = (reach.goals.len(), false);
        let targets = self.work.targets.get(configuration * goals..)?.get(..goals)?;
        for index in 0..goals {
            let target = *targets.get(index)?;
            let tolerance = self.work.options.linear_tolerance;
            let (target, drawn) = reach.clamped(index, target, tolerance)?;
            beyond |= drawn.is_some();
            let numbers = target.to_array().into_iter().chain(drawn.unwrap_or_default());
            for (row, number) in numbers.enumerate() {
                scratch.goals.set_number(index * GOAL + row, lane, number);
            }
        }
        // Unless the caller says otherwise, an eighth of the longest way to a goal weighs as much
        // as a radian. Weights of what follows do not change on the way.
        let longest =
            || if TRACK { reach.facts.size } else { reach.typical_length_to(targets, values) };
        let eighth = || longest() * L::Real::from(0.125);
        let length = self.work.options.length_per_radian.unwrap_or_else(eighth);
        if !length.is_finite() {
            return None;
        }
        let scales = &mut self.model.scales;
        scales.length = with_lane(scales.length, lane, length);
        scales.radians_per_length =
            with_lane(scales.radians_per_length, lane, L::Real::ONE / length);
        for (row, &value) in values.iter().enumerate() {
            scratch.values.set_number(row, lane, value);
            scratch.start.set_number(row, lane, value);
        }
        Some(beyond)
    }

    /// Writes what a lane has found.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn finish(&mut self, index: usize) {
        let Some(&lane) = self.lanes.get(index) else { return };
        let Some(configuration) = lane.configuration else { return };
        let outcome = lane.outcome(self.is_at_limits(index));
        // Only now: until a search ends, the caller's values are its start.
        if outcome != Outcome::Invalid {
            let count = self.model.reach.mechanism.values;
            let values = self.work.values.get_mut(configuration * count..).unwrap_or_default();
            for (row, value) in values.iter_mut().enumerate().take(count) {
                *value = self.model.scratch.best.number(row, index);
            }
        }
        self.report(configuration, &lane, outcome);
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn report(&mut self, configuration: usize, lane: &Lane<L::Real>, outcome: Outcome) {
        let mut report = Report {
            iterations: lane.iterations,
            restarts: lane.restarts,
            angular_error: lane.best.angular,
            linear_error: lane.best.linear,
            outcome,
        };
        if outcome == Outcome::Invalid {
            (report.angular_error, report.linear_error) = (L::Real::NAN, L::Real::NAN);
        }
        if let Some(slot) = self.work.reports.get_mut(configuration) {
            *slot = report;
        }
    }

    /// Whether the best values of a lane have a joint at a limit that stops it.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn is_at_limits(&self, lane: usize) -> bool {
        let mut is_at_limits = false;
        for freedom in self.model.reach.freedoms {
            if freedom.is_single() && !freedom.range.wraps() {
                let value = self.model.scratch.best.number(freedom.value as usize, lane);
                is_at_limits |= value <= freedom.range.low || freedom.range.high <= value;
            }
        }
        is_at_limits
    }
}
