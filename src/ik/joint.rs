use crate::geometry::{Line, Screw, Twist};
use crate::real::Real;
use crate::scalar::{DualQuat, vector};

/// A joint with one degree of freedom: a hinge, a slide or a screw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint<R> {
    /// How the joint moves what hangs on it, for a rate of 1: the spatial twist, in the frame of the
    /// base, where all joints are zero. A unit angular part, or none and a unit linear part.
    pub screw: Twist<R>,
    /// The least and the largest value; radians, or lengths for a slide.
    pub limits: [R; 2],
}

impl<R: Real> Joint<R> {
    /// A hinge with limits ±π about the line along `axis`, which must have length 1, and through the
    /// point `through`: ω = axis, v = through × axis.
    #[must_use]
    pub fn revolute(axis: [R; 3], through: [R; 3]) -> Self {
        let screw = Twist { angular: axis, linear: vector::cross(through, axis) };
        Self { screw, limits: [-R::PI, R::PI] }
    }

    /// A slide along `direction`, which must have length 1: ω = 0, v = direction.
    #[must_use]
    pub fn prismatic(direction: [R; 3], limits: [R; 2]) -> Self {
        Self { screw: Twist { angular: [R::ZERO; 3], linear: direction }, limits }
    }

    /// The same joint with other limits. They may be infinite where nothing slides.
    ///
    /// A hinge whose limits span a whole turn is never stopped by them: it goes on a turn less.
    #[must_use]
    pub fn with_limits(self, limits: [R; 2]) -> Self {
        Self { limits, ..self }
    }

    /// The motion that the joint makes from zero to `value`: exp(½ value ξ), written as the screw
    /// that it is, which has a derivative at zero too.
    #[must_use]
    pub fn motion(&self, value: R) -> DualQuat<R> {
        let Twist { angular, linear } = self.screw;
        let screw = if self.is_slide() {
            let axis = Line { direction: linear, moment: [R::ZERO; 3] };
            Screw { axis, angle: R::ZERO, slide: value }
        } else {
            let pitch = self.pitch();
            let moment = vector::sub(linear, vector::scale(angular, pitch));
            let axis = Line { direction: angular, moment };
            Screw { axis, angle: value, slide: pitch * value }
        };
        DualQuat::from_screw(screw)
    }

    /// Whether nothing turns.
    pub(super) fn is_slide(&self) -> bool {
        self.screw.angular == [R::ZERO; 3]
    }

    /// ω·v, the way along the axis for a radian; zero for slides.
    pub(super) fn pitch(&self) -> R {
        vector::dot(self.screw.angular, self.screw.linear)
    }

    /// Whether a turn less is the same pose, and always within the limits.
    pub(super) fn wraps(&self) -> bool {
        let [low, high] = self.limits;
        let pitch = self.pitch().abs();
        !self.is_slide() && high - low >= R::TWO * R::PI && pitch <= R::from(8.0) * R::EPSILON
    }
}

/// The pose of the end of a chain of joints, one product after the other.
pub(super) fn chain<R: Real, const N: usize>(
    joints: &[Joint<R>; N],
    home: DualQuat<R>,
    values: &[R; N],
) -> DualQuat<R> {
    let mut pose = DualQuat::IDENTITY;
    for (joint, &value) in joints.iter().zip(values) {
        pose = pose * joint.motion(value);
    }
    pose * home
}
