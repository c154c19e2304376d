//! What the search in a lane does next.
//!
//! *Progress* is a fall of the squared error to a part of what it was within a few steps: those
//! near a solution converge quadratically, so a search that falls slowly is on its way to a local
//! minimum. A lane without progress begins again, if it may, and ends if not; one that limits leave
//! no *hope* does not wait. In the last twelfth of the iterations it goes back to the nearest pose
//! that it found instead, and stays there.

use super::report::{Options, Outcome};
use dq8::Real;

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
