//! What a file says about where links are, with what it leaves out.

use crate::element::Element;
use crate::error::UrdfError;
use roxmltree::{Document, Node};

/// `<robot>`.
#[derive(Debug)]
pub(crate) struct File {
    pub(crate) name: String,
    /// The names of the links.
    pub(crate) links: Vec<String>,
    pub(crate) joints: Vec<JointElement>,
}

/// `<joint>`.
#[derive(Debug)]
pub(crate) struct JointElement {
    pub(crate) name: String,
    pub(crate) kind: Kind,
    pub(crate) parent: String,
    pub(crate) child: String,
    pub(crate) xyz: [f64; 3],
    pub(crate) rpy: [f64; 3],
    /// Of any length; x where there is none.
    pub(crate) axis: [f64; 3],
    /// Of a revolute or prismatic joint, which must have some.
    pub(crate) limits: Option<[f64; 2]>,
    pub(crate) mimic: Option<MimicElement>,
}

/// The type of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    Fixed,
    Revolute,
    Continuous,
    Prismatic,
    Planar,
    Floating,
}

/// `<mimic>`.
#[derive(Debug)]
pub(crate) struct MimicElement {
    pub(crate) joint: String,
    pub(crate) multiplier: f64,
    pub(crate) offset: f64,
}

impl File {
    pub(crate) fn read(text: &str) -> Result<Self, UrdfError> {
        let document = Document::parse(text).map_err(|error| match error {
            roxmltree::Error::UnknownNamespace(prefix, at) if prefix == "xacro" => xacro(at.row),
            error => UrdfError::Parse { line: error.pos().row, message: error.to_string() },
        })?;
        let of_xacro = |node: &Node<'_, '_>| {
            node.tag_name().namespace().is_some_and(|namespace| namespace.contains("xacro"))
        };
        if let Some(node) = document.descendants().find(of_xacro) {
            return Err(xacro(Element(node).line()));
        }
        let robot = Element(document.root_element());
        if robot.name() != "robot" {
            return Err(robot.unexpected("the outermost element must be <robot>"));
        }
        let unsaid = unsaid(robot)?;
        let (mut links, mut joints) = (Vec::new(), Vec::new());
        for element in robot.children(&["link", "joint"])? {
            if element.name() == "link" {
                element.children(&[]).map(drop)?;
                links.push(element.text("name")?.to_owned());
            } else {
                joints.push(JointElement::read(element, unsaid)?);
            }
        }
        let name = robot.0.attribute("name").unwrap_or_default().to_owned();
        Ok(Self { name, links, joints })
    }
}

fn xacro(line: u32) -> UrdfError {
    UrdfError::NotExpressed { line, what: "an element of xacro: expand the file first".into() }
}

/// The limits of a `<limit>` that does not say them: nothing but zero, and since version 1.2 everything.
fn unsaid(robot: Element<'_>) -> Result<[f64; 2], UrdfError> {
    match robot.0.attribute("version").map(str::trim) {
        None | Some("1.0" | "1.1") => Ok([0.0; 2]),
        Some("1.2") => Ok([f64::NEG_INFINITY, f64::INFINITY]),
        Some(version) => {
            let what = format!("version {version:?} of the format");
            Err(UrdfError::NotExpressed { line: robot.line(), what })
        }
    }
}

impl JointElement {
    fn read(joint: Element<'_>, unsaid: [f64; 2]) -> Result<Self, UrdfError> {
        let elements = ["origin", "parent", "child", "axis", "limit", "mimic"];
        joint.only(&["name", "type"], &elements)?;
        let name = joint.text("name")?.to_owned();
        let kind = kind(joint)?;
        let of_link = |element: &str| -> Result<String, UrdfError> {
            let link = joint.needed_child(element)?;
            link.only(&["link"], &[])?;
            Ok(link.text("link")?.to_owned())
        };
        let (parent, child) = (of_link("parent")?, of_link("child")?);
        let [xyz, rpy] = match joint.child("origin")? {
            None => [[0.0; 3]; 2],
            Some(origin) => placement(origin)?,
        };
        let axis = match joint.child("axis")? {
            None => [1.0, 0.0, 0.0],
            Some(axis) => direction(axis, kind)?,
        };
        let limits = limits(joint, kind, unsaid)?;
        let mimic = joint.child("mimic")?.map(MimicElement::read).transpose()?;
        Ok(Self { name, kind, parent, child, xyz, rpy, axis, limits, mimic })
    }
}

fn kind(joint: Element<'_>) -> Result<Kind, UrdfError> {
    Ok(match joint.text("type")? {
        "fixed" => Kind::Fixed,
        "revolute" => Kind::Revolute,
        "continuous" => Kind::Continuous,
        "prismatic" => Kind::Prismatic,
        "planar" => Kind::Planar,
        "floating" => Kind::Floating,
        "spherical" => {
            let what = format!("{} of type \"spherical\"", joint.title());
            return Err(UrdfError::NotExpressed { line: joint.line(), what });
        }
        other => return Err(joint.unexpected(format!("the type {other:?} is unknown"))),
    })
}

fn placement(origin: Element<'_>) -> Result<[[f64; 3]; 2], UrdfError> {
    if origin.0.has_attribute("quat_xyzw") {
        let what = format!("the attribute quat_xyzw in {}: write rpy", origin.title());
        return Err(UrdfError::NotExpressed { line: origin.line(), what });
    }
    origin.only(&["xyz", "rpy"], &[])?;
    let vector = |name| Ok(origin.numbers(name)?.unwrap_or_default());
    Ok([vector("xyz")?, vector("rpy")?])
}

fn direction(axis: Element<'_>, kind: Kind) -> Result<[f64; 3], UrdfError> {
    axis.only(&["xyz"], &[])?;
    axis.text("xyz")?;
    // Joints without an axis have one in many files, of zeros too.
    let unused = matches!(kind, Kind::Fixed | Kind::Floating);
    if unused { Ok([0.0; 3]) } else { Ok(axis.numbers("xyz")?.unwrap_or_default()) }
}

/// The attributes of `<limit>`; all but two are about speeds and forces.
const LIMIT: [&str; 7] =
    ["lower", "upper", "effort", "velocity", "acceleration", "deceleration", "jerk"];

/// What the format says of `<limit>`: revolute and prismatic joints must have it, others have no use for `lower` and
/// `upper`, and either is zero where it is not written.
fn limits(
    joint: Element<'_>,
    kind: Kind,
    [least, most]: [f64; 2],
) -> Result<Option<[f64; 2]>, UrdfError> {
    let limited = matches!(kind, Kind::Revolute | Kind::Prismatic);
    let Some(limit) = joint.child("limit")? else {
        let (line, name) = (joint.line(), joint.text("name")?.to_owned());
        return if limited { Err(UrdfError::NoLimit { line, joint: name }) } else { Ok(None) };
    };
    limit.only(&LIMIT, &[])?;
    if !limited {
        return Ok(None);
    }
    let lower = limit.number("lower")?.unwrap_or(least);
    let upper = limit.number("upper")?.unwrap_or(most);
    let endless = lower == f64::NEG_INFINITY && upper == f64::INFINITY;
    Ok((!endless).then_some([lower, upper]))
}

impl MimicElement {
    fn read(mimic: Element<'_>) -> Result<Self, UrdfError> {
        mimic.only(&["joint", "multiplier", "offset"], &[])?;
        Ok(Self {
            joint: mimic.text("joint")?.to_owned(),
            multiplier: mimic.number("multiplier")?.unwrap_or(1.0),
            offset: mimic.number("offset")?.unwrap_or(0.0),
        })
    }
}
