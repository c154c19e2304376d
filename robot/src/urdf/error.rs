use crate::MechanismError;
use dq8::internal::errors;
use std::fmt;

errors! {
    /// An error in a file that does not describe a robot, or describes a robot that a mechanism
    /// cannot express. Errors about the contents name the line and the element.
    #[derive(Debug)]
    UrdfError {
        /// The file cannot be read from disk.
        Read { path: String = "The path of the file.", source: std::io::Error = "The reason." } from source => "cannot read {path}: {source}";
        /// The text is in an encoding other than UTF-8 and UTF-16, and the feature
        /// `urdf-encodings`, which reads other encodings, is off.
        Encoding { encoding: String = "The encoding that the file declares." }
            => "the file declares the encoding {encoding:?}, which dq8-robot reads only with its feature urdf-encodings: switch it on, \
                or save the file as UTF-8";
        /// The text of the file is not XML.
        Parse { line: u32 = "The line, counted from one.", message: String = "The message of the XML parser." }
            => "not a URDF file: line {line}: {message}";
        /// The format allows no such element, attribute or text at this place.
        Unexpected {
            line: u32 = "The line on which the element begins.",
            element: String = "The element, or the one that holds the attribute or text.",
            what: String = "A phrase that says what is wrong with the element."
        }
            => "not a URDF file: line {line}: {element}: {what}";
        /// An element or attribute that the format asks for is missing.
        Missing {
            line: u32 = "The line on which the element begins.",
            element: String = "The element that should hold it.",
            what: String = "The name of the attribute or element that is missing."
        }
            => "not a URDF file: line {line}: {element}: {what} is missing";
        /// An attribute does not hold the required count of finite numbers, such as three for
        /// `xyz`.
        Numbers {
            line: u32 = "The line on which the element begins.",
            element: String = "The element.",
            attribute: &'static str = "The attribute.",
            wanted: usize = "The count of numbers that the attribute should hold.",
            text: String = "The text of the attribute."
        }
            => "not a URDF file: line {line}: {element}: {attribute} must be {}, but is {text:?}", match wanted {
                1 => "a finite number".to_owned(),
                _ => format!("{wanted} finite numbers"),
            };
        /// A revolute or prismatic joint has no `<limit>`.
        NoLimit { line: u32 = "The line on which the joint begins.", joint: String = "The joint." }
            => "not a URDF file: line {line}: <joint name={joint:?}>: a revolute or prismatic joint must have a <limit>";
        /// An element or attribute says where links are, but a mechanism cannot express it.
        NotExpressed { line: u32 = "The line on which the element begins.", what: String = "The element or attribute." }
            => "not supported: line {line}: {what}";
        /// Two links, or two joints, have the same name.
        Twice {
            line: u32 = "The line of the second.",
            element: &'static str = "`link` or `joint`.",
            name: String = "The name.",
            first: u32 = "The line of the first."
        }
            => "line {line}: two <{element}> have the name {name:?}; the first is on line {first}";
        /// A joint names a link or another joint that does not exist.
        Unknown {
            line: u32 = "The line of the joint that refers to it.",
            joint: String = "The joint.",
            element: &'static str = "`parent link`, `child link` or `mimic joint`.",
            name: String = "The name that it refers to."
        }
            => "line {line}: <joint name={joint:?}>: there is no {element} {name:?}";
        /// A link is the child of two joints.
        TwoParents {
            line: u32 = "The line on which the second of the joints names it.",
            link: String = "The link.",
            joint: String = "The second of the joints.",
            first: String = "The first of them."
        }
            => "line {line}: <joint name={joint:?}>: its child link {link:?} is already the child of <joint name={first:?}>";
        /// A tree has exactly one root, a link that is the child of no joint, but the file has none
        /// or several.
        Roots {
            line: u32 = "The line of the second of them; of `<robot>` if there is no link.",
            links: Vec<String> = "The names of the roots."
        }
            => "line {line}: {}", match links.as_slice() {
                [] => "<robot> has no <link>".to_owned(),
                _ => format!("more than one <link> is the child of no joint: {links:?}"),
            };
        /// The joints that carry a link form a circle.
        Circle { line: u32 = "The line of the link.", link: String = "The link." }
            => "line {line}: <link name={link:?}>: the joints above it form a circle";
        /// The length of an axis is zero or not finite, so the axis has no direction.
        Axis { line: u32 = "The line of the axis.", joint: String = "The joint.", axis: [f64; 3] = "The axis." }
            => "line {line}: <joint name={joint:?}>: the axis {axis:?} has no direction: its length must be positive and finite";
        /// Joints mimic each other in a circle, or the mimicking or the followed joint does not
        /// have exactly one value.
        Mimic { line: u32 = "The line of `<mimic>`.", joint: String = "The joint.", other: String = "The joint that it should mimic." }
            => "line {line}: <joint name={joint:?}> cannot mimic {other:?}: each must have exactly one value, and no joint may mimic \
                itself through others";
        /// The joints do not form a valid mechanism.
        Mechanism {
            line: u32 = "The line of the joint.",
            joint: String = "The joint, or the root.",
            source: MechanismError = "The reason, in which the number of the joint is that of its link."
        } from source
            => "line {line}: <joint name={joint:?}>: {source}";
    }
}

/// A warning about a part of a file that is not read, because it does not say where links are; or
/// about limits of a joint that mimics another, if they narrow the range of the followed joint or
/// are ignored.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct UrdfWarning {
    /// The line on which the element begins, counted from one.
    pub line: u32,
    /// The element that is not read, or the element that holds the attribute or text that is not
    /// read.
    pub element: String,
    /// The text of the warning.
    pub text: String,
}

impl fmt::Display for UrdfWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, element, text } = self;
        write!(f, "line {line}: {element}: {text}")
    }
}
