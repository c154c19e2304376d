//! The search.
//!
//! # The algorithm
//!
//! Each lane holds one configuration. In every round all lanes do the same: take the values into
//! their limits; compute the poses of the goals and how far they are from the targets; decide, lane
//! by lane, whether to step, end, go back to the best or begin again; and step, by damped least
//! squares (Wampler 1986, Sugihara 2011) with a second order where a whole pose is asked for. A
//! lane that ends writes its report and takes the next configuration.
//!
//! # Why it is as it is
//!
//! - *Lanes of different age are in the same round.* No lane waits for the slowest of a group; a
//!   round costs the same, whoever takes part.
//! - *Decisions are scalar, arithmetic is not.* What a lane does next is a page of branches that
//!   differ from lane to lane: it is taken out of registers once per round, and comes back as
//!   masks.
//! - *What is judged is what is returned*: values are taken into their limits first, whole turns to
//!   the side of the start.
//! - *Idle lanes compute along*, from zeros whatever the scratch held, so that every call has the
//!   same bits.
//! - *Restarts are a constant of the type*, so that firmware without them does not hold them.

use super::forward::Of;
use super::freedom::Kind;
use super::lane::{Lane, Next, Seen};
use super::model::{Apart, Model, Stepped};
use super::report::{Options, Report};
use dq8::batch::Quat;
use dq8::scalar::DualQuat;
use dq8::{Real, Scalar};
use dq8_simd::{Lanes, Mask};

/// What is to be solved, and where the results go; lengths have been checked.
pub(super) struct Work<'s, R> {
    pub(super) targets: &'s [DualQuat<R>],
    pub(super) values: &'s mut [R],
    pub(super) reports: &'s mut [Report<R>],
    pub(super) options: &'s Options<R>,
    /// How many frames each clip has, of which each starts from the one before; none if all start
    /// from their own values.
    pub(super) clips: Option<&'s [usize]>,
}

pub(super) struct Search<'s, L: Lanes, const TRACK: bool> {
    pub(super) model: Model<'s, L, TRACK>,
    pub(super) work: Work<'s, L::Real>,
    pub(super) lanes: &'s mut [Lane<L::Real>],
    /// The next configuration, and the next clip.
    pub(super) next: usize,
    pub(super) clip: usize,
}

impl<'s, L: Lanes<Real: Scalar>, const TRACK: bool> Search<'s, L, TRACK> {
    /// `lanes` are idle, and as many as `L` has, or more.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(
        model: Model<'s, L, TRACK>,
        work: Work<'s, L::Real>,
        lanes: &'s mut [Lane<L::Real>],
    ) -> Self {
        Self { model, work, lanes, next: 0, clip: 0 }
    }

    /// The search; with restarts if `AGAIN`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn run<const AGAIN: bool>(mut self) {
        let zero = L::splat(self.model.level, L::Real::ZERO);
        self.model.scratch.values.fill(zero);
        self.model.scratch.start.fill(zero);
        self.model.scratch.goals.fill(zero);
        let mut last = Stepped { left: zero, moved: zero };
        let again = AGAIN && self.work.options.restarts;
        loop {
            self.exchange();
            if !self.is_working() {
                break;
            }
            self.keep_within();
            if AGAIN {
                self.model.place_or_call(Of::Values);
            } else {
                self.model.place(Of::Values);
            }
            let apart = self.model.compare(None);
            let wish = self.model.wish();
            self.judge(apart, wish, last);
            // The decisions become vectors again: numbers and masks for the arithmetic of the step.
            let caution = self.each(
                #[cfg_attr(not(opt_level_0), inline(always))]
                |lane| lane.caution,
            );
            let running = self.each(
                #[cfg_attr(not(opt_level_0), inline(always))]
                |lane| one_if(lane.next == Next::Step),
            );
            let arrived = self.each(
                #[cfg_attr(not(opt_level_0), inline(always))]
                |lane| one_if(lane.converged),
            );
            let running = zero.lt(running);
            // Those that have ended, or begin again, stay where they are.
            if running.any() {
                last = self.model.step(apart, caution, running, zero.lt(arrived), again);
            }
            if again {
                self.turn();
            }
        }
    }

    /// Writes what ended, and gives its lane the next configuration.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn exchange(&mut self) {
        for index in 0..L::LANES {
            if self.lanes.get(index).is_some_and(|lane| lane.next == Next::End) {
                self.finish(index);
                self.refill(index);
            }
        }
    }

    /// Puts lanes where they do not step to.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn turn(&mut self) {
        for index in 0..L::LANES {
            let Some(lane) = self.lanes.get_mut(index) else { break };
            match lane.next {
                Next::BeginAgain => self.model.begin_again(index, lane),
                Next::GoBack => self.model.go_back(index),
                Next::Step | Next::End => {}
            }
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn is_working(&self) -> bool {
        let mut working = false;
        for lane in self.lanes.iter() {
            working |= lane.configuration.is_some();
        }
        working
    }

    /// Takes the values into their limits, whole turns to where they are nearest to the start.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn keep_within(&mut self) {
        let (level, reach) = (self.model.level, self.model.reach);
        let scratch = &mut self.model.scratch;
        for freedom in reach.freedoms {
            let row = freedom.value as usize;
            if freedom.is_single() {
                let value = scratch.values.get(level, row);
                // The start as well, once and for all: what has no ends begins again from there.
                let start = freedom.range.clamp(scratch.start.get(level, row));
                scratch.start.set(row, start);
                scratch.values.set(row, freedom.range.keep(value, start));
            } else if freedom.kind == Kind::FloatingTurn(0) {
                // Of ±q, the same rotation, the one on the side of the start.
                let value = Quat::from_array(scratch.values.record(level, row));
                let dot = value.dot(Quat::from_array(scratch.start.record(level, row)));
                let one = dot.constant(1.0);
                let value = value.scale(L::select(dot.lt(dot.constant(0.0)), -one, one));
                scratch.values.set_record(row, value.to_array());
            }
        }
    }

    /// A number of each lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn each(&self, of: impl Fn(&Lane<L::Real>) -> L::Real) -> L {
        let mut array = L::splat(self.model.level, L::Real::ZERO).to_array();
        for (slot, lane) in array.as_mut().iter_mut().zip(self.lanes.iter()) {
            *slot = of(lane);
        }
        L::load(self.model.level, &array)
    }

    /// What each lane does next.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn judge(&mut self, apart: Apart<L>, wish: L, last: Stepped<L>) {
        // Out of registers once per round: the decisions below are branches, and differ from lane
        // to lane.
        let Apart { square, angular, linear } = apart;
        let [square, angular, linear] = [square.to_array(), angular.to_array(), linear.to_array()];
        let has_posture = self.model.reach.posture.is_some();
        let weighs = self.model.weighs();
        let [wish, left, moved] = [wish.to_array(), last.left.to_array(), last.moved.to_array()];
        for index in 0..L::LANES {
            let square = number::<L>(&square, index);
            let seen = Seen {
                square: if weighs { square + number::<L>(&wish, index) } else { square },
                angular: number::<L>(&angular, index),
                linear: number::<L>(&linear, index),
                wish: number::<L>(&wish, index),
                left: number::<L>(&left, index),
                moved: number::<L>(&moved, index),
            };
            let Some(lane) = self.lanes.get_mut(index) else { break };
            if lane.configuration.is_none() {
                continue;
            }
            let (is_best, next) = lane.judge(seen, self.work.options, has_posture, weighs, TRACK);
            lane.next = next;
            // Before the step overwrites them. A search may end far from its best.
            if is_best {
                let scratch = &mut self.model.scratch;
                for value in 0..self.model.reach.mechanism.values {
                    scratch.best.set_number(value, index, scratch.values.number(value, index));
                }
            }
        }
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn one_if<R: Real>(holds: bool) -> R {
    if holds { R::ONE } else { R::ZERO }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn number<L: Lanes<Real: Real>>(array: &L::Array, lane: usize) -> L::Real {
    array.as_ref().get(lane).copied().unwrap_or(L::Real::NAN)
}

#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn with_lane<L: Lanes>(lanes: L, lane: usize, number: L::Real) -> L {
    let mut array = lanes.to_array();
    if let Some(slot) = array.as_mut().get_mut(lane) {
        *slot = number;
    }
    L::load(lanes.level(), &array)
}
