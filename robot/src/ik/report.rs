//! [`Options`] and [`Tracking`], the options of a search, and [`Report`], its result.

use dq8::Real;

/// The options of a search: its tolerances, its limits, and the weights in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options<R> {
    /// The largest angle to a target that counts as reached, radians.
    pub angular_tolerance: R,
    /// The largest distance from a target that counts as reached, in the mechanism's unit of
    /// length.
    pub linear_tolerance: R,
    /// The largest number of steps and restarts together. Most targets of an arm take six or seven
    /// iterations. The default of 100 is meant for the few targets in a hundred that need a
    /// restart. It costs time only if a target cannot be reached or a posture is far. Several goals
    /// on one tree may need 1000: a humanoid with four goals reached 93 % of random reachable
    /// targets within 100 iterations, and all of 200 targets within 1000.
    pub max_iterations: u32,
    /// The length, more than zero, for which an error of a distance weighs as much as an error of
    /// one radian. `None` means an eighth of the longest distance along the links to a goal. If a
    /// joint floats or slides without limits, the distance to the farthest target and the present
    /// slide count instead where they are longer, except in searches that
    /// [track](super::Reach::track). The length decides which pose is nearest to a target that
    /// cannot be reached, and how fast other targets are reached.
    pub length_per_radian: Option<R>,
    /// The largest change of a hinge in one step, in radians. It must be more than zero. A value of
    /// more than a turn acts like a turn. The steps of slides are not limited.
    pub max_step: R,
    /// The damping λ of the least squares where the error is zero, radians. Zero, the default,
    /// reaches targets fastest. With λ no step is longer than |e|/(2λ) for an error |e|, also
    /// near singular poses, which suits a machine that follows a target.
    pub damping: R,
    /// `true` if a search that is stuck begins again from another configuration; `false` if it only
    /// converges from its start, which suits a target that moves.
    pub restarts: bool,
    /// The part of the weighted squared error by which a step must reduce it, from 0 to 1. After a
    /// step that reduces it by less, the search ends or restarts. With more goals than freedoms no
    /// target is reached, and only this option ends a search that cannot get better. With zero, the
    /// default, no reduction is required.
    pub least_gain: R,
}

/// Sets tolerances of 10⁻⁵ rad and 10⁻⁵ lengths, 100 iterations, steps of at most 1.5 rad,
/// and restarts.
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
        }
    }
}

impl<R: Real> Options<R> {
    /// Returns options for reaching a target from anywhere, which are the default.
    #[must_use]
    pub fn solve() -> Self {
        Self::default()
    }

    /// Returns options for following moving targets ([`Reach::track`](super::Reach::track)) from
    /// the values of the previous frame: tolerances of 10⁻⁴ rad and 10⁻⁴ lengths, at most 3
    /// steps, a least gain of a hundredth of the squared error, a damping of 0.1 rad, and no
    /// restarts.
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

    /// Returns these options with another element type; values are converted to `f64` in between.
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
        }
    }

    /// Returns the largest change of a hinge in one step. It is never more than a turn, which
    /// brings a hinge through all of its poses.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn longest_step(&self) -> R {
        let turn = R::TWO * R::PI;
        if self.max_step < turn { self.max_step } else { turn }
    }

    /// Returns `true` if every option is within its range.
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
            && length > R::ZERO
            && length.is_finite()
    }
}

/// The options of a search that [tracks](super::Reach::track): the [`Options`] of any search, and
/// weights that act in every step together with the goals.
///
/// ```
/// use dq8_robot::ik::{Options, Tracking};
/// let options = Options { max_iterations: 5, ..Options::track() };
/// let tracking: Tracking<f64> = Tracking { start_weight: 0.2, ..options.into() };
/// assert_eq!((tracking.options.max_iterations, tracking.posture_weight), (5, 0.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tracking<R> {
    /// The options that every search has, by default [`Options::track`]. The option `restarts` has
    /// no effect in a search that tracks.
    pub options: Options<R>,
    /// The weight of a radian of distance from the [posture](super::Reach::with_posture), relative
    /// to a radian of distance from a target. It acts in every step. With zero, the default, the
    /// posture uses only the freedom that the goals leave, after the targets are reached; beside
    /// another weight that is not zero it does nothing.
    pub posture_weight: R,
    /// The weight of a radian of distance from the start. If a target moves, the start is the
    /// solution of the previous frame. It keeps joints that the goals hardly determine from
    /// shaking. In return, joints lag by w² frames, where w is this weight: at a rate of r frames
    /// per second, a weight of √(r/480) makes the lag two milliseconds. The default is zero.
    /// Floating joints have a weight of their own, the next field.
    pub start_weight: R,
    /// The weight of a radian by which a floating joint is turned from its start, and of the length
    /// that weighs as much as a radian by which it is moved. It acts in every step. So the base of
    /// a humanoid that walks can move freely while its joints are kept from shaking, or can be kept
    /// near the path from which the frames start. With zero, the default, floating joints move as
    /// the goals ask.
    pub floating_weight: R,
    /// `true` if a frame keeps the values from which it starts, unless a step reduces the weighted
    /// squared error by the part [`least_gain`](Options::least_gain). A target beyond reach that is
    /// asked again and again so leads to the same values, once steps gain less than that. With
    /// `false`, the default, a frame ends with its newest values: an arm goes with a target that
    /// moves beyond reach in every frame, but may sway by some tenths of a radian if the target
    /// stands still.
    pub steady: bool,
}

/// Makes tracking options of [`Options::track`], with weights of zero.
impl<R: Real> Default for Tracking<R> {
    fn default() -> Self {
        Options::track().into()
    }
}

/// Converts options to tracking options whose weights are zero.
impl<R: Real> From<Options<R>> for Tracking<R> {
    fn from(options: Options<R>) -> Self {
        let zero = R::ZERO;
        let [posture_weight, start_weight, floating_weight] = [zero; 3];
        Self { options, posture_weight, start_weight, floating_weight, steady: false }
    }
}

impl<R: Real> Tracking<R> {
    /// Returns these options with another element type; values are converted to `f64` in between.
    #[must_use]
    pub fn cast<S: Real>(&self) -> Tracking<S> {
        let [posture_weight, start_weight, floating_weight] =
            [self.posture_weight, self.start_weight, self.floating_weight]
                .map(|weight| S::from_f64(weight.into()));
        let options = self.options.cast();
        let steady = self.steady;
        Tracking { options, posture_weight, start_weight, floating_weight, steady }
    }
}

/// The options of a search, and the weights of [`Tracking`]. The weights are zero in a search that
/// does not track.
#[derive(Clone, Copy)]
pub(super) struct Settings<'s, R> {
    pub(super) options: &'s Options<R>,
    pub(super) posture_weight: R,
    pub(super) start_weight: R,
    pub(super) floating_weight: R,
    pub(super) steady: bool,
}

impl<'s, R: Real> From<&'s Options<R>> for Settings<'s, R> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn from(options: &'s Options<R>) -> Self {
        let zero = R::ZERO;
        let [posture_weight, start_weight, floating_weight] = [zero; 3];
        Self { options, posture_weight, start_weight, floating_weight, steady: false }
    }
}

impl<'s, R: Real> From<&'s Tracking<R>> for Settings<'s, R> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn from(tracking: &'s Tracking<R>) -> Self {
        let Tracking { posture_weight, start_weight, floating_weight, steady, .. } = *tracking;
        Self { options: &tracking.options, posture_weight, start_weight, floating_weight, steady }
    }
}

impl<R: Real> Settings<'_, R> {
    /// Returns `true` if all weights are finite and not negative.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn has_valid_weights(&self) -> bool {
        let is_valid = |weight: R| weight >= R::ZERO && weight.is_finite();
        is_valid(self.posture_weight)
            && is_valid(self.start_weight)
            && is_valid(self.floating_weight)
    }
}

/// The result of a search: its outcome, its number of iterations, and the remaining errors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(C)]
pub struct Report<R> {
    /// The way in which the search ended.
    pub outcome: Outcome,
    /// The number of steps and restarts together; zero if the start was within the tolerances.
    pub iterations: u32,
    /// The number of restarts among the iterations.
    pub restarts: u32,
    /// The largest remaining angle to a target, radians.
    pub angular_error: R,
    /// The largest remaining distance from a target, in the mechanism's unit of length.
    pub linear_error: R,
}

impl<R: Real> Report<R> {
    /// The report of a search with an invalid input.
    pub(super) const INVALID: Self = Self {
        outcome: Outcome::Invalid,
        iterations: 0,
        restarts: 0,
        angular_error: R::NAN,
        linear_error: R::NAN,
    };
}

impl<R> Report<R> {
    /// Returns `true` if both errors are within the tolerances.
    #[must_use]
    pub fn is_converged(&self) -> bool {
        self.outcome == Outcome::Converged
    }
}

/// The way in which a search ended. The returned joint values are the best values that were found,
/// or the final values of a search that [tracks](super::Reach::track), within the limits. Only
/// [`Invalid`](Self::Invalid) leaves the caller's values as they were. The discriminants are the
/// same in C and Python.
///
/// A search with [`restarts`](Options::restarts) that does not converge goes on until the
/// iterations run out. Then [`AtLimits`](Self::AtLimits) and [`Stalled`](Self::Stalled) say what
/// stopped its best attempt. More [iterations](Options::max_iterations) may still find a solution
/// from another start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(i32)]
pub enum Outcome {
    /// Both errors are within the tolerances.
    Converged = 0,
    /// A target is farther from the base than the whole length of the chain that carries the link,
    /// so no values reach it. The returned values bring the link as near to the target as the
    /// search has found.
    OutOfReach = 1,
    /// No step reduced the error, and the best values have a joint at its limit. There may be a
    /// solution far from these values.
    AtLimits = 2,
    /// No step reduced the error: the search is in a local minimum, or the arm is long enough but
    /// cannot take the pose.
    Stalled = 3,
    /// The iterations ran out while steps still reduced the error.
    Unfinished = 4,
    /// An input is invalid; the joint values are untouched, and the errors are NaN. This happens if
    /// a target is farther than 10⁻³ from a unit motion (by the norm of its real part, or by the
    /// dot product of its real and dual parts), if a value or a component of a target is not
    /// finite, or if a distance overflows. It also happens if an option is out of range: negative
    /// or NaN, an infinite damping, weight or length per radian, a least gain above 1, or a step or
    /// length per radian of zero.
    #[default]
    Invalid = 5,
}
