//! The search: the loop over all lanes, the decisions of one lane, the assignment of configurations
//! to lanes, and restarts.
//!
//! # The algorithm
//!
//! Each lane holds one configuration. A round does the following for all lanes. It brings the
//! values within their limits, and computes the poses of the goals and their errors. It decides,
//! lane by lane, on a step, a restart, a return to the best values, or the end. It computes the
//! step by damped least squares (Wampler 1986, Sugihara 2011). If a goal asks for a whole pose, the
//! step also uses second derivatives. A lane that ends writes its report and takes the next
//! configuration.
//!
//! *Progress* means that the squared error falls to a given part within a few steps. Near a
//! solution a search converges quadratically, so a slowly falling error means that the search
//! approaches a local minimum. A lane without progress restarts, or ends if restarts are off. A
//! lane is *hopeless*, and restarts or ends at once, if joint limits shorten its step so much that
//! a large part of the error remains. In the last twelfth of the iterations a lane does not restart
//! but returns to the best values that it found, and takes its steps from there.
//!
//! # Reasons
//!
//! - *Lanes with different numbers of iterations share a round.* So no lane waits for the slowest
//!   configuration of a group.
//! - *Decisions are scalar, arithmetic is not.* The decisions of a lane are many branches that
//!   differ from lane to lane. So the errors are copied from the registers to each lane's state
//!   once per round, and the decisions come back as masks.
//! - *Errors are computed for the values that may be returned.* So the values are first brought
//!   within their limits. If a whole turn of a joint gives the same pose, its value becomes the
//!   equivalent value nearest to the start.
//! - *Idle lanes compute too*, from zeros and not from the former contents of the scratch, so that
//!   equal inputs give equal bits.
//! - *Restarts are a type parameter*, so that firmware that never restarts does not contain their
//!   code.

use super::freedom::Kind;
use super::model::{Configurations, Decisions, Model, PoseErrors, StepResult};
use super::report::{Options, Outcome, Report, Settings};
use super::scratch::{EXCESS, GOAL};
use dq8::batch::Quat;
use dq8::scalar::DualQuat;
use dq8::{Real, Scalar};
use dq8_simd::{Lanes, Mask};

/// The inputs and outputs of a search: targets, values, options and the slice for the reports.
/// Their lengths have been checked.
pub(super) struct Work<'s, R> {
    pub(super) targets: &'s [DualQuat<R>],
    pub(super) values: &'s mut [R],
    pub(super) reports: &'s mut [Report<R>],
    pub(super) settings: Settings<'s, R>,
    /// The number of frames of each clip. Within a clip each frame starts from the solution of the
    /// previous frame. It is `None` if every configuration starts from its own values.
    pub(super) clips: Option<&'s [usize]>,
}

pub(super) struct Search<'s, L: Lanes, const TRACK: bool> {
    pub(super) model: Model<'s, L, TRACK>,
    pub(super) work: Work<'s, L::Real>,
    pub(super) lanes: &'s mut [Lane<L::Real>],
    /// The index of the next configuration that a lane will take.
    pub(super) next: usize,
    /// The index of the next clip that a lane will take.
    pub(super) clip: usize,
}

impl<'s, L: Lanes<Real: Scalar>, const TRACK: bool> Search<'s, L, TRACK> {
    /// Makes a search whose `lanes` are all idle. The slice must have an element for each lane of a
    /// register `L`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(
        model: Model<'s, L, TRACK>,
        work: Work<'s, L::Real>,
        lanes: &'s mut [Lane<L::Real>],
    ) -> Self {
        Self { model, work, lanes, next: 0, clip: 0 }
    }

    /// Searches until every configuration has its report. Searches restart only if `RESTARTS` is
    /// `true`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn run<const RESTARTS: bool>(&mut self) {
        let zero = L::splat(self.model.level, L::Real::ZERO);
        self.model.scratch.values.fill(zero);
        self.model.scratch.start.fill(zero);
        self.model.scratch.goals.fill(zero);
        let mut last = StepResult { residual: zero, change: zero };
        let may_restart = RESTARTS && self.work.settings.options.restarts;
        loop {
            self.exchange();
            if !self.is_working() {
                break;
            }
            self.keep_within();
            if RESTARTS {
                self.model.place_or_call(Configurations::Current);
            } else {
                self.model.place(Configurations::Current);
            }
            let errors = self.model.compare(None);
            let posture_distance = self.model.posture_step();
            self.decide::<RESTARTS>(errors, posture_distance, last);
            let decisions = self.decisions(may_restart);
            // Lanes that have ended, or that restart, do not take the step.
            if decisions.running.any() {
                last = self.model.step(errors, decisions);
            }
            if may_restart {
                self.relocate();
            }
        }
    }

    /// Writes the results of lanes that have ended, and gives each of these lanes the next
    /// configuration.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn exchange(&mut self) {
        for index in 0..L::LANES {
            if self.lanes.get(index).is_some_and(|lane| lane.next == Next::End) {
                self.finish(index);
                self.refill(index);
            }
        }
    }

    /// Sets the values of the lanes that restart, or that return to their best values.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn relocate(&mut self) {
        for index in 0..L::LANES {
            let Some(lane) = self.lanes.get_mut(index) else { break };
            match lane.next {
                Next::Restart => {
                    self.model.restart(index, lane.restarts);
                    lane.restarts += 1;
                }
                Next::ReturnToBest => self.model.return_to_best(index),
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

    /// Brings the values within their limits. If whole turns do not change the pose, each value
    /// becomes the equivalent value that is nearest to the start.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn keep_within(&mut self) {
        let (level, reach) = (self.model.level, self.model.reach);
        let scratch = &mut self.model.scratch;
        for freedom in reach.freedoms {
            let row = freedom.value as usize;
            if freedom.is_single() {
                let value = scratch.values.get(level, row);
                // The start is brought within the limits as well, because a restart copies it for
                // values without limits.
                let start = freedom.range.clamp(scratch.start.get(level, row));
                scratch.start.set(row, start);
                scratch.values.set(row, freedom.range.wrap(value, start));
            } else if freedom.kind == Kind::FloatingTurn(0) {
                // q and −q are the same rotation. The sign is chosen so that the quaternion has a
                // dot product of at least 0 with that of the start.
                let value = Quat::from_array(scratch.values.record(level, row));
                let dot = value.dot(Quat::from_array(scratch.start.record(level, row)));
                let one = dot.constant(1.0);
                let value = value.scale(L::select(dot.lt(dot.constant(0.0)), -one, one));
                scratch.values.set_record(row, value.to_array());
            }
        }
    }

    /// Returns the decisions of all lanes as registers: factors and masks for the arithmetic of the
    /// step.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn decisions(&self, may_restart: bool) -> Decisions<L> {
        let zero = L::splat(self.model.level, L::Real::ZERO);
        let damping_factor = self.gather(
            #[cfg_attr(not(opt_level_0), inline(always))]
            |lane| lane.damping_factor,
        );
        let running = self.gather(
            #[cfg_attr(not(opt_level_0), inline(always))]
            |lane| one_if(lane.next == Next::Step),
        );
        let arrived = self.gather(
            #[cfg_attr(not(opt_level_0), inline(always))]
            |lane| one_if(lane.converged),
        );
        Decisions {
            damping_factor,
            running: zero.lt(running),
            arrived: zero.lt(arrived),
            may_restart,
        }
    }

    /// Gathers one component from the state of every lane into a register.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn gather(&self, of: impl Fn(&Lane<L::Real>) -> L::Real) -> L {
        let mut array = L::splat(self.model.level, L::Real::ZERO).to_array();
        for (slot, lane) in array.as_mut().iter_mut().zip(self.lanes.iter()) {
            *slot = of(lane);
        }
        L::load(self.model.level, &array)
    }

    /// Decides the next action of each lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn decide<const RESTARTS: bool>(
        &mut self,
        errors: PoseErrors<L>,
        posture_distance: L,
        last: StepResult<L>,
    ) {
        // The errors are copied from registers to arrays here, once per round, because the
        // decisions below are branches that differ from lane to lane.
        let PoseErrors { square, angular, linear } = errors;
        let [square, angular, linear] = [square.to_array(), angular.to_array(), linear.to_array()];
        let has_posture = self.model.reach.posture.is_some();
        let has_weights = self.model.has_weights();
        let is_steady = TRACK && self.work.settings.steady;
        let [posture_distance, residual, change] =
            [posture_distance.to_array(), last.residual.to_array(), last.change.to_array()];
        for index in 0..L::LANES {
            let square = number::<L>(&square, index);
            let measured = Measured {
                square: if has_weights {
                    square + number::<L>(&posture_distance, index)
                } else {
                    square
                },
                angular: number::<L>(&angular, index),
                linear: number::<L>(&linear, index),
                posture_distance: number::<L>(&posture_distance, index),
                residual: number::<L>(&residual, index),
                change: number::<L>(&change, index),
            };
            let Some(lane) = self.lanes.get_mut(index) else { break };
            if lane.configuration.is_none() {
                continue;
            }
            let options = self.work.settings.options;
            let (is_best, next) = lane.decide::<RESTARTS, TRACK>(
                measured,
                options,
                has_posture,
                has_weights,
                is_steady,
            );
            lane.next = next;
            // The best values are copied before the step overwrites them, because a search may end
            // far from its best values.
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

/// Within [`PATIENCE`] steps the squared error must fall below this part of its value at the
/// previous progress, if the lane may restart.
const PROGRESS: f32 = 0.4;
/// Within [`LAST_PATIENCE`] steps the squared error must fall below this part of its value at the
/// previous progress, if the lane may not restart.
const LAST_PROGRESS: f32 = 0.999;
/// The number of steps in which progress is expected, if the lane may restart. A larger number
/// takes iterations from restarts: with 3, fewer of the random targets in the tests are reached.
const PATIENCE: u32 = 2;
/// The number of steps in which progress is expected, if the lane may not restart. The number may
/// be larger than [`PATIENCE`], because no restart could use the iterations.
const LAST_PATIENCE: u32 = 6;
/// The largest part of the squared error that may remain after a step that joint limits have
/// shortened. If a larger part remains by the linear model of the step, the lane is hopeless: it
/// restarts if it may. Of 10,000 random targets of an arm of seven axes 9,997 are reached; with
/// 0.4, the value of [`PROGRESS`], 9,993 are reached.
const HOPELESS: f32 = 0.2;
/// Below this squared error (radians²) a lane is never hopeless.
const NEAR_TARGET: f32 = 1e-4;
/// The largest number of consecutive steps toward a posture that may end away from the targets or
/// no nearer to the posture.
const POSTURE_PATIENCE: u32 = 60;
/// The change of values, in radians, below which the search takes no further step toward a posture.
const POSTURE_STEP: f32 = 1e-4;
/// The number of equal parts of the allowed iterations. In the final part a lane steps from its
/// best values and does not restart.
const LAST_PART: u32 = 12;
/// The factor by which damping grows after a step that increased the error.
const DAMPING_GROWTH: f32 = 8.0;

/// The errors of a lane, and the effect of the step that led to them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measured<R> {
    /// The weighted squared error of all goals, radians².
    pub(super) square: R,
    /// The largest angle between a link and its target, radians.
    pub(super) angular: R,
    /// The largest distance between a link and its target.
    pub(super) linear: R,
    /// The squared distance from the posture.
    pub(super) posture_distance: R,
    /// The squared error that remains after the previous step, as its linear model predicts it, if
    /// a joint limit shortened this step; otherwise zero.
    pub(super) residual: R,
    /// The sum of the squares of all changes in the previous step, radians².
    pub(super) change: R,
}

/// The state of the search for one configuration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lane<R> {
    /// The index of the configuration; `None` if the lane is idle.
    pub(super) configuration: Option<usize>,
    /// The number of frames that are left in the clip of this configuration.
    pub(super) rest: usize,
    /// The number of steps and restarts so far.
    pub(super) iterations: u32,
    /// The number of restarts so far.
    pub(super) restarts: u32,
    /// `true` if a target is out of reach and was replaced by a nearer point.
    pub(super) out_of_reach: bool,
    /// The errors of the best values so far, which are the values that the search returns.
    pub(super) best: Measured<R>,
    /// `true` before the first decision on a configuration.
    is_new: bool,
    /// `true` from the start or a restart until the next decision.
    has_restarted: bool,
    /// `true` if the pose of the start overflows.
    is_invalid: bool,
    /// `true` if the best values reach all targets within the tolerances.
    pub(super) converged: bool,
    /// `true` if the lane has been stuck at least once ([`is_stuck`](Self::is_stuck)).
    ever_stuck: bool,
    /// `true` after the lane has returned to its best values, from which it steps for the remaining
    /// iterations.
    stays_at_best: bool,
    /// The squared error at the previous decision, before the step to which it led.
    square: R,
    /// The squared error when the lane last made progress. Later errors are compared with it.
    reference: R,
    /// The number of steps since the lane last made progress.
    idle_steps: u32,
    /// The factor by which steps are damped more than usual. It grows if the lane may not restart
    /// and a step has increased the error, so the next steps are shorter (Marquardt 1963).
    pub(super) damping_factor: R,
    /// The action that was decided most recently.
    pub(super) next: Next,
}

/// The next action of a lane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Next {
    Step,
    Restart,
    /// Return to the best values.
    ReturnToBest,
    End,
}

impl<R: Real> Lane<R> {
    pub(super) const IDLE: Self = Self {
        configuration: None,
        rest: 0,
        iterations: 0,
        restarts: 0,
        out_of_reach: false,
        best: Measured {
            square: R::NAN,
            angular: R::NAN,
            linear: R::NAN,
            posture_distance: R::ZERO,
            residual: R::ZERO,
            change: R::ZERO,
        },
        is_new: false,
        has_restarted: false,
        is_invalid: false,
        converged: false,
        ever_stuck: false,
        stays_at_best: false,
        square: R::ZERO,
        reference: R::ZERO,
        idle_steps: 0,
        damping_factor: R::ONE,
        next: Next::End,
    };

    pub(super) fn new(configuration: usize, out_of_reach: bool) -> Self {
        let configuration = Some(configuration);
        let next = Next::Step;
        Self { configuration, out_of_reach, is_new: true, has_restarted: true, next, ..Self::IDLE }
    }

    /// Returns `true` if the measured values are the best so far, otherwise `false`, together with
    /// the next action. With `has_posture` the search goes on toward a posture after the targets
    /// are reached. With `has_weights` the posture or the start has a weight in every step. If the
    /// search `is_steady`, values are better only if they reduce the squared error enough.
    #[cfg_attr(target_os = "none", inline(never))]
    fn decide<const RESTARTS: bool, const TRACK: bool>(
        &mut self,
        measured: Measured<R>,
        options: &Options<R>,
        has_posture: bool,
        has_weights: bool,
        is_steady: bool,
    ) -> (bool, Next) {
        let arrived = measured.angular <= options.angular_tolerance
            && measured.linear <= options.linear_tolerance
            && !self.out_of_reach;
        // The best values are updated before the search can end, because the report has the errors
        // of the best values and not of the final values.
        let gains = measured.square < self.best.square * (R::ONE - options.least_gain);
        let is_best = if has_weights {
            self.is_new || self.is_nearer(&measured) && (gains || !is_steady)
        } else if TRACK && is_steady && !self.converged {
            self.is_new || arrived || gains
        } else if TRACK && !self.converged && measured.square.is_finite() {
            // For a moving target the newest values count as the best if their pose is finite.
            // Otherwise an arm whose target is out of reach would stand still until a step reduced
            // the error.
            true
        } else {
            self.is_best(&measured, arrived)
        };
        if is_best {
            self.best = measured;
        }
        // The pose of finite values can overflow. Only the first pose is checked for that: later
        // poses are judged by comparisons, which are false for NaN.
        if self.is_new && !measured.square.is_finite() {
            self.is_invalid = true;
            return (false, Next::End);
        }
        if has_weights {
            // With a weight for posture or start, reaching the targets does not end the search.
            self.converged = if is_best { arrived } else { self.converged };
            return (is_best, self.toward_targets::<RESTARTS>(&measured, options));
        }
        if arrived && !has_posture {
            self.converged = true;
            return (is_best, Next::End);
        }
        let next = if arrived || self.converged {
            self.toward_posture(&measured, arrived, options)
        } else {
            self.toward_targets::<RESTARTS>(&measured, options)
        };
        (is_best, next)
    }

    /// Returns `true` if the measured values are better than the best values so far. Values that
    /// reach the targets are better than values that miss a tolerance, even if the latter have a
    /// smaller squared error. Among values that reach the targets, the values nearest to the
    /// posture are best.
    #[cfg_attr(not(target_os = "none"), inline)]
    fn is_best(&self, measured: &Measured<R>, arrived: bool) -> bool {
        match (self.is_new, self.converged) {
            (true, _) => true,
            (_, false) => arrived || self.is_nearer(measured),
            (_, true) => arrived && measured.posture_distance < self.best.posture_distance,
        }
    }

    /// Returns `true` if the error is smaller than the error of the best values. If a target is out
    /// of reach, a nearer point replaces it, and the squared error is measured to this point. So a
    /// smaller squared error is not enough: of the two reported errors, which are measured to the
    /// target itself, the distance must not grow or the angle must fall.
    fn is_nearer(&self, measured: &Measured<R>) -> bool {
        let gains = measured.linear <= self.best.linear || measured.angular < self.best.angular;
        measured.square < self.best.square && (gains || !self.out_of_reach)
    }

    /// Returns the next action of a lane that is not at its targets. It is a step, unless the lane
    /// is stuck. A lane that is stuck restarts if it may, or ends. In the last part of the
    /// iterations the lane steps from its best values, without restarts.
    #[cfg_attr(not(target_os = "none"), inline)]
    fn toward_targets<const RESTARTS: bool>(
        &mut self,
        measured: &Measured<R>,
        options: &Options<R>,
    ) -> Next {
        let may_restart = RESTARTS && options.restarts && !self.out_of_reach && !self.stays_at_best;
        let is_stuck =
            self.is_stuck(measured, may_restart) | self.gains_too_little(measured, options);
        self.ever_stuck |= is_stuck;
        self.adapt_damping(measured, may_restart || self.has_restarted);
        (self.is_new, self.has_restarted, self.square) = (false, is_stuck, measured.square);
        if is_stuck && !may_restart || self.iterations >= options.max_iterations {
            return Next::End;
        }
        // A restart counts as an iteration too, so every search ends.
        self.iterations += 1;
        if !is_stuck {
            return Next::Step;
        }
        let last = options.max_iterations / LAST_PART;
        self.stays_at_best = self.iterations > options.max_iterations - last;
        if self.stays_at_best { Next::ReturnToBest } else { Next::Restart }
    }

    /// Returns `true` if too many steps in a row have brought no progress, or limits shortened the
    /// previous step too much ([`is_hopeless`](Self::is_hopeless)). If the lane may restart, fewer
    /// steps are allowed and more progress is required, because a restart is cheap.
    fn is_stuck(&mut self, measured: &Measured<R>, may_restart: bool) -> bool {
        let (needed, patience) = match may_restart {
            true => (PROGRESS, PATIENCE),
            false => (LAST_PROGRESS, LAST_PATIENCE),
        };
        let is_hopeless = may_restart && !self.has_restarted && self.is_hopeless(measured);
        // The error is compared with `reference`, the error at the previous progress, and not with
        // the error before the step. So many small reductions together count as progress too.
        if self.has_restarted || measured.square < self.reference * R::from(needed) {
            (self.reference, self.idle_steps) = (measured.square, 0);
        } else {
            self.idle_steps += 1;
        }
        self.idle_steps >= patience || is_hopeless
    }

    /// Returns `true` if the previous step reduced the squared error by less than the options
    /// require.
    fn gains_too_little(&mut self, measured: &Measured<R>, options: &Options<R>) -> bool {
        let required = self.square * (R::ONE - options.least_gain);
        // This is `false` for an error that is NaN, which so counts as no reduction.
        let gains = measured.square < required;
        let is_little = options.least_gain > R::ZERO && !self.has_restarted && !gains;
        // A step that reduces the error too little counts as a step without progress, so that the
        // outcome is Stalled and not Unfinished.
        self.idle_steps += u32::from(is_little);
        is_little
    }

    /// Adapts the damping. A step that increases the error makes the next steps shorter; every
    /// other step halves the additional damping.
    fn adapt_damping(&mut self, measured: &Measured<R>, is_bold: bool) {
        self.damping_factor = if is_bold || measured.square <= self.square {
            let less = self.damping_factor * R::HALF;
            if less > R::ONE { less } else { R::ONE }
        } else {
            self.damping_factor * R::from(DAMPING_GROWTH)
        };
    }

    /// Returns the next action of a lane that has reached its targets: a step toward the posture,
    /// until values at the targets come no nearer to the posture, or the changes become small.
    /// Single steps may leave the targets, because they follow the null space only to first order.
    #[cfg_attr(not(target_os = "none"), inline)]
    fn toward_posture(
        &mut self,
        measured: &Measured<R>,
        arrived: bool,
        options: &Options<R>,
    ) -> Next {
        let least = R::from(POSTURE_STEP);
        let is_nearer = !self.converged
            || (measured.posture_distance < self.reference && measured.change > least * least);
        let tolerance = options.angular_tolerance;
        let is_there =
            arrived && (!is_nearer || measured.posture_distance <= tolerance * tolerance);
        // Progress toward the posture counts only while the targets are reached, because a step
        // toward the posture may leave the targets for some iterations.
        if arrived {
            (self.reference, self.idle_steps) = (measured.posture_distance, 0);
        }
        self.idle_steps += 1;
        (self.is_new, self.has_restarted, self.converged) = (false, false, true);
        (self.square, self.damping_factor) = (measured.square, R::ONE);
        if is_there
            || self.idle_steps > POSTURE_PATIENCE
            || self.iterations >= options.max_iterations
        {
            return Next::End;
        }
        self.iterations += 1;
        Next::Step
    }

    /// Returns `true` if joint limits shortened the previous step so much that a large part of the
    /// squared error remained, more than [`HOPELESS`], as the linear model of the step predicts.
    fn is_hopeless(&self, measured: &Measured<R>) -> bool {
        measured.residual > self.square * R::from(HOPELESS) && self.square > R::from(NEAR_TARGET)
    }

    /// Returns the report of a search that ends.
    #[cfg_attr(not(target_os = "none"), inline)]
    fn report(&self, is_at_limits: bool) -> Report<R> {
        match self.outcome(is_at_limits) {
            Outcome::Invalid => Report::INVALID,
            outcome => Report {
                outcome,
                iterations: self.iterations,
                restarts: self.restarts,
                angular_error: self.best.angular,
                linear_error: self.best.linear,
            },
        }
    }

    fn outcome(&self, is_at_limits: bool) -> Outcome {
        // If the final step still gave the best values, more iterations would probably improve them
        // further.
        let still_nearer = self.idle_steps == 0 && self.square <= self.best.square;
        // Of the outcomes that apply, the first one counts. They are ordered from the most to the
        // least specific, because a search for a target out of reach also stalls, and may press
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
    /// Gives a lane the next valid configuration, or makes it idle if there is none.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn refill(&mut self, lane: usize) {
        // This loop also writes the reports of invalid configurations, which take no lane.
        let last = self.lanes.get(lane).map(|lane| (lane.configuration, lane.rest));
        let (mut before, mut rest) = last.unwrap_or_default();
        let next = loop {
            let Some(configuration) = self.next_configuration(before, &mut rest) else {
                break Lane::IDLE;
            };
            if let Some(out_of_reach) = self.load(lane, configuration) {
                break Lane { rest, ..Lane::new(configuration, out_of_reach) };
            }
            self.report(configuration, Report::INVALID);
            before = Some(configuration);
        };
        if let Some(slot) = self.lanes.get_mut(lane) {
            *slot = next;
        }
    }

    /// Returns the index of the next configuration for a lane. With clips this is the next frame of
    /// the lane's clip, whose start is the solution of the frame `before`, or else the first frame
    /// of the next clip.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn next_configuration(&mut self, before: Option<usize>, rest: &mut usize) -> Option<usize> {
        // Only searches that track have clips.
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
            // Empty clips are skipped.
            let remaining = clips.get(self.clip..)?;
            let skipped = remaining.iter().position(|&frames| frames > 0)?;
            frames = remaining.get(skipped).copied()?;
            self.clip += skipped + 1;
        }
        *rest = frames - 1;
        self.next += frames;
        (first < self.work.reports.len()).then_some(first)
    }

    /// Loads the targets of a configuration, and the values from which its search starts, into a
    /// lane. Returns `Some(true)` if a target is out of reach, `Some(false)` if none is, and `None`
    /// if an input is invalid.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load(&mut self, lane: usize, configuration: usize) -> Option<bool> {
        let options = self.work.settings.options;
        if !options.is_valid() || (TRACK && !self.work.settings.has_valid_weights()) {
            return None;
        }
        let (reach, scratch) = (self.model.reach, &mut self.model.scratch);
        let count = reach.mechanism.values;
        let values = self.work.values.get(configuration * count..)?.get(..count)?;
        // Only values that move a goal are checked: values of other joints of the robot may be
        // anything.
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
            let tolerance = options.linear_tolerance;
            let (target, excess) = reach.clamped(index, target, tolerance)?;
            beyond |= excess.is_some();
            for (row, &number) in target.to_array().iter().enumerate() {
                scratch.goals.set_number(index * GOAL + row, lane, number);
            }
            for (row, &number) in excess.unwrap_or_default().iter().enumerate() {
                scratch.goals.set_number(index * GOAL + EXCESS + row, lane, number);
            }
        }
        // The default length per radian is an eighth of the longest distance from the base to a
        // goal. While tracking, this distance does not depend on the targets, so that the weights
        // stay the same from frame to frame.
        let longest =
            || if TRACK { reach.facts.size } else { reach.typical_length_to(targets, values) };
        let eighth = || longest() * L::Real::from(0.125);
        let length = options.length_per_radian.unwrap_or_else(eighth);
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

    /// Writes the values and the report of a lane to the caller's slices.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn finish(&mut self, index: usize) {
        let is_at_limits = self.is_at_limits(index);
        let Some(lane) = self.lanes.get(index) else { return };
        let Some(configuration) = lane.configuration else { return };
        let report = lane.report(is_at_limits);
        // The caller's values are written only here, because they are the start of the search until
        // it ends.
        if report.outcome != Outcome::Invalid {
            let count = self.model.reach.mechanism.values;
            let values = self.work.values.get_mut(configuration * count..).unwrap_or_default();
            for (row, value) in values.iter_mut().enumerate().take(count) {
                *value = self.model.scratch.best.number(row, index);
            }
        }
        self.report(configuration, report);
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn report(&mut self, configuration: usize, report: Report<L::Real>) {
        if let Some(slot) = self.work.reports.get_mut(configuration) {
            *slot = report;
        }
    }

    /// Returns `true` if, at the best values, a joint is at a limit that stops it.
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
