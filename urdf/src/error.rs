use dq8::mechanism::MechanismError;
use std::error::Error;
use std::fmt;

/// A file that does not describe a robot, or describes one that a mechanism cannot express. Each names the element.
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
        /// `link` or `joint`.
        element: &'static str,
        /// The name.
        name: String,
    },
    /// A joint names a link or another joint that there is not.
    Unknown {
        /// The joint.
        joint: String,
        /// `parent link`, `child link` or `mimic joint`.
        element: &'static str,
        /// What it names.
        name: String,
    },
    /// A link is the child of two joints.
    TwoParents {
        /// The link.
        link: String,
        /// The second of the joints.
        joint: String,
    },
    /// Not exactly one link is the child of no joint.
    Roots {
        /// The names of those that are.
        links: Vec<String>,
    },
    /// A link that hangs on itself, by way of others.
    Circle {
        /// The link.
        link: String,
    },
    /// An axis without a direction.
    Axis {
        /// The joint.
        joint: String,
        /// The axis.
        axis: [f64; 3],
    },
    /// Joints that mimic each other in a circle, or a joint that has not one value.
    Mimic {
        /// The joint.
        joint: String,
        /// What it should mimic.
        other: String,
    },
    /// What a mechanism refuses.
    Mechanism {
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
            Self::Twice { element, name } => write!(f, "two <{element}> have the name {name:?}"),
            Self::Unknown { joint, element, name } => {
                write!(f, "<joint name={joint:?}>: there is no {element} {name:?}")
            }
            Self::TwoParents { link, joint } => {
                write!(f, "<joint name={joint:?}>: its child link {link:?} has a parent already")
            }
            Self::Roots { links } if links.is_empty() => {
                write!(f, "no <link> is the root: every one is the child of a joint")
            }
            Self::Roots { links } => write!(f, "more than one <link> is a root: {links:?}"),
            Self::Circle { link } => write!(f, "<link name={link:?}> hangs on itself"),
            Self::Axis { joint, axis } => {
                write!(f, "<joint name={joint:?}>: the axis {axis:?} has no direction")
            }
            Self::Mimic { joint, other } => write!(
                f,
                "<joint name={joint:?}> cannot mimic {other:?}: both must have one value, and no circle"
            ),
            Self::Mechanism { joint, source } => write!(f, "<joint name={joint:?}>: {source}"),
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
