//! [`Goal`], the components of a link's pose that should reach a target, and [`ReachError`], the
//! error of goals and limits for which there can be no search.

use dq8::Real;
use dq8::internal::errors;

/// A goal of a link: the components of its error that a search should bring to zero, and their
/// weights. The weights decide which components count more if not all of them can become zero.
///
/// Components are in the axes of the *target*: the rotation from the link to the target as a
/// rotation vector in radians, and the vector from the [`point`](Self::point) of the link to the
/// target's origin. A weight of zero leaves its component free: a drill may turn about its own
/// axis, and a cup may slide along a table.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Goal<R> {
    /// The index of the link.
    pub link: usize,
    /// The weights of the rotation about the target's x, y and z: zero, or from 10⁻⁶ to 10⁶.
    pub angular: [R; 3],
    /// The weights of the distances along the target's x, y and z: zero, or from 10⁻⁶ to 10⁶.
    pub linear: [R; 3],
    /// The point of the link, in the link's frame, that should be at the target's origin. Zero is
    /// the link's own origin.
    pub point: [R; 3],
}

impl<R: Real> Goal<R> {
    /// Makes a goal for the rotation and the position of a link.
    #[must_use]
    pub fn pose(link: usize) -> Self {
        Self { link, angular: [R::ONE; 3], linear: [R::ONE; 3], point: [R::ZERO; 3] }
    }

    /// Makes a goal for the position of a link's origin; the rotation of the link is free.
    #[must_use]
    pub fn position(link: usize) -> Self {
        Self { angular: [R::ZERO; 3], ..Self::pose(link) }
    }

    /// Makes a goal for the rotation of a link; the position of the link is free.
    #[must_use]
    pub fn orientation(link: usize) -> Self {
        Self { linear: [R::ZERO; 3], ..Self::pose(link) }
    }

    /// Returns this goal for a point of the link, in the frame of the link, such as a fingertip, a
    /// heel, or the centre of a camera.
    #[must_use]
    pub fn at(self, point: [R; 3]) -> Self {
        Self { point, ..self }
    }

    /// Returns this goal with one weight for the whole rotation and one weight for the whole
    /// position. The weight zero leaves the rotation or the position free.
    #[must_use]
    pub fn weighing(self, rotation: R, position: R) -> Self {
        Self { angular: [rotation; 3], linear: [position; 3], ..self }
    }

    /// Returns this goal with another element type; values are converted to `f64` in between.
    #[must_use]
    pub fn cast<S: Real>(&self) -> Goal<S> {
        let [angular, linear, point] = [self.angular, self.linear, self.point]
            .map(|numbers| numbers.map(|number| S::from_f64(number.into())));
        Goal { link: self.link, angular, linear, point }
    }

    /// Returns this goal with other weights of the rotation.
    #[must_use]
    pub fn with_angular(self, angular: [R; 3]) -> Self {
        Self { angular, ..self }
    }

    /// Returns this goal with other weights of the position.
    #[must_use]
    pub fn with_linear(self, linear: [R; 3]) -> Self {
        Self { linear, ..self }
    }
}

impl<R: Real> Goal<R> {
    /// Returns the number of components with a weight.
    #[inline]
    pub(super) fn rows(&self) -> usize {
        let mut rows = 0;
        for weight in self.angular.into_iter().chain(self.linear) {
            rows += usize::from(weight > R::ZERO);
        }
        rows
    }

    /// Returns `true` if the goal is for another point than the link's origin.
    pub(super) fn is_off(&self) -> bool {
        self.point != [R::ZERO; 3]
    }

    /// Returns `true` if some component of the rotation has a weight.
    pub(super) fn asks_rotation(&self) -> bool {
        let [x, y, z] = self.angular;
        x + y + z > R::ZERO
    }

    /// Returns `true` if some components of the rotation have a weight and others are free.
    pub(super) fn asks_part_of_rotation(&self) -> bool {
        let [x, y, z] = self.angular;
        let all = x > R::ZERO && y > R::ZERO && z > R::ZERO;
        self.asks_rotation() && !all
    }

    /// Returns `true` if all six components have a weight. Then the error is the twist of a single
    /// screw motion.
    #[inline]
    pub(super) fn is_pose(&self) -> bool {
        let [x, y, z] = self.linear;
        let all = x > R::ZERO && y > R::ZERO && z > R::ZERO;
        all && self.asks_rotation() && !self.asks_part_of_rotation()
    }

    /// Returns `true` if the weights of rotation are equal for all axes, and the weights of
    /// position too, so that the frame of the error does not matter.
    pub(super) fn is_even(&self) -> bool {
        let ([a, b, c], [x, y, z]) = (self.angular, self.linear);
        a == b && b == c && x == y && y == z
    }
}

/// Makes a list of one goal.
#[cfg(feature = "alloc")]
impl<R> From<Goal<R>> for alloc::vec::Vec<Goal<R>> {
    fn from(goal: Goal<R>) -> Self {
        alloc::vec![goal]
    }
}

errors! {
    /// The error of goals or limits for which there can be no search.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    ReachError {
        /// The list of goals is empty.
        NoGoals => "there is no goal";
        /// A goal is for a link that does not exist.
        Link {
            goal: usize = "The goal.", link: usize = "The link that it names.", links: usize = "The number of links."
        }
            => "goal {goal} is for link {link}, and there are {links} links";
        /// A weight is neither zero nor between 10⁻⁶ and 10⁶.
        Weight {
            goal: usize = "The goal.",
            component: usize = "The component: 0 to 2 of the rotation, 3 to 5 of the position.",
            value: f64 = "The weight."
        }
            => "component {component} of goal {goal} has the weight {value}: a weight is zero, or from 1e-6 to 1e6";
        /// A coordinate of the point of a goal is not finite.
        Point { goal: usize = "The goal.", component: usize = "The component.", value: f64 = "The number." }
            => "component {component} of the point of goal {goal} is not finite: {value}";
        /// All weights of a goal are zero.
        NoWeight { goal: usize = "The goal." } => "all weights of goal {goal} are zero";
        /// A goal is for a link that no joint moves: all joints that carry the link are fixed, or
        /// mimic other joints with the multiplier zero.
        Unmoved { goal: usize = "The goal.", link: usize = "The link that it names." }
            => "goal {goal} is for link {link}, which no joint moves";
        /// The memory for the freedoms is too short.
        Freedoms { freedoms: usize = "The number of them that fit.", rates: usize = "The number of rates of the mechanism." }
            => "expected memory for {rates} freedoms, one for each rate, got {freedoms}";
        /// The limits of a joint, and of the joints that mimic it, leave no value, or are so large
        /// that floats do not tell the angles apart (beyond 2¹⁷ radians for `f32`, 2⁴⁶ for
        /// `f64`).
        Limits { joint: usize = "The joint.", low: f64 = "The lower limit.", high: f64 = "The upper limit." }
            => "joint {joint} cannot move between {low} and {high}: its limits, and those of joints that mimic it, must leave \
                a value, and angles must be small enough for floats to tell them apart";
        /// The length of a posture differs from that of a configuration.
        PostureLength { length: usize = "The number of its values.", expected: usize = "The number of values of a configuration." }
            => "expected a posture of {expected} values, got {length}";
        /// A value of a posture is not finite.
        Posture { index: usize = "The index of the value.", value: f64 = "The value." }
            => "value {index} of the posture is not finite: {value}";
    }
}
