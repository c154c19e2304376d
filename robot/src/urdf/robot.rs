use super::error::{UrdfError, UrdfWarning};
use super::file::{Drive, File, Name};
use super::names::Names;
use super::tree::{Leader, Node, leaders, named, nodes};
use super::xml;
use crate::{Joint, JointKind, Mechanism, MechanismError, Mimic, OwnedMechanism};
use dq8::internal::{brief, errors};
use dq8::{DualQuat, Real, Skeleton};
use std::fmt;
use std::iter::repeat_n;
use std::path::Path;

/// The robot that a URDF file describes: its mechanism, and the names of its links, joints and
/// values.
#[derive(Clone)]
pub struct Robot {
    pub(super) name: String,
    pub(super) joints: Vec<Joint<f64>>,
    pub(super) drives: Vec<Drive>,
    pub(super) mechanism: OwnedMechanism<f64>,
    pub(super) link_names: Vec<String>,
    /// The order of `link_names`.
    pub(super) links: Names,
    pub(super) joint_names: Vec<Option<String>>,
    pub(super) value_names: Vec<String>,
    pub(super) warnings: Vec<UrdfWarning>,
}

brief!([] Robot: Robot |it| {
    name: it.name, links: it.link_names.len(), values: it.value_names.len(), warnings: it.warnings.len(),
});

impl Robot {
    /// Reads a robot from the text of a URDF file.
    ///
    /// # Errors
    /// If the text is not URDF, its links and joints do not form one tree, or a part that says
    /// where links are is not understood.
    pub fn from_urdf(text: &str) -> Result<Self, UrdfError> {
        Self::from_elements(File::read(text)?)
    }

    /// Reads a robot from the URDF file at this path.
    ///
    /// # Errors
    /// The errors of [`from_bytes`](Self::from_bytes), or an error if the file cannot be read.
    pub fn from_file(path: impl AsRef<Path>) -> Result<Self, UrdfError> {
        let path = path.as_ref();
        let bytes = std::fs::read(path)
            .map_err(|source| UrdfError::Read { path: path.display().to_string(), source })?;
        Self::from_bytes(&bytes)
    }

    /// Reads a robot from the bytes of a URDF file, in the encoding that the file declares. This is
    /// UTF-8, UTF-16 with a byte order mark, or, with the feature `urdf-encodings`, any other
    /// encoding that browsers know.
    ///
    /// # Errors
    /// The errors of [`from_urdf`](Self::from_urdf), or, without the feature `urdf-encodings`, an
    /// error if the text is neither ASCII nor UTF-8 and declares another encoding.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, UrdfError> {
        let (text, warning) = xml::text(bytes)?;
        let mut robot = Self::from_urdf(&text)?;
        robot.warnings.splice(..0, warning);
        Ok(robot)
    }

    fn from_elements(robot: File) -> Result<Self, UrdfError> {
        let joints_by_name = named("joint", &robot.joints, |joint| &joint.name)?;
        let nodes = nodes(&robot)?;
        let leaders = leaders(&robot.joints, &joints_by_name)?;
        let name_of = |index: usize| nodes[index].link.text.as_str();
        let links = Names::new((0..nodes.len()).map(name_of));
        let link = |name: &Name| links.find(&name.text, name_of).unwrap_or_default();
        let (mut joints, mut narrowed) = (Vec::with_capacity(nodes.len()), Vec::new());
        for node in &nodes {
            let Some(number) = node.joint else {
                joints.push(Joint::fixed(None, DualQuat::IDENTITY));
                continue;
            };
            let from = &robot.joints[number];
            let mut joint = from.joint(link(&from.parent));
            if let Some(leader) = leaders[number] {
                let other = &robot.joints[leader.joint];
                let Leader { multiplier, offset, .. } = leader;
                joint.mimic = Some(Mimic { joint: link(&other.child), multiplier, offset });
                narrowed.extend(leader.warning(from, other));
            }
            joints.push(joint);
        }
        let mechanism =
            OwnedMechanism::new(&joints).map_err(|source| refused(source, &nodes, &robot))?;
        let mut warnings = [robot.warnings.as_slice(), &narrowed].concat();
        warnings.sort_by_key(|warning: &UrdfWarning| warning.line);
        let drive = |node: &Node<'_>| Some(robot.joints[node.joint?].drive);
        let drives = nodes.iter().map(|node| drive(node).unwrap_or(Drive::FREE)).collect();
        let name = |node: &Node<'_>| Some(robot.joints[node.joint?].name.text.clone());
        let joint_names: Vec<_> = nodes.iter().map(name).collect();
        Ok(Self {
            value_names: value_names(&joints, &joint_names),
            link_names: nodes.iter().map(|node| node.link.text.clone()).collect(),
            name: robot.name,
            joints,
            drives,
            mechanism,
            links,
            joint_names,
            warnings,
        })
    }

    /// Returns the warnings about the file: about parts that are not read because they do not say
    /// where links are, and about limits of joints that mimic others.
    #[must_use]
    pub fn warnings(&self) -> &[UrdfWarning] {
        &self.warnings
    }

    /// Returns the name of the robot.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the mechanism. Joint j carries link j, and link 0 is the root of the file.
    #[must_use]
    pub fn mechanism(&self) -> Mechanism<'_, f64> {
        self.mechanism.view()
    }

    /// Returns the mechanism in `f32` or another element type.
    ///
    /// # Errors
    /// If a placement or another constant of a joint is beyond the range of the element type.
    pub fn cast<R: Real>(&self) -> Result<OwnedMechanism<R>, MechanismError> {
        let joints: Vec<_> = self.joints.iter().map(Joint::cast).collect();
        OwnedMechanism::new(&joints)
    }

    /// Returns the joints from which the mechanism was made; joint j carries link j.
    #[must_use]
    pub fn joints(&self) -> &[Joint<f64>] {
        &self.joints
    }

    /// Returns the greatest speed and effort of each joint, indexed by link. Joint 0 carries the
    /// root, which does not move in a robot from a file. [`value_drives`](Self::value_drives) has
    /// the speed and effort of each value.
    ///
    /// ```
    /// # use dq8_robot::urdf::Robot;
    /// let robot = Robot::from_urdf(
    ///     "<robot name='door'><link name='wall'/><link name='door'/>
    ///      <joint name='hinge' type='revolute'><parent link='wall'/><child link='door'/>
    ///      <limit upper='2' velocity='1.5' effort='30'/></joint></robot>",
    /// )?;
    /// let hinge = robot.drives()[1];
    /// assert_eq!((hinge.velocity, hinge.effort), (1.5, 30.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn drives(&self) -> &[Drive] {
        &self.drives
    }

    /// Returns the greatest speed and effort of each value of a configuration, in the order of
    /// [`value_limits`](Self::value_limits). Each value has the speed and effort of its joint, so
    /// the seven values of a floating joint all have the same.
    ///
    /// ```
    /// # use dq8_robot::urdf::Robot;
    /// let robot = Robot::from_urdf(
    ///     "<robot name='door'><link name='wall'/><link name='door'/>
    ///      <joint name='hinge' type='revolute'><parent link='wall'/><child link='door'/>
    ///      <limit upper='2' velocity='1.5' effort='30'/></joint></robot>",
    /// )?;
    /// assert_eq!(robot.value_drives()[0].velocity, 1.5); // of the first value
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn value_drives(&self) -> Vec<Drive> {
        self.drives_of(JointKind::values).collect()
    }

    /// Returns the greatest speed of each rate, with [`Mechanism::rates`] elements: the speed of
    /// the joint that has the rate, in radians or units of length per second, and infinite if the
    /// file has none. The Python package has this array under the same name, and pinocchio calls it
    /// `velocityLimit`.
    ///
    /// ```
    /// # use dq8_robot::urdf::Robot;
    /// let robot = Robot::from_urdf(
    ///     "<robot name='door'><link name='wall'/><link name='door'/>
    ///      <joint name='hinge' type='revolute'><parent link='wall'/><child link='door'/>
    ///      <limit upper='2' velocity='1.5' effort='30'/></joint></robot>",
    /// )?;
    /// assert_eq!(robot.velocity_limits(), [1.5]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn velocity_limits(&self) -> Vec<f64> {
        self.drives_of(JointKind::rates).map(|drive| drive.velocity).collect()
    }

    /// Returns the drive of each joint, once for each of its values or each of its rates: `numbers`
    /// is [`JointKind::values`] or [`JointKind::rates`]. A joint that mimics another is left out,
    /// because it has no values and rates of its own.
    fn drives_of(&self, numbers: fn(&JointKind<f64>) -> usize) -> impl Iterator<Item = Drive> {
        let own = self.joints.iter().zip(&self.drives).filter(|(joint, _)| joint.mimic.is_none());
        own.flat_map(move |(joint, &drive)| repeat_n(drive, numbers(&joint.kind)))
    }

    /// Returns the names of the links, indexed as the links of the mechanism.
    #[must_use]
    pub fn link_names(&self) -> &[String] {
        &self.link_names
    }

    /// Returns the index of the link of this name.
    #[must_use]
    #[doc(alias("find_link", "get_frame_id"))]
    pub fn link(&self, name: &str) -> Option<usize> {
        self.links.find(name, |index| &self.link_names[index])
    }

    /// Returns the names of the joints, indexed by the link that the joint carries; `None` for a
    /// root that no joint carries.
    #[must_use]
    pub fn joint_names(&self) -> &[Option<String>] {
        &self.joint_names
    }

    /// Returns the index of the joint of this name, which is also the index of the link that it
    /// carries.
    #[must_use]
    #[doc(alias("find_joint", "get_joint_id"))]
    pub fn joint(&self, name: &str) -> Option<usize> {
        self.joint_names.iter().position(|joint| joint.as_deref() == Some(name))
    }

    /// Returns the index that the value with this [name](Self::value_names) has in a configuration.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<usize> {
        self.value_names.iter().position(|value| value == name)
    }

    /// Returns a name for each value of a configuration. It is the name of the joint that has the
    /// value, followed by `.x`, `.y` or `.angle` for planar joints, and by `.qx`, `.qy`, `.qz`,
    /// `.qw`, `.x`, `.y` or `.z` for floating joints.
    #[must_use]
    pub fn value_names(&self) -> &[String] {
        &self.value_names
    }

    /// Returns the limits of each value of a configuration, narrowed by the joints that mimic its
    /// joint, as [`Mechanism::value_limits`] does. An element is `None` if the value has no limits,
    /// as in continuous, planar and floating joints.
    #[must_use]
    pub fn value_limits(&self) -> Vec<Option<[f64; 2]>> {
        let view = self.mechanism.view();
        let mut limits = vec![[f64::NEG_INFINITY, f64::INFINITY]; view.values()];
        // This cannot fail, as `limits` has one element for each value.
        let _ = view.value_limits(&mut limits);
        let has_an_end = |[low, high]: &[f64; 2]| low.is_finite() || high.is_finite();
        limits.into_iter().map(|limits| Some(limits).filter(has_an_end)).collect()
    }
}

/// Formats the robot as the tree of its links, each followed by the name of the joint that carries
/// it.
impl fmt::Display for Robot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parents: Vec<_> = self.joints.iter().map(|joint| joint.parent).collect();
        let label = |(link, joint): (&String, &Option<String>)| match joint {
            Some(joint) => format!("{link} ({joint})"),
            None => link.clone(),
        };
        let labels = self.link_names.iter().zip(&self.joint_names).map(label);
        match Skeleton::new(&parents).and_then(|tree| tree.with_names(labels)) {
            Ok(tree) => write!(f, "{tree}"),
            // The links of a robot always form a tree with valid names, so this arm is never taken.
            Err(_) => f.write_str(&self.name),
        }
    }
}

impl std::str::FromStr for Robot {
    type Err = UrdfError;

    /// Reads a robot from the text of a URDF file, as [`Robot::from_urdf`] does.
    fn from_str(text: &str) -> Result<Self, UrdfError> {
        Self::from_urdf(text)
    }
}

/// Converts the error of a mechanism into an error that names the refused joint and its line.
fn refused(source: MechanismError, nodes: &[Node<'_>], robot: &File) -> UrdfError {
    let index = match source {
        MechanismError::Parent { joint, .. }
        | MechanismError::Placement { joint, .. }
        | MechanismError::DualPart { joint, .. }
        | MechanismError::NotFinite { joint, .. }
        | MechanismError::Axis { joint, .. }
        | MechanismError::Limits { joint, .. }
        | MechanismError::Mimic { joint, .. } => joint,
        _ => 0,
    };
    let joint = nodes.get(index).and_then(|node| robot.joints.get(node.joint?));
    let (line, joint) = joint
        .map_or((robot.line, String::new()), |joint| (joint.name.line, joint.name.text.clone()));
    UrdfError::Mechanism { line, joint, source }
}

pub(super) fn value_names(joints: &[Joint<f64>], names: &[Option<String>]) -> Vec<String> {
    let mut all = Vec::new();
    for (joint, name) in joints.iter().zip(names) {
        let (Some(name), None) = (name, joint.mimic) else { continue };
        let parts: &[&str] = match joint.kind {
            JointKind::Planar { .. } => &[".x", ".y", ".angle"],
            JointKind::Floating => &[".qx", ".qy", ".qz", ".qw", ".x", ".y", ".z"],
            JointKind::Fixed => &[],
            _ => &[""],
        };
        all.extend(parts.iter().map(|part| format!("{name}{part}")));
    }
    all
}

errors! {
    /// The reason why a change to a robot, such as the addition of a tool, is refused.
    #[derive(Clone, Debug, PartialEq)]
    ChangeError {
        /// A link or joint of the robot already has the name that was given to the new link or
        /// joint.
        Taken { name: String = "The name." } => "the robot already has a link or joint with the name {name:?}";
        /// The robot has no link of the given name.
        Unknown { name: String = "The name.", links: Vec<String> = "The names that there are." }
            => "the robot has no link {name:?}; its links are {}", links.join(", ");
        /// The changed joints do not form a valid mechanism.
        Mechanism(error: MechanismError) => "{error}";
    }
}

impl Robot {
    /// Returns the robot with a base that moves freely. A [floating
    /// joint](crate::JointKind::Floating) named `root_joint` carries the root, and its seven values
    /// and six rates come before all others.
    ///
    /// ```
    /// # use dq8_robot::urdf::Robot;
    /// let body = Robot::from_urdf("<robot name='drone'><link name='body'/></robot>")?;
    /// let drone = body.floating()?;
    /// assert_eq!(drone.value("root_joint.qw"), Some(3));
    /// assert_eq!((drone.mechanism().values(), drone.mechanism().rates()), (7, 6));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If the robot already has a joint named `root_joint`.
    pub fn floating(self) -> Result<Self, ChangeError> {
        self.on("root_joint", Joint::floating(None, DualQuat::IDENTITY))
    }

    /// Returns the robot mounted on a joint that is called `name`, such as a rail, a turntable, or
    /// a floor on which the robot drives. The joint stands on the base and carries the root link.
    ///
    /// # Errors
    /// If the robot already has a joint of this name, or the joint is not valid in a mechanism. The
    /// error names it as joint 0.
    pub fn on(mut self, name: &str, joint: Joint<f64>) -> Result<Self, ChangeError> {
        if self.joint(name).is_some() {
            return Err(ChangeError::Taken { name: name.into() });
        }
        self.joints[0] = joint;
        self.drives[0] = Drive::FREE;
        self.joint_names[0] = Some(name.into());
        self.rebuilt()
    }

    /// Returns the robot with one more link, such as a tool, a camera or a sole. The new link is
    /// called `name`, is fixed to `link` at `pose` in the frame of `link`, and has the last index.
    ///
    /// ```
    /// # use dq8_robot::urdf::Robot;
    /// use dq8::DualQuat;
    /// let body = Robot::from_urdf("<robot name='drone'><link name='body'/></robot>")?;
    /// let drone = body.with_tool("camera", "body", DualQuat::from_translation([0.1, 0.0, 0.0]))?;
    /// assert_eq!(drone.link("camera"), Some(1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If the robot has no link of the name `link`, a link or joint already has the name `name`, or
    /// the pose is farther than 10⁻³ from unit.
    pub fn with_tool(
        mut self,
        name: &str,
        link: &str,
        pose: DualQuat<f64>,
    ) -> Result<Self, ChangeError> {
        let Some(parent) = self.link(link) else {
            return Err(ChangeError::Unknown { name: link.into(), links: self.link_names });
        };
        if self.link(name).is_some() || self.joint(name).is_some() {
            return Err(ChangeError::Taken { name: name.into() });
        }
        self.links.push(name, |index| &self.link_names[index]);
        self.joints.push(Joint::fixed(Some(parent), pose));
        self.drives.push(Drive::FREE);
        self.link_names.push(name.into());
        self.joint_names.push(Some(name.into()));
        self.rebuilt()
    }

    fn rebuilt(self) -> Result<Self, ChangeError> {
        let mechanism = OwnedMechanism::new(&self.joints)?;
        let value_names = value_names(&self.joints, &self.joint_names);
        Ok(Self { mechanism, value_names, ..self })
    }
}
