use core::fmt;
use dq8::ShapeError;

/// What cannot be asked of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ReachError {
    /// There is no goal.
    NoGoals,
    /// A goal for a link that there is not.
    Link {
        /// The goal.
        goal: usize,
        /// The link that it names.
        link: usize,
        /// How many links there are.
        links: usize,
    },
    /// A weight that is neither zero nor between 10⁻⁶ and 10⁶.
    Weight {
        /// The goal.
        goal: usize,
        /// The component: 0 to 2 of the rotation, 3 to 5 of the position.
        component: usize,
        /// The weight.
        value: f64,
    },
    /// A point of a goal that is not finite.
    Point {
        /// The goal.
        goal: usize,
        /// The component.
        component: usize,
        /// What it is.
        value: f64,
    },
    /// All weights of a goal are zero.
    NoWeight {
        /// The goal.
        goal: usize,
    },
    /// A goal for a link that nothing moves: only fixed joints carry it, and such that mimic others zero times.
    Unmoved {
        /// The goal.
        goal: usize,
        /// The link that it names.
        link: usize,
    },
    /// Too little room for the freedoms.
    Freedoms {
        /// How many there is room for.
        freedoms: usize,
        /// How many rates the mechanism has.
        rates: usize,
    },
    /// No value is within the limits of a joint and those of the joints that mimic it, or the limits are
    /// angles beyond what a float tells (2¹⁷ radians for `f32`, 2⁴⁶ for `f64`).
    Limits {
        /// The joint.
        joint: usize,
        /// The lower limit.
        low: f64,
        /// The upper limit.
        high: f64,
    },
    /// A posture of another length than a configuration.
    PostureLength {
        /// How many values it has.
        length: usize,
        /// How many a configuration has.
        expected: usize,
    },
    /// A value of a posture that is not finite.
    Posture {
        /// The value.
        index: usize,
        /// What it is.
        value: f64,
    },
}

impl fmt::Display for ReachError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoGoals => write!(f, "there is no goal"),
            Self::Link { goal, link, links } => {
                write!(f, "goal {goal} is for link {link}, and there are {links} links")
            }
            Self::Weight { goal, component, value } => write!(
                f,
                "component {component} of goal {goal} cannot weigh {value}: weights are zero, or from 1e-6 to 1e6"
            ),
            Self::Point { goal, component, value } => {
                write!(
                    f,
                    "component {component} of the point of goal {goal} is not finite: {value}"
                )
            }
            Self::NoWeight { goal } => write!(f, "all weights of goal {goal} are zero"),
            Self::Unmoved { goal, link } => {
                write!(f, "goal {goal} is for link {link}, and no joint that carries it moves")
            }
            Self::Freedoms { freedoms, rates } => {
                write!(f, "there is room for {freedoms} freedoms where {rates} rates need one each")
            }
            Self::Limits { joint, low, high } => write!(
                f,
                "joint {joint} cannot move between {low} and {high}: limits, also of what mimics it, must \
                 leave a value, and be angles that a float tells apart"
            ),
            Self::PostureLength { length, expected } => {
                write!(f, "the posture has {length} values where {expected} are needed")
            }
            Self::Posture { index, value } => {
                write!(f, "value {index} of the posture is not finite: {value}")
            }
        }
    }
}

impl core::error::Error for ReachError {}

/// What rates cannot be asked for.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum RatesError {
    /// Lengths that do not fit.
    Shape(ShapeError),
    /// A damping that is negative or not finite.
    Damping {
        /// What it is.
        value: f64,
    },
    /// A joint value that is not finite.
    Value {
        /// Which one.
        index: usize,
        /// What it is.
        value: f64,
    },
    /// A velocity that is not finite.
    Twist {
        /// Which one.
        index: usize,
        /// The number in it.
        value: f64,
    },
}

impl From<ShapeError> for RatesError {
    fn from(error: ShapeError) -> Self {
        Self::Shape(error)
    }
}

impl fmt::Display for RatesError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shape(error) => error.fmt(f),
            Self::Damping { value } => write!(f, "the damping is negative or not finite: {value}"),
            Self::Value { index, value } => write!(f, "value {index} is not finite: {value}"),
            Self::Twist { index, value } => write!(f, "twist {index} is not finite: {value}"),
        }
    }
}

impl core::error::Error for RatesError {}

/// What has no solutions to be asked for.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SolutionsError {
    /// Lengths that do not fit.
    Shape(ShapeError),
    /// More goals than one.
    Goals {
        /// How many there are.
        goals: usize,
    },
    /// A goal that leaves some of rotation and position free.
    NoPose,
    /// A joint that carries the link and is neither fixed nor a hinge with a value of its own.
    Joint {
        /// The joint.
        joint: usize,
    },
    /// More or fewer hinges than six that carry the link.
    Hinges {
        /// How many there are.
        hinges: usize,
    },
    /// A target with a number that is not finite.
    Target {
        /// The target.
        index: usize,
        /// The number in it.
        value: f64,
    },
    /// A target that is farther than 10⁻³ from a unit motion.
    NotUnit {
        /// The target.
        index: usize,
        /// The norm of its real part.
        norm: f64,
    },
    /// A value of a start that is not finite.
    Start {
        /// The start.
        index: usize,
        /// The hinge.
        hinge: usize,
        /// What it is.
        value: f64,
    },
}

impl From<ShapeError> for SolutionsError {
    fn from(error: ShapeError) -> Self {
        Self::Shape(error)
    }
}

impl fmt::Display for SolutionsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shape(error) => error.fmt(f),
            Self::Goals { goals } => {
                write!(f, "there are {goals} goals, and one link has solutions")
            }
            Self::NoPose => write!(f, "the goal leaves some of rotation and position free"),
            Self::Joint { joint } => {
                write!(f, "joint {joint} carries the link, and is no hinge with a value of its own")
            }
            Self::Hinges { hinges } => write!(f, "{hinges} hinges carry the link, not six"),
            Self::Target { index, value } => write!(f, "target {index} is not finite: {value}"),
            Self::NotUnit { index, norm } => {
                write!(
                    f,
                    "target {index} is not a unit motion: the norm of its real part is {norm}"
                )
            }
            Self::Start { index, hinge, value } => {
                write!(f, "value {hinge} of start {index} is not finite: {value}")
            }
        }
    }
}

impl core::error::Error for SolutionsError {}
