//! What a search is told, and what it reports.

use dq8::Real;

/// When a search ends, and how it weighs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options<R> {
    /// The turn that may be left, radians.
    pub angular_tolerance: R,
    /// The distance that may be left, in the unit of the mechanism.
    pub linear_tolerance: R,
    /// Steps and restarts together. Most targets of an arm take six or seven; the default of 100 is
    /// for the few in a hundred that begin again, and costs time only where a target cannot be
    /// reached, or a posture is far. Several goals on one tree may want 1000: a humanoid with four
    /// goals reached 93 % of random targets that can be reached with 100, and all of 200 with 1000.
    pub max_iterations: u32,
    /// How long a distance weighs as much as a radian, more than zero; `None` is an eighth of the
    /// longest way to a goal, or, where something floats or slides without end and the search is
    /// none that [tracks](super::Reach::track), of the longer way that it has to go. It decides
    /// what is nearest where the target cannot be reached, and how fast it is reached where it can.
    pub length_per_radian: Option<R>,
    /// The most that a hinge turns in one step, radians, more than zero; more than a turn is as
    /// much as a turn. A slide moves as far as it likes.
    pub max_step: R,
    /// λ of the damped least squares at the target itself, radians. Zero, the default, reaches it
    /// fastest; with λ no step is longer than |e|/(2λ) for an error |e|, also in front of a
    /// singular pose: right for a machine that follows a target.
    pub damping: R,
    /// Whether to begin again from another configuration where the search got stuck. If false,
    /// converge from the given start only: right for tracking a target that moves.
    pub restarts: bool,
    /// The part of the weighted squared error that a step must gain, from 0 to 1; one that gains
    /// less is the last, or where there is another beginning, the last from this one. Where there
    /// are more goals than freedom nothing is reached, and only this says that no more is to be
    /// had. Zero, the default, is no such end.
    pub least_gain: R,
    /// How much a radian from the [posture](super::Reach::with_posture) weighs against one from a
    /// target, everywhere and always, in searches that [track](super::Reach::track); others are
    /// invalid with it. Zero, the default, is what the goals leave free, after they are reached.
    pub posture_weight: R,
    /// How much a radian from the start weighs: of a target that moves, from the last frame. It
    /// takes the shaking out of what goals determine little, for a lag of its square times the way
    /// in a frame: √(rate/480) for frames per second makes that two milliseconds. Not of what
    /// floats, which it only makes slower. Like the weight of a posture, for searches that track.
    pub start_weight: R,
}

/// 10⁻⁵ rad and 10⁻⁵ lengths, 100 iterations, steps of at most 1.5 rad, restarts.
impl<R: Real> Default for Options<R> {
    fn default() -> Self {
        Self {
            angular_tolerance: R::from(1e-5),
            linear_tolerance: R::from(1e-5),
            max_iterations: 100,
            length_per_radian: None,
            max_step: R::from(1.5),
            damping: R::ZERO,
            restarts: true,
            least_gain: R::ZERO,
            posture_weight: R::ZERO,
            start_weight: R::ZERO,
        }
    }
}

impl<R: Real> Options<R> {
    /// To reach a target from anywhere: the default.
    #[must_use]
    pub fn solve() -> Self {
        Self::default()
    }

    /// To follow targets that move ([`Reach::track`](super::Reach::track)), from the last values:
    /// 10⁻⁴ rad and lengths, at most 3 steps, of which each must gain a hundredth; damped by
    /// 0.1 rad; no restarts.
    #[must_use]
    pub fn track() -> Self {
        let fine = R::from(1e-4);
        Self {
            angular_tolerance: fine,
            linear_tolerance: fine,
            max_iterations: 3,
            damping: R::from(0.1),
            restarts: false,
            least_gain: R::from(1e-2),
            ..Self::default()
        }
    }

    /// The same options in other numbers, by way of `f64`.
    #[must_use]
    pub fn cast<S: Real>(&self) -> Options<S> {
        let cast = |number: R| S::from_f64(number.into());
        Options {
            angular_tolerance: cast(self.angular_tolerance),
            linear_tolerance: cast(self.linear_tolerance),
            max_iterations: self.max_iterations,
            length_per_radian: self.length_per_radian.map(cast),
            max_step: cast(self.max_step),
            damping: cast(self.damping),
            restarts: self.restarts,
            least_gain: cast(self.least_gain),
            posture_weight: cast(self.posture_weight),
            start_weight: cast(self.start_weight),
        }
    }

    /// The most that a hinge turns in one step: no more than a turn, which is where every hinge has
    /// been.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn longest_step(&self) -> R {
        let turn = R::TWO * R::PI;
        if self.max_step < turn { self.max_step } else { turn }
    }

    /// Whether a search can be made with them.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn is_valid(&self) -> bool {
        let length = self.length_per_radian.unwrap_or(R::ONE);
        self.angular_tolerance >= R::ZERO
            && self.linear_tolerance >= R::ZERO
            && self.max_step > R::ZERO
            && self.damping >= R::ZERO
            && self.damping.is_finite()
            && self.least_gain >= R::ZERO
            && self.least_gain <= R::ONE
            && self.posture_weight >= R::ZERO
            && self.posture_weight.is_finite()
            && self.start_weight >= R::ZERO
            && self.start_weight.is_finite()
            && length > R::ZERO
            && length.is_finite()
    }
}

/// The result of a search.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(C)]
pub struct Report<R> {
    /// How it ended.
    pub outcome: Outcome,
    /// Steps and restarts together; zero where the start was good enough.
    pub iterations: u32,
    /// How many of them were restarts.
    pub restarts: u32,
    /// The turn that is left, radians.
    pub angular_error: R,
    /// The distance that is left.
    pub linear_error: R,
}

impl<R> Report<R> {
    /// `true` if both errors are within the tolerances.
    #[must_use]
    pub fn is_converged(&self) -> bool {
        self.outcome == Outcome::Converged
    }
}

/// The end of a search. The joint values are the best that were found, or of a search that
/// [tracks](super::Reach::track) the last, within the limits, but for [`Invalid`](Self::Invalid). C
/// and Python have the same numbers.
///
/// A search with [`restarts`](Options::restarts) that does not converge goes on until the
/// iterations run out. Then [`AtLimits`](Self::AtLimits) and [`Stalled`](Self::Stalled) say what
/// stopped its best try, and more [iterations](Options::max_iterations) may still find a solution
/// elsewhere.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(i32)]
pub enum Outcome {
    /// Both errors are within the tolerances.
    Converged = 0,
    /// A target is farther away than what carries the link is long: nothing can reach it. The end
    /// points as near to it as was found.
    OutOfReach = 1,
    /// No way led nearer, and a limit stands in the way: the best values have a joint at its limit.
    /// There may be a solution elsewhere.
    AtLimits = 2,
    /// No way led nearer: a local minimum, or a pose out of reach within the arm's length.
    Stalled = 3,
    /// The iterations ran out while the end still came nearer.
    Unfinished = 4,
    /// The target is farther than 10⁻³ from a unit motion (the norm of its real part, or its
    /// dual part along it), or a number is not finite, or a distance overflows; or an option is
    /// negative or NaN, a damping, weight or length per radian infinite, a gain above 1, or a step
    /// or length per radian zero. The joint values are untouched, the errors NaN.
    #[default]
    Invalid = 5,
}
