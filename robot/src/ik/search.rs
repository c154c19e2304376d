//! The search: the loop over all lanes, the decisions of one lane, and the way of configurations into
//! lanes and back.
//!
//! # The algorithm
//!
//! Each lane holds one configuration. In every round all lanes do the same: take the values into
//! their limits; compute the poses of the goals and how far they are from the targets; decide, lane
//! by lane, whether to step, end, go back to the best or begin again; and step, by damped least
//! squares (Wampler 1986, Sugihara 2011) with a second order where a whole pose is asked for. A
//! lane that ends writes its report and takes the next configuration.
//!
//! *Progress* is a fall of the squared error to a part of what it was within a few steps: those
//! near a solution converge quadratically, so a search that falls slowly is on its way to a local
//! minimum. A lane without progress begins again, if it may, and ends if not; one that limits leave
//! no *hope* does not wait. In the last twelfth of the iterations it goes back to the nearest pose
//! that it found instead, and stays there.
//!
//! A restart draws [`CANDIDATES`] configurations from a sequence of low discrepancy within the
//! limits, all different from those before, and takes the one whose links are nearest to the
//! targets. The other lanes help to compute them. What has no ends stays as it was at the start.
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

use super::freedom::Kind;
use super::model::{Apart, Model, Of, Stepped};
use super::report::{Options, Outcome, Report};
use super::scratch::GOAL;
use dq8::batch::Quat;
use dq8::scalar::DualQuat;
use dq8::{Real, Scalar};
use dq8_simd::{Lanes, MAX_LANES, Mask};

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

/// The squared error must fall to a part of itself, this one, or where there is no other beginning
/// the next ...
const PROGRESS: f32 = 0.4;
const LAST_PROGRESS: f32 = 0.999;
/// ... in this many steps. Patience costs iterations that a restart could use: with 3, fewer of the
/// random targets in the tests are reached. Without restarts, patience costs nothing.
const PATIENCE: u32 = 2;
const LAST_PATIENCE: u32 = 6;
/// A step that limits cut so short that even its own linear model leaves more than this part of the
/// squared error is the last, where there is another beginning. Of 10,000 random targets of an arm
/// of seven axes it is 9,997 that are reached; with the part that is progress as the hope 9,993.
const HOPE: f32 = 0.2;
/// Below this squared error (radians²) a limit in the way is not a reason to give up at once.
const NEAR: f32 = 1e-4;
/// So many steps may lead past the targets on the way to a posture.
const POSTURE_PATIENCE: u32 = 60;
/// A way of less than this, radians, is not worth another step to a posture.
const POSTURE_STEP: f32 = 1e-4;
/// This part of the iterations is the last.
const LAST: u32 = 12;
/// How much more a step is damped than one that led away.
const MORE_CAUTION: f32 = 8.0;

/// What is known of a lane after a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen<R> {
    /// The weighted squared error, and the largest turn and distance that are left.
    pub(super) square: R,
    pub(super) angular: R,
    pub(super) linear: R,
    /// The squared distance from the posture.
    pub(super) wish: R,
    /// What the last step would leave of the squared error, if a limit cut it short; zero if none
    /// did.
    pub(super) left: R,
    /// The square of all that the last step changed, in radians.
    pub(super) moved: R,
}

/// A search for one configuration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lane<R> {
    /// Which one; none if the lane is idle.
    pub(super) configuration: Option<usize>,
    /// How many frames of its clip are left.
    pub(super) rest: usize,
    pub(super) iterations: u32,
    pub(super) restarts: u32,
    pub(super) out_of_reach: bool,
    pub(super) best: Seen<R>,
    /// Whether nothing has been seen of it yet, and whether it has just begun again.
    pub(super) is_fresh: bool,
    begins: bool,
    is_invalid: bool,
    pub(super) converged: bool,
    ever_stuck: bool,
    /// Whether it went back to the nearest that it had been, to stay.
    settles: bool,
    /// The squared error after the last step, the one that progress is measured from, and the steps
    /// without progress since.
    square: R,
    mark: R,
    idle_steps: u32,
    /// By how much more than usual steps are damped: where there is no other beginning and a step
    /// led away, the next are shorter (Marquardt 1963).
    pub(super) caution: R,
    /// What it does next.
    pub(super) next: Next,
}

/// What a lane does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Next {
    Step,
    BeginAgain,
    /// To the nearest so far.
    GoBack,
    End,
}

impl<R: Real> Lane<R> {
    pub(super) const IDLE: Self = Self {
        configuration: None,
        rest: 0,
        iterations: 0,
        restarts: 0,
        out_of_reach: false,
        best: Seen {
            square: R::NAN,
            angular: R::NAN,
            linear: R::NAN,
            wish: R::ZERO,
            left: R::ZERO,
            moved: R::ZERO,
        },
        is_fresh: false,
        begins: false,
        is_invalid: false,
        converged: false,
        ever_stuck: false,
        settles: false,
        square: R::ZERO,
        mark: R::ZERO,
        idle_steps: 0,
        caution: R::ONE,
        next: Next::End,
    };

    pub(super) fn new(configuration: usize, out_of_reach: bool) -> Self {
        let configuration = Some(configuration);
        let next = Next::Step;
        Self { configuration, out_of_reach, is_fresh: true, begins: true, next, ..Self::IDLE }
    }

    /// Whether this is the nearest so far, and what to do next.
    pub(super) fn judge(
        &mut self,
        seen: Seen<R>,
        options: &Options<R>,
        has_posture: bool,
        weighs: bool,
        track: bool,
    ) -> (bool, Next) {
        let arrived = seen.angular <= options.angular_tolerance
            && seen.linear <= options.linear_tolerance
            && !self.out_of_reach;
        // Judged before anything ends: what is reported is the best, whichever pose is the last.
        let is_best = if weighs {
            self.is_fresh || self.is_nearer(&seen)
        } else if track && !self.converged && seen.square.is_finite() {
            // Of a target that moves the last step counts, if its pose is one: where only the best
            // counted, an arm in front of a pose that it cannot hold would stand until a leap pays.
            true
        } else {
            self.is_best(&seen, arrived)
        };
        if is_best {
            self.best = seen;
        }
        // Finite values can have a pose that overflows. Later poses are judged by comparisons,
        // which NaN never wins.
        if self.is_fresh && !seen.square.is_finite() {
            self.is_invalid = true;
            return (false, Next::End);
        }
        if weighs {
            // A wish that always acts is not done with the targets.
            self.converged = if is_best { arrived } else { self.converged };
            return (is_best, self.toward_targets(&seen, options));
        }
        if arrived && !has_posture {
            self.converged = true;
            return (is_best, Next::End);
        }
        let next = if arrived || self.converged {
            self.toward_posture(&seen, arrived, options)
        } else {
            self.toward_targets(&seen, options)
        };
        (is_best, next)
    }

    /// What has arrived is kept even where an earlier pose had the smaller sum of errors: that one
    /// had one of the two beyond its tolerance. Of those that have arrived, the nearest to the
    /// posture.
    fn is_best(&self, seen: &Seen<R>, arrived: bool) -> bool {
        match (self.is_fresh, self.converged) {
            (true, _) => true,
            (_, false) => arrived || self.is_nearer(seen),
            (_, true) => arrived && seen.wish < self.best.wish,
        }
    }

    /// Nearer than the nearest so far. Of a target out of reach the square is that of the way to a
    /// place that may be reached; on the way there nothing may be lost of both errors that are
    /// reported.
    fn is_nearer(&self, seen: &Seen<R>) -> bool {
        let gains = seen.linear <= self.best.linear || seen.angular < self.best.angular;
        seen.square < self.best.square && (gains || !self.out_of_reach)
    }

    /// Not there yet: a step, unless steps have stopped paying. Then the search begins again if it
    /// may, or ends. The last part of the iterations is for steps from the nearest pose so far,
    /// without another beginning.
    fn toward_targets(&mut self, seen: &Seen<R>, options: &Options<R>) -> Next {
        let may_restart = options.restarts && !self.out_of_reach && !self.settles;
        let is_stuck = self.is_stuck(seen, may_restart) | self.gains_little(seen, options);
        self.ever_stuck |= is_stuck;
        self.adapt_caution(seen, may_restart || self.begins);
        (self.is_fresh, self.begins, self.square) = (false, is_stuck, seen.square);
        if is_stuck && !may_restart || self.iterations >= options.max_iterations {
            return Next::End;
        }
        // Another beginning counts as an iteration too, so every search ends.
        self.iterations += 1;
        if !is_stuck {
            return Next::Step;
        }
        let last = options.max_iterations / LAST;
        self.settles = self.iterations > options.max_iterations - last;
        if self.settles { Next::GoBack } else { Next::BeginAgain }
    }

    /// Whether too many steps in a row have brought too little, or the last one shows that no more
    /// will. Where there is another beginning, less patience and more progress are asked for: to
    /// begin again is cheap.
    fn is_stuck(&mut self, seen: &Seen<R>, may_restart: bool) -> bool {
        let (needed, patience) = match may_restart {
            true => (PROGRESS, PATIENCE),
            false => (LAST_PROGRESS, LAST_PATIENCE),
        };
        let is_hopeless = may_restart && !self.begins && self.is_hopeless(seen);
        // Measured from the last mark, not from the last step: many small gains are progress too.
        if self.begins || seen.square < self.mark * R::from(needed) {
            (self.mark, self.idle_steps) = (seen.square, 0);
        } else {
            self.idle_steps += 1;
        }
        self.idle_steps >= patience || is_hopeless
    }

    /// Whether the last step gained less than is asked of one.
    fn gains_little(&mut self, seen: &Seen<R>, options: &Options<R>) -> bool {
        let asked = self.square * (R::ONE - options.least_gain);
        // NaN gains nothing.
        let gains = seen.square < asked;
        let is_little = options.least_gain > R::ZERO && !self.begins && !gains;
        // It is no iteration that was missing.
        self.idle_steps += u32::from(is_little);
        is_little
    }

    /// A step that led away makes the next ones shorter; one that did not gives half of that back.
    fn adapt_caution(&mut self, seen: &Seen<R>, is_bold: bool) {
        self.caution = if is_bold || seen.square <= self.square {
            let less = self.caution * R::HALF;
            if less > R::ONE { less } else { R::ONE }
        } else {
            self.caution * R::from(MORE_CAUTION)
        };
    }

    /// The targets are reached, or have been: on to the posture, until poses that reach them come
    /// no nearer to it, or next to nothing moves. Between them are some that do not, because the
    /// way there is bent.
    fn toward_posture(&mut self, seen: &Seen<R>, arrived: bool, options: &Options<R>) -> Next {
        let least = R::from(POSTURE_STEP);
        let is_nearer = !self.converged || (seen.wish < self.mark && seen.moved > least * least);
        let tolerance = options.angular_tolerance;
        let is_there = arrived && (!is_nearer || seen.wish <= tolerance * tolerance);
        // Only poses that reach the targets count as progress; on the others the error is what the
        // posture costs.
        if arrived {
            (self.mark, self.idle_steps) = (seen.wish, 0);
        }
        self.idle_steps += 1;
        (self.is_fresh, self.begins, self.converged) = (false, false, true);
        (self.square, self.caution) = (seen.square, R::ONE);
        if is_there
            || self.idle_steps > POSTURE_PATIENCE
            || self.iterations >= options.max_iterations
        {
            return Next::End;
        }
        self.iterations += 1;
        Next::Step
    }

    /// Whether a limit cut the last step so short that even its own linear model left most of the
    /// error.
    fn is_hopeless(&self, seen: &Seen<R>) -> bool {
        seen.left > self.square * R::from(HOPE) && self.square > R::from(NEAR)
    }

    pub(super) fn outcome(&self, is_at_limits: bool) -> Outcome {
        // The last step was the best of all: with more iterations it would go on.
        let still_nearer = self.idle_steps == 0 && self.square <= self.best.square;
        // In falling order of how much they say: a target out of reach also stalls, and may press
        // joints to their limits.
        match self {
            Self { is_invalid: true, .. } => Outcome::Invalid,
            Self { converged: true, .. } => Outcome::Converged,
            Self { out_of_reach: true, .. } => Outcome::OutOfReach,
            Self { ever_stuck: false, .. } => Outcome::Unfinished,
            _ if still_nearer => Outcome::Unfinished,
            _ if is_at_limits => Outcome::AtLimits,
            _ => Outcome::Stalled,
        }
    }
}

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
