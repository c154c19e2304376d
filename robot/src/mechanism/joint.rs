//! Joints as the caller describes them, and the errors in them.

use dq8::Real;
use dq8::internal::errors;
use dq8::scalar::DualQuat;

/// The joint of a link: how it moves on the link that carries it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint<R> {
    /// The number of the link that carries this one, which must be lower; `None` for the base.
    pub parent: Option<usize>,
    /// The pose of the joint in the frame of the parent, which is the pose of the link while the
    /// joint is at zero. It must be unit to 10⁻³, and is made unit exactly.
    pub placement: DualQuat<R>,
    /// The kind of motion.
    pub kind: JointKind<R>,
    /// The least and the largest value, for a joint with one value. Inverse kinematics keeps to
    /// them ([`Reach`](crate::Reach)); poses are computed for any values.
    pub limits: Option<[R; 2]>,
    /// The joint whose value this one takes, if it has none of its own.
    pub mimic: Option<Mimic<R>>,
}

/// The motion of a joint, in its own frame. Axes must have length 1 to 10⁻³, and are made unit
/// exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum JointKind<R> {
    /// Does not move. No value.
    Fixed,
    /// Turns about `axis`, through the origin of its frame. One value, radians; without limits this
    /// is a continuous joint.
    Revolute {
        /// The axis.
        axis: [R; 3],
    },
    /// Slides along `axis`. One value, a length.
    Prismatic {
        /// The axis.
        axis: [R; 3],
    },
    /// Turns about `axis` and slides along it, `pitch` for each radian. One value, radians.
    Screw {
        /// The axis.
        axis: [R; 3],
        /// Length per radian: the lead of a thread over 2π.
        pitch: R,
    },
    /// Slides in the plane perpendicular to `normal`, then turns about the normal. Three values: x
    /// and y, lengths, and the angle, radians. The axes of x and y are those of the joint's frame
    /// after the shortest rotation that takes z to the normal (for −z, half a turn about x).
    /// Three rates, ẋ, ẏ, θ̇.
    Planar {
        /// The normal.
        normal: [R; 3],
    },
    /// Moves freely. Seven values, `[x, y, z, w, tx, ty, tz]`: a rotation of any length but zero,
    /// which is normalized, and the translation. Six rates: the body twist
    /// `[ωx, ωy, ωz, vx, vy, vz]`, in the frame of the link.
    Floating,
}

/// The rule of a joint that follows another: its value is `multiplier` · value(`joint`) +
/// `offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mimic<R> {
    /// The number of the other joint, which has one value and mimics none.
    pub joint: usize,
    /// The factor of its value.
    pub multiplier: R,
    /// The number that is added.
    pub offset: R,
}

impl<R> Joint<R> {
    /// A joint of any kind, without limits.
    #[must_use]
    pub fn new(parent: Option<usize>, placement: DualQuat<R>, kind: JointKind<R>) -> Self {
        Self { parent, placement, kind, limits: None, mimic: None }
    }

    /// A link that stands still on its parent.
    #[must_use]
    pub fn fixed(parent: Option<usize>, placement: DualQuat<R>) -> Self {
        Self::new(parent, placement, JointKind::Fixed)
    }

    /// A hinge about `axis`, of length 1.
    #[must_use]
    pub fn revolute(parent: Option<usize>, placement: DualQuat<R>, axis: [R; 3]) -> Self {
        Self::new(parent, placement, JointKind::Revolute { axis })
    }

    /// A slide along `axis`, of length 1.
    #[must_use]
    pub fn prismatic(parent: Option<usize>, placement: DualQuat<R>, axis: [R; 3]) -> Self {
        Self::new(parent, placement, JointKind::Prismatic { axis })
    }

    /// A thread about `axis`, of length 1, that goes `pitch` along it for each radian.
    #[must_use]
    pub fn screw(parent: Option<usize>, placement: DualQuat<R>, axis: [R; 3], pitch: R) -> Self {
        Self::new(parent, placement, JointKind::Screw { axis, pitch })
    }

    /// A plate that slides in the plane perpendicular to `normal`, of length 1, and turns about it.
    #[must_use]
    pub fn planar(parent: Option<usize>, placement: DualQuat<R>, normal: [R; 3]) -> Self {
        Self::new(parent, placement, JointKind::Planar { normal })
    }

    /// A body that moves freely: a humanoid's pelvis, a drone.
    #[must_use]
    pub fn floating(parent: Option<usize>, placement: DualQuat<R>) -> Self {
        Self::new(parent, placement, JointKind::Floating)
    }

    /// The same joint with limits.
    #[must_use]
    pub fn with_limits(self, limits: [R; 2]) -> Self {
        Self { limits: Some(limits), ..self }
    }

    /// The same joint, which takes its value from another one.
    #[must_use]
    pub fn mimicking(self, joint: usize, multiplier: R, offset: R) -> Self {
        Self { mimic: Some(Mimic { joint, multiplier, offset }), ..self }
    }
}

impl<R: Real> Joint<R> {
    /// The same joint in other numbers, by way of `f64`.
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
    /// The number of values that say where the joint is.
    #[must_use]
    pub fn values(&self) -> usize {
        match self {
            Self::Fixed => 0,
            Self::Revolute { .. } | Self::Prismatic { .. } | Self::Screw { .. } => 1,
            Self::Planar { .. } => 3,
            Self::Floating => 7,
        }
    }

    /// The number of rates that say how the joint moves.
    #[must_use]
    pub fn rates(&self) -> usize {
        match self {
            Self::Floating => 6,
            other => other.values(),
        }
    }
}

errors! {
    /// An error in the joints of a mechanism. Each names the joint.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    MechanismError {
        /// The parent of a joint is the joint itself, a later one, or does not exist. Parents must
        /// come first, which also rules out circles.
        Parent { joint: usize = "The joint.", parent: usize = "Its parent." }
            => "joint {joint} has the parent {parent}, but a parent must have a lower number than its joint";
        /// The rotation of a placement is not unit.
        Placement { joint: usize = "The joint.", norm: f64 = "The norm of the real part." }
            => "the placement of joint {joint} is not a unit dual quaternion: the norm of its real part is {norm}, not 1";
        /// The dual part of a placement is not perpendicular to its real part, as that of a motion
        /// is.
        DualPart {
            joint: usize = "The joint.",
            along: f64 = "The dot product of its real and dual parts."
        }
            => "the placement of joint {joint} is not a motion: the dot product of its real and dual parts is {along}, not 0";
        /// A number is infinite or NaN.
        NotFinite {
            joint: usize = "The joint.", what: &'static str = "The part of the joint that holds it.", value: f64 = "The number."
        }
            => "the {what} of joint {joint} is not finite: {value}";
        /// An axis or a normal does not have length 1.
        Axis { joint: usize = "The joint.", length: f64 = "The length." }
            => "the axis of joint {joint} has length {length}, not 1";
        /// A screw is not that of a joint, which has angle 1 and a finite slide, or angle 0 and
        /// slide 1.
        Screw { joint: usize = "The joint.", angle: f64 = "The angle of the screw.", slide: f64 = "Its slide." }
            => "the screw of joint {joint} turns by {angle} and slides by {slide} for a value of 1: a hinge or a thread \
                must turn by 1, and a slide must turn by 0 and slide by 1";
        /// Limits are not in order, or NaN, or of a joint that does not have exactly one value.
        Limits { joint: usize = "The joint.", low: f64 = "The lower limit.", high: f64 = "The upper limit." }
            => "joint {joint} has the limits {low} and {high}: the first must not exceed the second, and the joint must \
                have exactly one value";
        /// A joint cannot mimic another, because that one does not exist, is the joint itself, or
        /// mimics too, or because one of the two does not have exactly one value.
        Mimic { joint: usize = "The joint.", other: usize = "The joint that it should mimic." }
            => "joint {joint} cannot mimic joint {other}: each must have exactly one value, and joint {other} must not \
                mimic another";
        /// There are fewer steps than joints, or more joints than can be counted.
        Steps {
            steps: usize = "The number of steps.",
            joints: usize = "The number of joints."
        }
            => "{joints} joints need {joints} steps, but there are {steps}";
    }
}
