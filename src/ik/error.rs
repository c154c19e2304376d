use core::fmt;

/// Joints that make no arm.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ArmError {
    /// The screw of a joint neither turns by 1 nor slides by 1.
    Screw {
        /// The joint.
        joint: usize,
        /// The length of the angular part.
        angular: f64,
        /// The length of the linear part.
        linear: f64,
    },
    /// The limits of a joint are not in order; or it slides and they are infinite; or they are angles
    /// beyond what a float tells.
    Limits {
        /// The joint.
        joint: usize,
        /// The lower limit.
        low: f64,
        /// The upper limit.
        high: f64,
    },
    /// The pose of the end at zero is not unit.
    Home {
        /// The norm of its real part.
        norm: f64,
    },
}

impl fmt::Display for ArmError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Screw { joint, angular, linear } => write!(
                f,
                "the screw of joint {joint} has an angular part of length {angular} and a linear part \
                 of length {linear}; one of length 1 is needed, the angular one unless it is zero"
            ),
            Self::Limits { joint, low, high } => write!(
                f,
                "joint {joint} cannot move between {low} and {high}: limits must be in order, \
                 finite for what slides, and angles that a float tells apart"
            ),
            Self::Home { norm } => {
                write!(f, "the pose at zero is not unit: the norm of the real part is {norm}")
            }
        }
    }
}

/// What [`TwoBone`](crate::ik::TwoBone) cannot bend.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum LimbError {
    /// A bone of negative or infinite length, or NaN.
    Length {
        /// The bone, 0 for the one at the root.
        bone: usize,
        /// Its length.
        value: f64,
    },
    /// A coordinate that is not finite.
    NotFinite {
        /// Of what.
        what: &'static str,
        /// The axis.
        index: usize,
        /// The coordinate.
        value: f64,
    },
}

impl fmt::Display for LimbError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { bone, value } => write!(f, "bone {bone} cannot have the length {value}"),
            Self::NotFinite { what, index, value } => {
                write!(f, "the {what} is not finite: coordinate {index} is {value}")
            }
        }
    }
}

impl core::error::Error for ArmError {}
impl core::error::Error for LimbError {}
