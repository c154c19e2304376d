use dq8::Real;

/// What is asked of a link: which of the six components of its error vanish, and how much each weighs
/// where not all can.
///
/// Components are in the axes of the *target*: the rotation from the link to the target as a rotation
/// vector, radians, and the way from the link's origin to the target's. A weight of zero leaves its
/// component free: a drill may turn about its own axis, a cup on a table slide along it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Goal<R> {
    /// The link.
    pub link: usize,
    /// The weights of the rotation about the target's x, y and z: zero, or from 10⁻⁶ to 10⁶.
    pub angular: [R; 3],
    /// The weights of the way along the target's x, y and z, likewise.
    pub linear: [R; 3],
}

impl<R: Real> Goal<R> {
    /// Rotation and position of the link.
    #[must_use]
    pub fn pose(link: usize) -> Self {
        Self { link, angular: [R::ONE; 3], linear: [R::ONE; 3] }
    }

    /// The position of the link's origin; its rotation is free.
    #[must_use]
    pub fn position(link: usize) -> Self {
        Self { link, angular: [R::ZERO; 3], linear: [R::ONE; 3] }
    }

    /// The rotation of the link; its position is free.
    #[must_use]
    pub fn orientation(link: usize) -> Self {
        Self { link, angular: [R::ONE; 3], linear: [R::ZERO; 3] }
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
