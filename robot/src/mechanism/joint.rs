//! Joints as the caller describes them, and the errors that a description can have.

use dq8::Real;
use dq8::internal::errors;
use dq8::scalar::DualQuat;

/// The joint that carries a link: its place on the parent link, and the motion that it allows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint<R> {
    /// The index of the parent link, which must be lower than the index of this joint; `None` if
    /// the joint stands on the base.
    pub parent: Option<usize>,
    /// The pose of the joint in the frame of the parent. While the value of the joint is zero, the
    /// link has this pose. The dual quaternion may differ from unit by at most 10⁻³, and is
    /// normalized.
    pub placement: DualQuat<R>,
    /// The motion that the joint allows, with its axis or normal.
    pub kind: JointKind<R>,
    /// The lower and the upper limit of the joint's value. Only a joint with one value may have
    /// limits. Inverse kinematics ([`Reach`](crate::Reach)) keeps to these limits; poses are
    /// computed for any values.
    pub limits: Option<[R; 2]>,
    /// The rule by which this joint follows the value of another joint; `None` if it follows none.
    pub mimic: Option<Mimic<R>>,
}

/// The motion that a joint allows, in the joint's own frame. The length of axes and normals may
/// differ from 1 by at most 10⁻³, and is normalized to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum JointKind<R> {
    /// Does not move, and has no value.
    Fixed,
    /// Turns about `axis`, which passes through the origin of the joint's frame. It has one value,
    /// in radians. A revolute joint without limits is the continuous joint of URDF.
    Revolute {
        /// The direction of the axis, of length 1.
        axis: [R; 3],
    },
    /// Slides along `axis`. It has one value, a length.
    Prismatic {
        /// The direction of the axis, of length 1.
        axis: [R; 3],
    },
    /// Turns about `axis` and slides along it by `pitch` for each radian. It has one value, in
    /// radians.
    Screw {
        /// The direction of the axis, of length 1.
        axis: [R; 3],
        /// The length per radian: the lead of the thread divided by 2π.
        pitch: R,
    },
    /// Slides in the plane perpendicular to `normal`, then turns about the normal. It has three
    /// values: the lengths x and y, and the angle in radians. The directions of x and y are the x
    /// and y axes of the joint's frame, turned by the shortest rotation that takes z to the normal
    /// (if the normal is −z, by half a turn about x). Its three rates are ẋ, ẏ, θ̇.
    Planar {
        /// The direction of the normal, of length 1.
        normal: [R; 3],
    },
    /// Moves freely. It has seven values, `[x, y, z, w, tx, ty, tz]`: a quaternion of any length
    /// but zero, which is normalized to the rotation, and the translation. Its six rates are the
    /// body twist `[ωx, ωy, ωz, vx, vy, vz]`, in the frame of the link.
    Floating,
}

/// The rule of a joint that follows another joint. The value of the follower is `multiplier` ·
/// value(`joint`) + `offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mimic<R> {
    /// The index of the joint that is followed. That joint must have one value of its own, so it
    /// must not mimic a third joint.
    pub joint: usize,
    /// The factor by which the value of the followed joint is multiplied.
    pub multiplier: R,
    /// The value that is added to the product.
    pub offset: R,
}

impl<R> Joint<R> {
    /// Returns a joint of any kind, without limits, that mimics no other joint.
    #[must_use]
    pub fn new(parent: Option<usize>, placement: DualQuat<R>, kind: JointKind<R>) -> Self {
        Self { parent, placement, kind, limits: None, mimic: None }
    }

    /// Returns the joint of a link that does not move on its parent.
    #[must_use]
    pub fn fixed(parent: Option<usize>, placement: DualQuat<R>) -> Self {
        Self::new(parent, placement, JointKind::Fixed)
    }

    /// Returns a hinge about `axis`, which must have length 1.
    #[must_use]
    pub fn revolute(parent: Option<usize>, placement: DualQuat<R>, axis: [R; 3]) -> Self {
        Self::new(parent, placement, JointKind::Revolute { axis })
    }

    /// Returns a slide along `axis`, which must have length 1.
    #[must_use]
    pub fn prismatic(parent: Option<usize>, placement: DualQuat<R>, axis: [R; 3]) -> Self {
        Self::new(parent, placement, JointKind::Prismatic { axis })
    }

    /// Returns a screw joint about `axis`, which must have length 1. The link moves along the axis
    /// by `pitch` for each radian.
    #[must_use]
    pub fn screw(parent: Option<usize>, placement: DualQuat<R>, axis: [R; 3], pitch: R) -> Self {
        Self::new(parent, placement, JointKind::Screw { axis, pitch })
    }

    /// Returns the joint of a plate that slides in the plane perpendicular to `normal` and turns
    /// about the normal, which must have length 1.
    #[must_use]
    pub fn planar(parent: Option<usize>, placement: DualQuat<R>, normal: [R; 3]) -> Self {
        Self::new(parent, placement, JointKind::Planar { normal })
    }

    /// Returns the joint of a body that moves freely, such as a humanoid's pelvis or a drone.
    #[must_use]
    pub fn floating(parent: Option<usize>, placement: DualQuat<R>) -> Self {
        Self::new(parent, placement, JointKind::Floating)
    }

    /// Returns this joint with the limits `[least, largest]` of its value.
    #[must_use]
    pub fn with_limits(self, limits: [R; 2]) -> Self {
        Self { limits: Some(limits), ..self }
    }

    /// Returns this joint as a follower of `joint`: its value is `multiplier` · value(`joint`) +
    /// `offset`.
    #[must_use]
    pub fn mimicking(self, joint: usize, multiplier: R, offset: R) -> Self {
        Self { mimic: Some(Mimic { joint, multiplier, offset }), ..self }
    }
}

impl<R: Real> Joint<R> {
    /// Returns this joint with another element type; values are converted to `f64` in between.
    #[must_use]
    pub fn cast<S: Real>(&self) -> Joint<S> {
        let mimic = self.mimic.map(|mimic| Mimic {
            joint: mimic.joint,
            multiplier: cast(mimic.multiplier),
            offset: cast(mimic.offset),
        });
        Joint {
            parent: self.parent,
            placement: DualQuat::from_array(self.placement.to_array().map(cast)),
            kind: self.kind.cast(),
            limits: self.limits.map(|limits| limits.map(cast)),
            mimic,
        }
    }
}

impl<R: Real> JointKind<R> {
    fn cast<S: Real>(&self) -> JointKind<S> {
        match *self {
            Self::Fixed => JointKind::Fixed,
            Self::Revolute { axis } => JointKind::Revolute { axis: axis.map(cast) },
            Self::Prismatic { axis } => JointKind::Prismatic { axis: axis.map(cast) },
            Self::Screw { axis, pitch } => {
                JointKind::Screw { axis: axis.map(cast), pitch: cast(pitch) }
            }
            Self::Planar { normal } => JointKind::Planar { normal: normal.map(cast) },
            Self::Floating => JointKind::Floating,
        }
    }
}

fn cast<R: Real, S: Real>(number: R) -> S {
    S::from_f64(number.into())
}

impl<R> JointKind<R> {
    /// Returns the count of values that give the position of the joint.
    #[must_use]
    pub fn values(&self) -> usize {
        match self {
            Self::Fixed => 0,
            Self::Revolute { .. } | Self::Prismatic { .. } | Self::Screw { .. } => 1,
            Self::Planar { .. } => 3,
            Self::Floating => 7,
        }
    }

    /// Returns the count of rates that give the velocity of the joint.
    #[must_use]
    pub fn rates(&self) -> usize {
        match self {
            Self::Floating => 6,
            other => other.values(),
        }
    }
}

errors! {
    /// An error in the joints of a mechanism. Each variant holds the index of the joint.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    MechanismError {
        /// The parent of a joint is the joint itself, is a later joint, or does not exist. A parent
        /// must come before its children, which also rules out circles.
        Parent { joint: usize = "The joint.", parent: usize = "Its parent." }
            => "joint {joint} has the parent {parent}, but a parent must have a lower number than its joint";
        /// The rotation of a placement is not a unit quaternion.
        Placement { joint: usize = "The joint.", norm: f64 = "The norm of the real part." }
            => "the placement of joint {joint} is not a unit dual quaternion: the norm of its real part is {norm}, not 1";
        /// The dual part of a placement is not perpendicular to its real part, so the placement is
        /// no rigid motion.
        DualPart {
            joint: usize = "The joint.",
            along: f64 = "The dot product of its real and dual parts."
        }
            => "the placement of joint {joint} is not a motion: the dot product of its real and dual parts is {along}, not 0";
        /// A component or parameter of the joint is infinite or NaN.
        NotFinite {
            joint: usize = "The joint.", what: &'static str = "The part of the joint that holds it.", value: f64 = "The number."
        }
            => "the {what} of joint {joint} is not finite: {value}";
        /// An axis or a normal does not have length 1.
        Axis { joint: usize = "The joint.", length: f64 = "The length." }
            => "the axis of joint {joint} has length {length}, not 1";
        /// A [`Screw`](dq8::geometry::Screw) does not describe a joint. The screw of a joint has
        /// angle 1 and a finite slide, or angle 0 and slide 1.
        Screw { joint: usize = "The joint.", angle: f64 = "The angle of the screw.", slide: f64 = "Its slide." }
            => "the screw of joint {joint} turns by {angle} and slides by {slide} for a value of 1: a hinge or a thread \
                must turn by 1, and a slide must turn by 0 and slide by 1";
        /// Limits are not in order or are NaN, or the joint that has them does not have exactly one
        /// value.
        Limits { joint: usize = "The joint.", low: f64 = "The lower limit.", high: f64 = "The upper limit." }
            => "joint {joint} has the limits {low} and {high}: the first must not exceed the second, and the joint must \
                have exactly one value";
        /// A joint cannot mimic another joint. The other joint does not exist, is the joint itself,
        /// or mimics a third joint, or one of the two joints does not have exactly one value.
        Mimic { joint: usize = "The joint.", other: usize = "The joint that it should mimic." }
            => "joint {joint} cannot mimic joint {other}: each must have exactly one value, and joint {other} must not \
                mimic another";
        /// The memory has fewer steps than there are joints, or there are 2²⁸ joints or more.
        Steps {
            steps: usize = "The number of steps.",
            joints: usize = "The number of joints."
        }
            => "{joints} joints need {joints} steps, but there are {steps}";
    }
}
