use super::error::ArmError;
use crate::geometry::{Line, Screw, Twist};
use crate::mechanism::{JointKind, UNIT};
use crate::real::Real;
use crate::scalar::{DualQuat, vector};

/// A joint with one degree of freedom: a hinge, a slide or a screw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint<R> {
    /// How the joint moves what hangs on it, for a rate of 1: the spatial twist, in the frame of the
    /// base, where all joints are zero. A unit angular part, or none and a unit linear part; an arm
    /// takes it where that is off by up to 10⁻³, and makes it so.
    pub screw: Twist<R>,
    /// The least and the largest value; radians, or lengths for a slide.
    pub limits: [R; 2],
}

impl<R: Real> Joint<R> {
    /// A hinge with limits ±π about the line along `axis`, which must have length 1, and through the
    /// point `through`: ω = axis, v = through × axis.
    #[must_use]
    pub fn revolute(axis: [R; 3], through: [R; 3]) -> Self {
        // From the foot of the perpendicular: what `through` has along the axis adds nothing to v but
        // rounding, and rounding along the axis would be a pitch.
        let foot = vector::across(axis, through);
        let screw = Twist { angular: axis, linear: vector::cross(foot, axis) };
        Self { screw, limits: [-R::PI, R::PI] }
    }

    /// A slide along `direction`, which must have length 1: ω = 0, v = direction.
    #[must_use]
    pub fn prismatic(direction: [R; 3], limits: [R; 2]) -> Self {
        Self { screw: Twist { angular: [R::ZERO; 3], linear: direction }, limits }
    }

    /// The same joint with other limits. They may be infinite where nothing slides.
    ///
    /// A hinge whose limits span a whole turn is never stopped by them: it goes on a turn less. Of the values within
    /// its limits that are the same pose, an arm returns the nearest to the start. One whose limits span more than
    /// sixteen turns, or have no end, stays within 64 radians of zero (`f32`; `f64`: 2²⁰), or in the turn within its
    /// limits that is nearest to it: a float many turns away is too coarse an angle.
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
    fn pitch(&self) -> R {
        vector::dot(self.screw.angular, self.screw.linear)
    }

    /// With a unit screw; and its pitch, zero where it is only what rounding has left of a hinge.
    pub(super) fn checked(self, index: usize) -> Result<(Self, R), ArmError> {
        let Twist { angular, linear } = self.screw;
        let lengths = [vector::norm(angular), vector::norm(linear)];
        let unit = if self.is_slide() { lengths[1] } else { lengths[0] };
        let is_unit = (unit - R::ONE).abs() <= R::from(UNIT);
        if !is_unit || !lengths[1].is_finite() {
            return Err(self.screw_error(index));
        }
        let angular = vector::over_norm(angular, unit);
        let linear = vector::over_norm(linear, unit);
        let along = vector::dot(angular, linear);
        let is_hinge = along.abs() <= R::from(32.0) * R::EPSILON * lengths[1];
        let (linear, pitch) =
            if is_hinge { (vector::across(angular, linear), R::ZERO) } else { (linear, along) };
        Ok((Self { screw: Twist { angular, linear }, ..self }, pitch))
    }

    pub(super) fn screw_error(&self, index: usize) -> ArmError {
        let Twist { angular, linear } = self.screw;
        let [angular, linear] = [angular, linear].map(|part| vector::norm(part).into());
        ArmError::Screw { joint: index, angular, linear }
    }

    pub(super) fn limits_error(&self, index: usize) -> ArmError {
        let [low, high] = self.limits.map(Into::into);
        ArmError::Limits { joint: index, low, high }
    }

    /// What it is in a mechanism, in a frame on its axis that is parallel to the base at zero.
    pub(super) fn kind(&self, pitch: R) -> JointKind<R> {
        let Twist { angular: axis, linear } = self.screw;
        if self.is_slide() {
            JointKind::Prismatic { axis: linear }
        } else if pitch == R::ZERO {
            JointKind::Revolute { axis }
        } else {
            JointKind::Screw { axis, pitch }
        }
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
