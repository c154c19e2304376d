use core::fmt;

/// Joints that make no mechanism. All name the joint.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum MechanismError {
    /// A joint whose parent does not come before it: itself, a later one (which a circle needs), or none
    /// that there is.
    Parent {
        /// The joint.
        joint: usize,
        /// Its parent.
        parent: usize,
    },
    /// A placement whose rotation is not unit.
    Placement {
        /// The joint.
        joint: usize,
        /// The norm of the real part.
        norm: f64,
    },
    /// A placement whose dual part is not a translation's.
    DualPart {
        /// The joint.
        joint: usize,
        /// How much of the dual part lies along the real part, where a motion has none.
        along: f64,
    },
    /// A number that is infinite or NaN.
    NotFinite {
        /// The joint.
        joint: usize,
        /// What the number belongs to.
        what: &'static str,
        /// The number.
        value: f64,
    },
    /// An axis or normal that is not of length 1.
    Axis {
        /// The joint.
        joint: usize,
        /// The length.
        length: f64,
    },
    /// A screw that is none of a joint, whose angle is 1 and slide finite, or whose angle is 0 and slide 1.
    Screw {
        /// The joint.
        joint: usize,
        /// The angle of the screw.
        angle: f64,
        /// Its slide.
        slide: f64,
    },
    /// Limits that are not in order, or NaN, or of a joint that has not one value.
    Limits {
        /// The joint.
        joint: usize,
        /// The lower limit.
        low: f64,
        /// The upper limit.
        high: f64,
    },
    /// A joint that cannot mimic that one: there is none, it is the joint itself or mimics too, or one of
    /// the two has not exactly one value.
    Mimic {
        /// The joint.
        joint: usize,
        /// The joint that it should mimic.
        other: usize,
    },
    /// Too little room for the steps, or more joints than can be counted.
    Steps {
        /// How many steps there is room for.
        steps: usize,
        /// How many joints there are: joint number `joints` has no room.
        joints: usize,
    },
}

impl fmt::Display for MechanismError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parent { joint, parent } => {
                write!(f, "the parent of joint {joint} is {parent}, which does not come before it")
            }
            Self::Placement { joint, norm } => write!(
                f,
                "the placement of joint {joint} is not unit: the norm of the real part is {norm}"
            ),
            Self::DualPart { joint, along } => write!(
                f,
                "the placement of joint {joint} is not a motion: {along} of its dual part lies along the \
                 real part"
            ),
            Self::NotFinite { joint, what, value } => {
                write!(f, "the {what} of joint {joint} is not finite: {value}")
            }
            Self::Axis { joint, length } => {
                write!(f, "the axis of joint {joint} has length {length}, not 1")
            }
            Self::Screw { joint, angle, slide } => write!(
                f,
                "joint {joint} cannot turn by {angle} and slide by {slide} for a value of 1: a hinge or a thread \
                 turns by 1, and what only slides, by 1"
            ),
            Self::Limits { joint, low, high } => write!(
                f,
                "joint {joint} cannot have the limits {low} and {high}: they must be in order, and the \
                 joint must have one value"
            ),
            Self::Mimic { joint, other } => write!(
                f,
                "joint {joint} cannot mimic joint {other}: both must have one value, and the other one \
                 of its own"
            ),
            Self::Steps { steps, joints } => {
                write!(f, "there is room for {steps} steps where {joints} joints need one each")
            }
        }
    }
}

impl core::error::Error for MechanismError {}
