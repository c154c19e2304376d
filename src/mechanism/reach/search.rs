//! The search: every lane walks alone, all in step, and one that is done takes the next configuration.

use super::forward::Of;
use super::lane::{Lane, Next, Seen};
use super::model::{Apart, Model};
use crate::ik::{Options, Outcome, Report};
use crate::real::{Real, Scalar};
use crate::scalar::DualQuat;
use dq8_simd::{Lanes, MAX_LANES};

/// What is to be solved, and where the results go; lengths have been checked.
pub(super) struct Work<'s, R> {
    pub(super) targets: &'s [DualQuat<R>],
    pub(super) values: &'s mut [R],
    pub(super) reports: &'s mut [Report<R, Outcome>],
    pub(super) options: &'s Options<R>,
}

pub(super) struct Search<'s, L: Lanes> {
    pub(super) model: Model<'s, L>,
    pub(super) work: Work<'s, L::Real>,
    pub(super) lanes: [Lane<L::Real>; MAX_LANES],
    /// The next configuration.
    pub(super) next: usize,
}

impl<'s, L: Lanes<Real: Scalar>> Search<'s, L> {
    #[inline(always)]
    pub(super) fn new(model: Model<'s, L>, work: Work<'s, L::Real>) -> Self {
        Self { model, work, lanes: [Lane::IDLE; MAX_LANES], next: 0 }
    }

    #[inline(always)]
    pub(super) fn run(mut self) {
        let zero = L::splat(self.model.level, L::Real::ZERO);
        self.model.scratch.values.fill(zero);
        self.model.scratch.goals.fill(zero);
        for lane in 0..L::LANES {
            self.refill(lane);
        }
        let (mut left, mut running, mut caution) = (zero, zero, zero);
        while self.is_working() {
            self.enter();
            self.model.place(Of::Values);
            let apart = self.model.compare(None);
            let wish = self.model.wish();
            let next = self.judge(apart, wish, left);
            for (index, (lane, next)) in self.lanes.iter().zip(&next).enumerate().take(L::LANES) {
                let one = f32::from(u8::from(*next == Next::Step));
                running = with_lane(running, index, one.into());
                caution = with_lane(caution, index, lane.caution);
            }
            left = self.model.step(apart, caution, zero.lt(running));
            for (lane, next) in next.iter().enumerate().take(L::LANES) {
                match (next, self.lanes.get(lane)) {
                    (Next::BeginAgain, Some(of_lane)) => {
                        self.model.begin_again(lane, of_lane.restarts - 1);
                    }
                    (Next::GoBack, _) => self.model.go_back(lane),
                    _ => {}
                }
            }
        }
    }

    #[inline(always)]
    fn is_working(&self) -> bool {
        let mut working = false;
        for lane in &self.lanes {
            working |= lane.configuration.is_some();
        }
        working
    }

    /// Takes fresh lanes into their limits.
    #[inline(always)]
    fn enter(&mut self) {
        let zero = L::splat(self.model.level, L::Real::ZERO);
        let (mut fresh, mut any) = (zero, false);
        for (index, lane) in self.lanes.iter().enumerate().take(L::LANES) {
            any |= lane.is_fresh;
            fresh = with_lane(fresh, index, f32::from(u8::from(lane.is_fresh)).into());
        }
        if !any {
            return;
        }
        let values = &mut self.model.scratch.values;
        for freedom in self.model.reach.freedoms.iter().filter(|freedom| freedom.is_single()) {
            let row = freedom.value as usize;
            let value = values.get(self.model.level, row);
            let entered = freedom.range.enter(value);
            values.set(row, L::select(zero.lt(fresh), entered, value));
        }
    }

    /// What each lane does next. Those that are done have been written, and took another configuration.
    #[inline(always)]
    fn judge(&mut self, apart: Apart<L>, wish: L, left: L) -> [Next; MAX_LANES] {
        let Apart { square, angular, linear } = apart;
        let [square, angular, linear] = [square.to_array(), angular.to_array(), linear.to_array()];
        let [wish, left] = [wish.to_array(), left.to_array()];
        let mut all = [Next::End; MAX_LANES];
        for (index, next) in all.iter_mut().enumerate().take(L::LANES) {
            let seen = Seen {
                square: number::<L>(&square, index),
                angular: number::<L>(&angular, index),
                linear: number::<L>(&linear, index),
                wish: number::<L>(&wish, index),
                left: number::<L>(&left, index),
            };
            let Some(lane) = self.lanes.get_mut(index) else { break };
            if lane.configuration.is_none() {
                continue;
            }
            let has_posture = self.model.reach.posture.is_some();
            let (is_best, decided) = lane.judge(seen, self.work.options, has_posture);
            *next = decided;
            if is_best {
                let scratch = &mut self.model.scratch;
                for value in 0..self.model.reach.mechanism.values {
                    scratch.best.set_number(value, index, scratch.values.number(value, index));
                }
            }
            if decided == Next::End {
                self.finish(index);
                self.refill(index);
            }
        }
        all
    }
}

#[inline(always)]
fn number<L: Lanes<Real: Real>>(array: &L::Array, lane: usize) -> L::Real {
    array.as_ref().get(lane).copied().unwrap_or(L::Real::NAN)
}

#[inline(always)]
pub(super) fn with_lane<L: Lanes>(lanes: L, lane: usize, number: L::Real) -> L {
    let mut array = lanes.to_array();
    if let Some(slot) = array.as_mut().get_mut(lane) {
        *slot = number;
    }
    L::load(lanes.level(), &array)
}
