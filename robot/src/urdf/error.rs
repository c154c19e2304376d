use crate::MechanismError;
use std::error::Error;
use std::fmt;

/// A file that does not describe a robot, or describes one that a mechanism cannot express. Each names the line and the
/// element.
#[derive(Debug)]
#[non_exhaustive]
pub enum UrdfError {
    /// The file cannot be read.
    Read {
        /// Its name.
        path: String,
        /// Why.
        source: std::io::Error,
    },
    /// The text is not XML.
    Parse {
        /// The line, counted from one.
        line: u32,
        /// What the reader of XML says.
        message: String,
    },
    /// An element, an attribute or text that the format does not have there.
    Unexpected {
        /// The line on which the element begins.
        line: u32,
        /// The element, or the one that holds the attribute or text.
        element: String,
        /// What is wrong with it.
        what: String,
    },
    /// An element or attribute that the format asks for.
    Missing {
        /// The line on which the element begins.
        line: u32,
        /// The element that should hold it.
        element: String,
        /// What is missing.
        what: String,
    },
    /// An attribute that is not so many numbers.
    Numbers {
        /// The line on which the element begins.
        line: u32,
        /// The element.
        element: String,
        /// The attribute.
        attribute: &'static str,
        /// How many numbers it should hold.
        wanted: usize,
        /// What it holds.
        text: String,
    },
    /// A revolute or prismatic joint without `<limit>`.
    NoLimit {
        /// The line on which the joint begins.
        line: u32,
        /// The joint.
        joint: String,
    },
    /// Something that says where links are and that a mechanism cannot express.
    NotExpressed {
        /// The line on which the element begins.
        line: u32,
        /// The element or attribute.
        what: String,
    },
    /// Two links, or two joints, have one name.
    Twice {
        /// The line of the second.
        line: u32,
        /// `link` or `joint`.
        element: &'static str,
        /// The name.
        name: String,
        /// The line of the first.
        first: u32,
    },
    /// A joint names a link or another joint that there is not.
    Unknown {
        /// The line of what names it.
        line: u32,
        /// The joint.
        joint: String,
        /// `parent link`, `child link` or `mimic joint`.
        element: &'static str,
        /// What it names.
        name: String,
    },
    /// A link is the child of two joints.
    TwoParents {
        /// The line on which the second of the joints names it.
        line: u32,
        /// The link.
        link: String,
        /// The second of the joints.
        joint: String,
        /// The first of them.
        first: String,
    },
    /// Not exactly one link is the child of no joint.
    Roots {
        /// The line of the second of them; of `<robot>` if there is no link.
        line: u32,
        /// The names of those that are.
        links: Vec<String>,
    },
    /// A link that hangs on itself, by way of others.
    Circle {
        /// The line of the link.
        line: u32,
        /// The link.
        link: String,
    },
    /// An axis without a direction.
    Axis {
        /// The line of the axis.
        line: u32,
        /// The joint.
        joint: String,
        /// The axis.
        axis: [f64; 3],
    },
    /// Limits that are not in order.
    Limits {
        /// The line of the limits.
        line: u32,
        /// The joint.
        joint: String,
        /// The lower and the upper one.
        limits: [f64; 2],
    },
    /// Joints that mimic each other in a circle, or a joint that has not one value.
    Mimic {
        /// The line of `<mimic>`.
        line: u32,
        /// The joint.
        joint: String,
        /// What it should mimic.
        other: String,
    },
    /// What a mechanism refuses.
    Mechanism {
        /// The line of the joint.
        line: u32,
        /// The joint, or the root.
        joint: String,
        /// Why. Its own number of the joint is that of the link.
        source: MechanismError,
    },
}

impl fmt::Display for UrdfError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read { path, source } => write!(f, "cannot read {path}: {source}"),
            Self::Parse { line, message } => write!(f, "not a URDF file: line {line}: {message}"),
            Self::Unexpected { line, element, what } => {
                write!(f, "not a URDF file: line {line}: {element}: {what}")
            }
            Self::Missing { line, element, what } => {
                write!(f, "not a URDF file: line {line}: {element}: {what} is missing")
            }
            Self::Numbers { line, element, attribute, wanted, text } => write!(
                f,
                "not a URDF file: line {line}: {element}: {attribute}={text:?} where {wanted} numbers must be"
            ),
            Self::NoLimit { line, joint } => write!(
                f,
                "not a URDF file: line {line}: <joint name={joint:?}>: a revolute or prismatic joint must have a <limit>"
            ),
            Self::NotExpressed { line, what } => {
                write!(f, "cannot be expressed: line {line}: {what}")
            }
            Self::Twice { line, element, name, first } => write!(
                f,
                "line {line}: two <{element}> have the name {name:?}, the first is on line {first}"
            ),
            Self::Unknown { line, joint, element, name } => {
                write!(f, "line {line}: <joint name={joint:?}>: there is no {element} {name:?}")
            }
            Self::TwoParents { line, link, joint, first } => write!(
                f,
                "line {line}: <joint name={joint:?}>: its child link {link:?} has a parent already, by \
                 <joint name={first:?}>"
            ),
            Self::Roots { line, links } if links.is_empty() => {
                write!(f, "line {line}: <robot> has no <link>")
            }
            Self::Roots { line, links } => {
                write!(f, "line {line}: more than one <link> is a root: {links:?}")
            }
            Self::Circle { line, link } => {
                write!(f, "line {line}: <link name={link:?}> hangs on itself")
            }
            Self::Axis { line, joint, axis } => {
                write!(f, "line {line}: <joint name={joint:?}>: the axis {axis:?} has no direction")
            }
            Self::Limits { line, joint, limits: [lower, upper] } => write!(
                f,
                "line {line}: <joint name={joint:?}>: the lower limit {lower} is above the upper limit {upper}"
            ),
            Self::Mimic { line, joint, other } => write!(
                f,
                "line {line}: <joint name={joint:?}> cannot mimic {other:?}: both must have one value, and no circle"
            ),
            Self::Mechanism { line, joint, source } => {
                write!(f, "line {line}: <joint name={joint:?}>: {source}")
            }
        }
    }
}

impl Error for UrdfError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Read { source, .. } => Some(source),
            Self::Mechanism { source, .. } => Some(source),
            _ => None,
        }
    }
}
