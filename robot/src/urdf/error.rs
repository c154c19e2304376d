use crate::MechanismError;
use dq8::internal::errors;
use std::fmt;

errors! {
    /// A file that does not describe a robot, or describes one that a mechanism cannot express.
    /// Each names the line and the element.
    #[derive(Debug)]
    UrdfError {
        /// The file cannot be read.
        Read { path: String = "Its name.", source: std::io::Error = "Why." } from source => "cannot read {path}: {source}";
        /// The text is in an encoding other than UTF-8 and UTF-16, which only the feature
        /// `urdf-encodings` reads.
        Encoding { encoding: String = "What the file declares." }
            => "the file is in the encoding {encoding:?}, which dq8-robot reads with its feature urdf-encodings; save it as UTF-8, or \
                switch that on";
        /// The text is not XML.
        Parse { line: u32 = "The line, counted from one.", message: String = "What the reader of XML says." }
            => "not a URDF file: line {line}: {message}";
        /// An element, an attribute or text that the format does not have there.
        Unexpected {
            line: u32 = "The line on which the element begins.",
            element: String = "The element, or the one that holds the attribute or text.",
            what: String = "What is wrong with it."
        }
            => "not a URDF file: line {line}: {element}: {what}";
        /// An element or attribute that the format asks for.
        Missing {
            line: u32 = "The line on which the element begins.",
            element: String = "The element that should hold it.",
            what: String = "What is missing."
        }
            => "not a URDF file: line {line}: {element}: {what} is missing";
        /// An attribute that is not so many numbers.
        Numbers {
            line: u32 = "The line on which the element begins.",
            element: String = "The element.",
            attribute: &'static str = "The attribute.",
            wanted: usize = "How many numbers it should hold.",
            text: String = "What it holds."
        }
            => "not a URDF file: line {line}: {element}: {attribute}={text:?} where {wanted} numbers must be";
        /// A revolute or prismatic joint without `<limit>`.
        NoLimit { line: u32 = "The line on which the joint begins.", joint: String = "The joint." }
            => "not a URDF file: line {line}: <joint name={joint:?}>: a revolute or prismatic joint must have a <limit>";
        /// Something that says where links are and that a mechanism cannot express.
        NotExpressed { line: u32 = "The line on which the element begins.", what: String = "The element or attribute." }
            => "cannot be expressed: line {line}: {what}";
        /// Two links, or two joints, have one name.
        Twice {
            line: u32 = "The line of the second.",
            element: &'static str = "`link` or `joint`.",
            name: String = "The name.",
            first: u32 = "The line of the first."
        }
            => "line {line}: two <{element}> have the name {name:?}, the first is on line {first}";
        /// A joint names a link or another joint that there is not.
        Unknown {
            line: u32 = "The line of what names it.",
            joint: String = "The joint.",
            element: &'static str = "`parent link`, `child link` or `mimic joint`.",
            name: String = "What it names."
        }
            => "line {line}: <joint name={joint:?}>: there is no {element} {name:?}";
        /// A link is the child of two joints.
        TwoParents {
            line: u32 = "The line on which the second of the joints names it.",
            link: String = "The link.",
            joint: String = "The second of the joints.",
            first: String = "The first of them."
        }
            => "line {line}: <joint name={joint:?}>: its child link {link:?} has a parent already, by <joint name={first:?}>";
        /// Not exactly one link is the child of no joint.
        Roots {
            line: u32 = "The line of the second of them; of `<robot>` if there is no link.",
            links: Vec<String> = "The names of those that are."
        }
            => "line {line}: {}", match links.as_slice() {
                [] => "<robot> has no <link>".to_owned(),
                _ => format!("more than one <link> is a root: {links:?}"),
            };
        /// A link that hangs on itself, by way of others.
        Circle { line: u32 = "The line of the link.", link: String = "The link." }
            => "line {line}: <link name={link:?}> hangs on itself";
        /// An axis without a direction.
        Axis { line: u32 = "The line of the axis.", joint: String = "The joint.", axis: [f64; 3] = "The axis." }
            => "line {line}: <joint name={joint:?}>: the axis {axis:?} has no direction";
        /// Joints that mimic each other in a circle, or a joint that has not one value.
        Mimic { line: u32 = "The line of `<mimic>`.", joint: String = "The joint.", other: String = "What it should mimic." }
            => "line {line}: <joint name={joint:?}> cannot mimic {other:?}: both must have one value, and no circle";
        /// What a mechanism refuses.
        Mechanism {
            line: u32 = "The line of the joint.",
            joint: String = "The joint, or the root.",
            source: MechanismError = "Why. Its own number of the joint is that of the link."
        } from source
            => "line {line}: <joint name={joint:?}>: {source}";
    }
}

/// Something in a file that is not read, because it says nothing about where links are; or limits
/// of a joint that mimics another, where they narrow the range of that one.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct UrdfWarning {
    /// The line on which the element begins, counted from one.
    pub line: u32,
    /// The element that is not read, or the one that holds the attribute or text.
    pub element: String,
    /// What is not read.
    pub text: String,
}

impl fmt::Display for UrdfWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, element, text } = self;
        write!(f, "line {line}: {element}: {text}")
    }
}
