//! What is computed of a mechanism on lanes, each with a configuration and targets of its own.

use super::problem::Reach;
use super::report::Options;
use super::scratch::Scratch;
use dq8::Scalar;
use dq8_simd::Lanes;

/// With `TRACK`, steps are of first order, and of many goals in the shape of the tree: a constant
/// of the type, so that firmware that does not follow many goals does not hold it.
pub(super) struct Model<'s, L: Lanes, const TRACK: bool> {
    pub(super) level: L::Level,
    pub(super) reach: &'s Reach<'s, L::Real>,
    pub(super) scales: Scales<L>,
    pub(super) scratch: Scratch<'s, L>,
    pub(super) follows: Follows<L>,
}

/// How a target that moves is followed.
#[derive(Clone, Copy)]
pub(super) struct Follows<L> {
    /// Whether in the shape of the tree.
    by_tree: bool,
    /// Whether the posture or the start weighs something, and the squares of both.
    weighs: bool,
    pub(super) posture: L,
    pub(super) start: L,
}

/// What makes lengths and radians comparable, and what keeps a step short.
#[derive(Clone, Copy)]
pub(super) struct Scales<L> {
    /// The length that weighs as much as a radian.
    pub(super) length: L,
    pub(super) radians_per_length: L,
    /// The most that a hinge turns.
    pub(super) longest: L,
    /// λ² where the target is.
    pub(super) least_damping: L,
}

/// How far the lanes are from their targets.
#[derive(Clone, Copy)]
pub(super) struct Apart<L> {
    /// The weighted sum of squares of all errors, in radians².
    pub(super) square: L,
    /// The largest turn and the largest distance among the goals, of what is asked for.
    pub(super) angular: L,
    pub(super) linear: L,
}

/// What a step did.
#[derive(Clone, Copy)]
pub(super) struct Stepped<L> {
    /// Where a limit cut it short, the square of the errors that it would leave by its own linear
    /// model; elsewhere zero.
    pub(super) left: L,
    /// The square of all changes, in radians.
    pub(super) moved: L,
}

impl<'s, L: Lanes<Real: Scalar>, const TRACK: bool> Model<'s, L, TRACK> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(
        level: L::Level,
        reach: &'s Reach<'s, L::Real>,
        options: &Options<L::Real>,
        memory: &'s mut [L::Real],
    ) -> Option<Self> {
        let scratch = Scratch::new(reach, memory)?;
        // Each lane has its own with what it is given.
        let one = L::splat(level, dq8::Real::ONE);
        let damping = L::splat(level, options.damping);
        let scales = Scales {
            length: one,
            radians_per_length: one,
            longest: L::splat(level, options.longest_step()),
            least_damping: damping * damping,
        };
        let square = |weight: L::Real| L::splat(level, weight * weight);
        let posture = reach.posture.map_or(L::Real::default(), |_| options.posture_weight);
        let follows = Follows {
            by_tree: TRACK && reach.is_by_tree(options),
            weighs: TRACK && reach.weighs(options),
            posture: square(posture),
            start: square(options.start_weight),
        };
        Some(Self { level, reach, scales, scratch, follows })
    }

    /// Whether the posture or the start always acts.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn weighs(&self) -> bool {
        TRACK && self.follows.weighs
    }

    /// Whether the system has the shape of the tree.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn is_by_tree(&self) -> bool {
        TRACK && self.follows.by_tree
    }
}
