//! What the search in a lane does next.
//!
//! *Progress* is a fall of the squared error to a part of what it was within a few steps: those near a
//! solution converge quadratically, so a search that falls slowly is on its way to a local minimum. A lane
//! without progress begins again, if it may, and ends if not; one that limits leave no *hope* does not wait.

use crate::ik::{Options, Outcome};
use crate::real::Real;

/// The squared error must fall to this part of itself ...
const PROGRESS: f32 = 0.4;
/// ... or, where there is no other beginning, to this part ...
const LAST_PROGRESS: f32 = 0.999;
/// ... in this many steps.
const PATIENCE: u32 = 2;
const LAST_PATIENCE: u32 = 6;
/// Below this squared error (radians²) a limit in the way is not a reason to give up at once.
const NEAR: f32 = 1e-4;

/// What is known of a lane after a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen<R> {
    /// The weighted squared error, and the largest turn and distance that are left.
    pub(super) square: R,
    pub(super) angular: R,
    pub(super) linear: R,
    /// The squared distance from the posture.
    pub(super) wish: R,
    /// What the last step would leave of the squared error, if a limit cut it short; zero if none did.
    pub(super) left: R,
}

/// A search for one configuration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lane<R> {
    /// Which one; none if the lane is idle.
    pub(super) configuration: Option<usize>,
    pub(super) iterations: u32,
    pub(super) restarts: u32,
    pub(super) out_of_reach: bool,
    pub(super) best: Seen<R>,
    /// Whether nothing has been seen of it yet, and whether it has just begun again.
    pub(super) is_fresh: bool,
    begins: bool,
    is_invalid: bool,
    converged: bool,
    ever_stuck: bool,
    /// The squared error after the last step, the one that progress is measured from, and the steps without
    /// progress since.
    square: R,
    mark: R,
    idle_steps: u32,
}

/// What a lane does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Next {
    Step,
    BeginAgain,
    End,
}

impl<R: Real> Lane<R> {
    pub(super) const IDLE: Self = Self {
        configuration: None,
        iterations: 0,
        restarts: 0,
        out_of_reach: false,
        best: Seen {
            square: R::NAN,
            angular: R::NAN,
            linear: R::NAN,
            wish: R::ZERO,
            left: R::ZERO,
        },
        is_fresh: false,
        begins: false,
        is_invalid: false,
        converged: false,
        ever_stuck: false,
        square: R::ZERO,
        mark: R::ZERO,
        idle_steps: 0,
    };

    pub(super) fn new(configuration: usize, out_of_reach: bool) -> Self {
        let configuration = Some(configuration);
        Self { configuration, out_of_reach, is_fresh: true, begins: true, ..Self::IDLE }
    }

    /// Whether this is the nearest so far, and what to do next.
    pub(super) fn judge(
        &mut self,
        seen: Seen<R>,
        options: &Options<R>,
        has_posture: bool,
    ) -> (bool, Next) {
        let arrived = seen.angular <= options.angular_tolerance
            && seen.linear <= options.linear_tolerance
            && !self.out_of_reach;
        // What has arrived is kept even where an earlier pose had the smaller sum of errors: that one had
        // one of the two beyond its tolerance.
        let is_best = match (self.is_fresh, self.converged) {
            (true, _) => true,
            (_, false) => arrived || seen.square < self.best.square,
            (_, true) => arrived && seen.wish < self.best.wish,
        };
        if is_best {
            self.best = seen;
        }
        if self.is_fresh && !seen.square.is_finite() {
            self.is_invalid = true;
            return (false, Next::End);
        }
        let has_just_arrived = arrived && !self.converged;
        self.converged |= arrived;
        let tolerance = options.angular_tolerance;
        if arrived && !(has_posture && seen.wish > tolerance * tolerance) {
            return (is_best, Next::End);
        }
        let may_restart = options.restarts && !self.out_of_reach && !self.converged;
        let hopeless = may_restart && !self.begins && self.is_hopeless(&seen);
        let falling = if self.converged { seen.wish } else { seen.square };
        let needed = R::from(if may_restart { PROGRESS } else { LAST_PROGRESS });
        if self.begins || has_just_arrived || falling < self.mark * needed {
            (self.mark, self.idle_steps) = (falling, 0);
        } else {
            self.idle_steps += 1;
        }
        let patience = if may_restart { PATIENCE } else { LAST_PATIENCE };
        let stuck = self.idle_steps >= patience || hopeless;
        self.ever_stuck |= stuck;
        (self.is_fresh, self.begins, self.square) = (false, false, seen.square);
        if stuck && !may_restart || self.iterations >= options.max_iterations {
            return (is_best, Next::End);
        }
        self.iterations += 1;
        if stuck {
            self.restarts += 1;
            self.begins = true;
            return (is_best, Next::BeginAgain);
        }
        (is_best, Next::Step)
    }

    /// Whether a limit cut the last step so short that even its own linear model left most of the error.
    fn is_hopeless(&self, seen: &Seen<R>) -> bool {
        seen.left > self.square * R::from(PROGRESS) && self.square > R::from(NEAR)
    }

    pub(super) fn outcome(&self, is_at_limits: bool) -> Outcome {
        let still_nearer = self.idle_steps == 0 && self.square <= self.best.square;
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
