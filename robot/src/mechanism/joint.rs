use dq8::Real;
use dq8::internal::errors;
use dq8::scalar::DualQuat;

/// How a link is joined to the one that carries it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint<R> {
    /// The link that carries this one, by the number of its joint; `None` is the base. Parents come
    /// first.
    pub parent: Option<usize>,
    /// Where the frame of the joint is in that of the parent: the pose of the link where the joint
    /// is at zero. Unit to 10⁻³, and made so exactly.
    pub placement: DualQuat<R>,
    /// How the joint moves.
    pub kind: JointKind<R>,
    /// The least and the largest value of a joint of one value. Inverse kinematics keeps to them
    /// ([`Reach`](crate::Reach)); poses are computed of any values.
    pub limits: Option<[R; 2]>,
    /// For a joint without a value of its own: whose value it takes.
    pub mimic: Option<Mimic<R>>,
}

/// How a joint moves, in its own frame. Axes have length 1 to 10⁻³, and are made so exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum JointKind<R> {
    /// Not at all. No value.
    Fixed,
    /// HalfAngles about `axis`, through the origin of its frame. One value, radians; without limits this
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
    /// HalfAngles about `axis` and slides along it, `pitch` for each radian. One value, radians.
    Screw {
        /// The axis.
        axis: [R; 3],
        /// Length per radian: the lead of a thread over 2π.
        pitch: R,
    },
    /// Slides in the plane across `normal`, then turns about the normal. Three values: x and y,
    /// lengths, and the angle, radians. The axes of x and y are those of the joint's frame after
    /// the shortest rotation that takes z to the normal (for −z, half a turn about x). Three
    /// rates, ẋ, ẏ, θ̇.
    Planar {
        /// The normal.
        normal: [R; 3],
    },
    /// Moves freely. Seven values, `[x, y, z, w, tx, ty, tz]`: a rotation of any length but zero,
    /// which is normalized, and the translation. Six rates: the body twist
    /// `[ωx, ωy, ωz, vx, vy, vz]`, in the frame of the link.
    Floating,
}

/// A joint that does as another: its value is `multiplier` · value(`joint`) + `offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mimic<R> {
    /// The other joint, of one value and no mimic itself.
    pub joint: usize,
    /// What its value is multiplied by.
    pub multiplier: R,
    /// What is added.
    pub offset: R,
}

impl<R> Joint<R> {
    /// Of any kind, without limits.
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

    /// A plate that slides across `normal`, of length 1, and turns about it.
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

    /// The same joint without a value of its own.
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
    /// How many values it takes to say where the joint is.
    #[must_use]
    pub fn values(&self) -> usize {
        match self {
            Self::Fixed => 0,
            Self::Revolute { .. } | Self::Prismatic { .. } | Self::Screw { .. } => 1,
            Self::Planar { .. } => 3,
            Self::Floating => 7,
        }
    }

    /// How many rates it takes to say how the joint moves.
    #[must_use]
    pub fn rates(&self) -> usize {
        match self {
            Self::Floating => 6,
            other => other.values(),
        }
    }
}

errors! {
    /// Joints that make no mechanism. All name the joint.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    MechanismError {
        /// A joint whose parent does not come before it: itself, a later one (which a circle
        /// needs), or none that there is.
        Parent { joint: usize = "The joint.", parent: usize = "Its parent." }
            => "the parent of joint {joint} is {parent}, which does not come before it";
        /// A placement whose rotation is not unit.
        Placement { joint: usize = "The joint.", norm: f64 = "The norm of the real part." }
            => "the placement of joint {joint} is not unit: the norm of the real part is {norm}";
        /// A placement whose dual part is not a translation's.
        DualPart {
            joint: usize = "The joint.",
            along: f64 = "How much of the dual part lies along the real part, where a motion has none."
        }
            => "the placement of joint {joint} is not a motion: {along} of its dual part lies along the real part";
        /// A number that is infinite or NaN.
        NotFinite {
            joint: usize = "The joint.", what: &'static str = "What the number belongs to.", value: f64 = "The number."
        }
            => "the {what} of joint {joint} is not finite: {value}";
        /// An axis or normal that is not of length 1.
        Axis { joint: usize = "The joint.", length: f64 = "The length." }
            => "the axis of joint {joint} has length {length}, not 1";
        /// A screw that is none of a joint, whose angle is 1 and slide finite, or whose angle is 0
        /// and slide 1.
        Screw { joint: usize = "The joint.", angle: f64 = "The angle of the screw.", slide: f64 = "Its slide." }
            => "joint {joint} cannot turn by {angle} and slide by {slide} for a value of 1: a hinge or a thread turns by \
                1, and what only slides, by 1";
        /// Limits that are not in order, or NaN, or of a joint that has not one value.
        Limits { joint: usize = "The joint.", low: f64 = "The lower limit.", high: f64 = "The upper limit." }
            => "joint {joint} cannot have the limits {low} and {high}: they must be in order, and the joint must have \
                one value";
        /// A joint that cannot mimic that one: there is none, it is the joint itself or mimics too,
        /// or one of the two has not exactly one value.
        Mimic { joint: usize = "The joint.", other: usize = "The joint that it should mimic." }
            => "joint {joint} cannot mimic joint {other}: both must have one value, and the other one of its own";
        /// Too little room for the steps, or more joints than can be counted.
        Steps {
            steps: usize = "How many steps there is room for.",
            joints: usize = "How many joints there are: joint number `joints` has no room."
        }
            => "there is room for {steps} steps where {joints} joints need one each";
    }
}
