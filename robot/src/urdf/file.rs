//! The elements of a URDF file that say where links are, with defaults for parts that the file
//! leaves out.

use super::element::{AXIS, END, Element, JOINT, LIMIT, LINK, Lines, MIMIC, ORIGIN, ROBOT};
use super::error::{UrdfError, UrdfWarning};
use super::number;
use super::xml;
use crate::{Joint, JointKind};
use dq8::{DualQuat, Quat};
use roxmltree::Document;

/// The contents of `<robot>`, the root element of a file.
#[derive(Debug)]
pub(crate) struct File {
    pub(crate) name: String,
    /// The line on which the element begins, counted from one.
    pub(crate) line: u32,
    /// The names of the links, in the order of the file.
    pub(crate) links: Vec<Name>,
    pub(crate) joints: Vec<JointElement>,
    /// The warnings about parts that are not read, in the order of lines.
    pub(crate) warnings: Vec<UrdfWarning>,
}

/// The contents of a `<joint>`.
#[derive(Debug)]
pub(crate) struct JointElement {
    pub(crate) name: Name,
    /// The kind of the joint. Its axis has length 1; it is the x axis if the file does not give an
    /// axis.
    pub(crate) kind: JointKind<f64>,
    pub(crate) parent: Name,
    pub(crate) child: Name,
    pub(crate) xyz: [f64; 3],
    pub(crate) rpy: [f64; 3],
    /// The limits of the joint's value. Only revolute and prismatic joints have limits, and they
    /// must have them.
    pub(crate) limits: Option<[f64; 2]>,
    pub(crate) drive: Drive,
    pub(crate) mimic: Option<MimicElement>,
}

/// The contents of a `<mimic>`.
#[derive(Debug)]
pub(crate) struct MimicElement {
    pub(crate) joint: Name,
    pub(crate) multiplier: f64,
    pub(crate) offset: f64,
}

/// A name, and the line of the file on which it is written.
#[derive(Clone, Debug)]
pub(crate) struct Name {
    pub(crate) text: String,
    pub(crate) line: u32,
}

impl Name {
    fn of(element: Element<'_>, attribute: &str) -> Result<Self, UrdfError> {
        Ok(Self { text: element.text(attribute)?.to_owned(), line: element.line() })
    }
}

impl File {
    pub(crate) fn read(text: &str) -> Result<Self, UrdfError> {
        let text = xml::strict(text)?;
        let lines = Lines::of(&text);
        let document = Document::parse(&text).map_err(|error| UrdfError::Parse {
            line: error.pos().row,
            message: error.to_string(),
        })?;
        let robot = Element { node: document.root_element(), lines: &lines };
        if robot.name() != "robot" {
            return Err(robot.unexpected("the outermost element must be <robot>"));
        }
        let mut warnings = Vec::new();
        robot.check(&ROBOT, &mut warnings)?;
        let unsaid = unsaid(robot)?;
        let mut links = Vec::new();
        for link in robot.children("link") {
            link.check(&LINK, &mut warnings)?;
            links.push(Name::of(link, "name")?);
        }
        let joints = robot.children("joint");
        let joints = joints.map(|joint| JointElement::read(joint, unsaid, &mut warnings));
        let joints = joints.collect::<Result<_, _>>()?;
        let name = robot.node.attribute("name").unwrap_or_default().to_owned();
        warnings.sort_by_key(|warning| warning.line);
        Ok(Self { name, line: robot.line(), links, joints, warnings })
    }
}

/// Returns the defaults of `lower` and `upper` for a `<limit>` without these attributes. They are
/// zero, or, since version 1.2 of the format, infinite.
fn unsaid(robot: Element<'_>) -> Result<[f64; 2], UrdfError> {
    match robot.node.attribute("version").map(str::trim) {
        None | Some("1.0" | "1.1") => Ok([0.0; 2]),
        Some("1.2") => Ok([f64::NEG_INFINITY, f64::INFINITY]),
        Some(version) => {
            let what = format!("version {version:?} of the format");
            Err(UrdfError::NotExpressed { line: robot.line(), what })
        }
    }
}

impl JointElement {
    fn read(
        joint: Element<'_>,
        unsaid: [f64; 2],
        warnings: &mut Vec<UrdfWarning>,
    ) -> Result<Self, UrdfError> {
        joint.check(&JOINT, warnings)?;
        let name = Name::of(joint, "name")?;
        let (mut kind, has_limits) = kind(joint)?;
        let mut end = |element: &str| {
            let end = joint.needed_child(element)?;
            end.check(&END, warnings)?;
            Name::of(end, "link")
        };
        let (parent, child) = (end("parent")?, end("child")?);
        let [xyz, rpy] = match joint.child("origin") {
            None => [[0.0; 3]; 2],
            Some(origin) => placement(origin, warnings)?,
        };
        // In many files fixed and floating joints have an `<axis>` too, even an axis of zeros. So
        // `<axis>` is read only for kinds of joints that have an axis.
        if let JointKind::Revolute { axis: own }
        | JointKind::Prismatic { axis: own }
        | JointKind::Planar { normal: own } = &mut kind
        {
            *own = axis(joint, warnings)?;
        }
        let limits = if has_limits { limits(joint, unsaid, warnings)? } else { None };
        // Speed and effort do not say where links are, so a wrong value of them is never an error.
        let drive = joint.child("limit").map_or(Drive::FREE, Drive::of);
        let mut mimic = None;
        if let Some(element) = joint.child("mimic") {
            // People who lock a joint by changing its type to fixed leave its other elements as
            // they are, so a `<mimic>` here gives a warning and no error.
            if kind == JointKind::Fixed {
                warnings
                    .push(element.warning("a fixed joint mimics nothing, so <mimic> is not read"));
            } else {
                mimic = Some(MimicElement::read(element, warnings)?);
            }
        }
        Ok(Self { name, kind, parent, child, xyz, rpy, limits, drive, mimic })
    }

    /// Returns this joint as a joint of a mechanism, on the link with index `parent`. The rule of a
    /// joint that mimics another is not set here.
    pub(crate) fn joint(&self, parent: usize) -> Joint<f64> {
        let [roll, pitch, yaw] = self.rpy;
        let turn = Quat::from_rpy(roll, pitch, yaw);
        let placement = DualQuat::from_rotation_translation(turn, self.xyz);
        Joint { limits: self.limits, ..Joint::new(Some(parent), placement, self.kind) }
    }
}

/// Returns the kind of joint that the attribute `type` names, with x as its axis, and `true` if
/// such a joint must have limits.
fn kind(joint: Element<'_>) -> Result<(JointKind<f64>, bool), UrdfError> {
    let axis = [1.0, 0.0, 0.0];
    Ok(match joint.text("type")? {
        "fixed" => (JointKind::Fixed, false),
        "revolute" => (JointKind::Revolute { axis }, true),
        "continuous" => (JointKind::Revolute { axis }, false),
        "prismatic" => (JointKind::Prismatic { axis }, true),
        "planar" => (JointKind::Planar { normal: axis }, false),
        "floating" => (JointKind::Floating, false),
        "spherical" => {
            let what = format!("{} has the type \"spherical\"", joint.title());
            return Err(UrdfError::NotExpressed { line: joint.line(), what });
        }
        other => return Err(joint.unexpected(format!("the type {other:?} is unknown"))),
    })
}

fn placement(
    origin: Element<'_>,
    warnings: &mut Vec<UrdfWarning>,
) -> Result<[[f64; 3]; 2], UrdfError> {
    if origin.node.has_attribute("quat_xyzw") {
        let what = format!("the attribute quat_xyzw of {}; write rpy instead", origin.title());
        return Err(UrdfError::NotExpressed { line: origin.line(), what });
    }
    origin.check(&ORIGIN, warnings)?;
    let vector = |name| Ok(origin.numbers(name)?.unwrap_or_default());
    Ok([vector("xyz")?, vector("rpy")?])
}

/// Returns the axis of a joint, scaled to length 1, because files have axes of any length.
fn axis(joint: Element<'_>, warnings: &mut Vec<UrdfWarning>) -> Result<[f64; 3], UrdfError> {
    let Some(element) = joint.child("axis") else { return Ok([1.0, 0.0, 0.0]) };
    element.check(&AXIS, warnings)?;
    element.text("xyz")?;
    let axis: [f64; 3] = element.numbers("xyz")?.unwrap_or_default();
    let length = axis[0].hypot(axis[1]).hypot(axis[2]);
    if length > 0.0 && length.is_finite() {
        return Ok(axis.map(|number| number / length));
    }
    let (line, joint) = (element.line(), joint.text("name")?.to_owned());
    Err(UrdfError::Axis { line, joint, axis })
}

/// Returns the limits in `<limit>`, an element that revolute and prismatic joints must have. Its
/// attributes `lower` and `upper` have defaults.
fn limits(
    joint: Element<'_>,
    [least, most]: [f64; 2],
    warnings: &mut Vec<UrdfWarning>,
) -> Result<Option<[f64; 2]>, UrdfError> {
    let name = joint.text("name")?.to_owned();
    let Some(limit) = joint.child("limit") else {
        return Err(UrdfError::NoLimit { line: joint.line(), joint: name });
    };
    limit.check(&LIMIT, warnings)?;
    let bound = |attribute, unsaid, endless: &[&str]| {
        let word = limit.node.attribute(attribute).unwrap_or_default().trim().to_ascii_lowercase();
        if endless.contains(&word.as_str()) {
            return Ok(if attribute == "lower" { f64::NEG_INFINITY } else { f64::INFINITY });
        }
        Ok(limit.number(attribute)?.unwrap_or(unsaid))
    };
    let lower = bound("lower", least, &["-inf", "-infinity"])?;
    let upper = bound("upper", most, &["inf", "+inf", "infinity", "+infinity"])?;
    let [lower, upper] = if lower > upper {
        let text = format!(
            "the lower limit {lower} is above the upper limit {upper}; the two are exchanged"
        );
        warnings.push(limit.warning(text));
        [upper, lower]
    } else {
        [lower, upper]
    };
    let endless = lower == f64::NEG_INFINITY && upper == f64::INFINITY;
    Ok((!endless).then_some([lower, upper]))
}

impl MimicElement {
    fn read(mimic: Element<'_>, warnings: &mut Vec<UrdfWarning>) -> Result<Self, UrdfError> {
        mimic.check(&MIMIC, warnings)?;
        Ok(Self {
            joint: Name::of(mimic, "joint")?,
            multiplier: mimic.number("multiplier")?.unwrap_or(1.0),
            offset: mimic.number("offset")?.unwrap_or(0.0),
        })
    }
}

/// The greatest speed and the greatest effort of a joint, from `velocity` and `effort` of its
/// `<limit>`. They are infinite if the attribute is missing, negative or not a number. Poses and
/// inverse kinematics do not use them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive {
    /// The greatest speed, in radians or units of length per second.
    pub velocity: f64,
    /// The greatest torque or force, in newton metres or newtons.
    pub effort: f64,
}

impl Drive {
    /// The drive without limits: both fields are infinite.
    pub const FREE: Self = Self { velocity: f64::INFINITY, effort: f64::INFINITY };

    pub(super) fn of(limit: Element<'_>) -> Self {
        let greatest = |name| {
            let number = limit.node.attribute(name).and_then(|text| number::finite(text.trim()));
            number.filter(|&number| number >= 0.0).unwrap_or(f64::INFINITY)
        };
        Self { velocity: greatest("velocity"), effort: greatest("effort") }
    }
}
