use dq8::Real;

/// What is asked of a link: which of the six components of its error vanish, and how much each
/// weighs where not all can.
///
/// Components are in the axes of the *target*: the rotation from the link to the target as a
/// rotation vector, radians, and the way from the [`point`](Self::point) of the link to the
/// target's origin. A weight of zero leaves its component free: a drill may turn about its own
/// axis, a cup on a table slide along it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Goal<R> {
    /// The link.
    pub link: usize,
    /// The weights of the rotation about the target's x, y and z: zero, or from 10⁻⁶ to 10⁶.
    pub angular: [R; 3],
    /// The weights of the way along the target's x, y and z, likewise.
    pub linear: [R; 3],
    /// The point of the link, in its frame, that is to be at the target's origin; zero is the
    /// link's own origin.
    pub point: [R; 3],
}

impl<R: Real> Goal<R> {
    /// Rotation and position of the link.
    #[must_use]
    pub fn pose(link: usize) -> Self {
        Self { link, angular: [R::ONE; 3], linear: [R::ONE; 3], point: [R::ZERO; 3] }
    }

    /// The position of the link's origin; its rotation is free.
    #[must_use]
    pub fn position(link: usize) -> Self {
        Self { angular: [R::ZERO; 3], ..Self::pose(link) }
    }

    /// The rotation of the link; its position is free.
    #[must_use]
    pub fn orientation(link: usize) -> Self {
        Self { linear: [R::ZERO; 3], ..Self::pose(link) }
    }

    /// The same goal at a point of the link, in its frame: a fingertip, a heel, the middle of a
    /// camera.
    #[must_use]
    pub fn at(self, point: [R; 3]) -> Self {
        Self { point, ..self }
    }

    /// The same goal, of which rotation and position weigh as much as is said; what weighs nothing
    /// is free.
    #[must_use]
    pub fn weighing(self, rotation: R, position: R) -> Self {
        Self { angular: [rotation; 3], linear: [position; 3], ..self }
    }

    /// The same goal in other numbers, by way of `f64`.
    #[must_use]
    pub fn cast<S: Real>(&self) -> Goal<S> {
        let [angular, linear, point] = [self.angular, self.linear, self.point]
            .map(|numbers| numbers.map(|number| S::from_f64(number.into())));
        Goal { link: self.link, angular, linear, point }
    }

    /// The same goal with other weights of the rotation.
    #[must_use]
    pub fn with_angular(self, angular: [R; 3]) -> Self {
        Self { angular, ..self }
    }

    /// The same goal with other weights of the position.
    #[must_use]
    pub fn with_linear(self, linear: [R; 3]) -> Self {
        Self { linear, ..self }
    }
}

impl<R: Real> Goal<R> {
    /// How many components are asked for.
    pub(super) fn rows(&self) -> usize {
        let mut rows = 0;
        for weight in self.angular.into_iter().chain(self.linear) {
            rows += usize::from(weight > R::ZERO);
        }
        rows
    }

    /// Whether it is at another point than the link's origin.
    pub(super) fn is_off(&self) -> bool {
        self.point != [R::ZERO; 3]
    }

    /// Whether the rotation is free, in part, or not at all.
    pub(super) fn asks_rotation(&self) -> bool {
        let [x, y, z] = self.angular;
        x + y + z > R::ZERO
    }

    /// Whether some of the rotation is asked for, and some is free.
    pub(super) fn asks_part_of_rotation(&self) -> bool {
        let [x, y, z] = self.angular;
        let all = x > R::ZERO && y > R::ZERO && z > R::ZERO;
        self.asks_rotation() && !all
    }

    /// Whether all six components are asked for: then the error is one screw.
    pub(super) fn is_pose(&self) -> bool {
        let [x, y, z] = self.linear;
        let all = x > R::ZERO && y > R::ZERO && z > R::ZERO;
        all && self.asks_rotation() && !self.asks_part_of_rotation()
    }

    /// Whether the axes do not matter: all weigh alike.
    pub(super) fn is_even(&self) -> bool {
        let ([a, b, c], [x, y, z]) = (self.angular, self.linear);
        a == b && b == c && x == y && y == z
    }
}

/// One goal, where many may stand.
#[cfg(feature = "alloc")]
impl<R> From<Goal<R>> for alloc::vec::Vec<Goal<R>> {
    fn from(goal: Goal<R>) -> Self {
        alloc::vec![goal]
    }
}
