use crate::error::UrdfError;
use crate::file::File;
use crate::joint::{joint, mimic};
use crate::tree::{Node, nodes};
use dq8::mechanism::{Joint, JointKind, Mechanism, MechanismError, OwnedMechanism};
use dq8::{DualQuat, Real};
use std::collections::{HashMap, HashSet};
use std::path::Path;

/// The mechanism of a file, and its names.
#[derive(Clone, Debug)]
pub struct Robot {
    name: String,
    joints: Vec<Joint<f64>>,
    mechanism: OwnedMechanism<f64>,
    link_names: Vec<String>,
    joint_names: Vec<Option<String>>,
    value_names: Vec<String>,
}

impl Robot {
    /// From the text of a file.
    ///
    /// # Errors
    /// If it is not URDF, links and joints are not one tree, or something is not understood.
    pub fn from_urdf(text: &str) -> Result<Self, UrdfError> {
        Self::from_elements(File::read(text)?)
    }

    /// From a file.
    ///
    /// # Errors
    /// As for [`from_urdf`](Self::from_urdf), or if it cannot be read.
    pub fn from_file(path: impl AsRef<Path>) -> Result<Self, UrdfError> {
        let path = path.as_ref();
        let text = std::fs::read_to_string(path)
            .map_err(|source| UrdfError::Read { path: path.display().to_string(), source })?;
        Self::from_urdf(&text)
    }

    fn from_elements(robot: File) -> Result<Self, UrdfError> {
        let mut names = HashSet::new();
        for joint in &robot.joints {
            if !names.insert(joint.name.as_str()) {
                return Err(UrdfError::Twice { element: "joint", name: joint.name.clone() });
            }
        }
        let nodes = nodes(&robot)?;
        let links: HashMap<_, _> =
            nodes.iter().enumerate().map(|(index, node)| (node.link, index)).collect();
        let by_name: HashMap<_, _> =
            robot.joints.iter().map(|joint| (joint.name.as_str(), joint)).collect();
        let mut joints = Vec::with_capacity(nodes.len());
        for node in &nodes {
            let Some(from) = node.joint else {
                joints.push(Joint::fixed(None, DualQuat::IDENTITY));
                continue;
            };
            let parent = links.get(from.parent.as_str()).copied().unwrap_or_default();
            let mut joint = joint(from, parent)?;
            joint.mimic = mimic(from, &by_name, &links)?;
            joints.push(joint);
        }
        let mechanism = OwnedMechanism::new(&joints).map_err(|source| refused(source, &nodes))?;
        let joint_names = nodes.iter().map(|node| node.joint.map(|joint| joint.name.clone()));
        let joint_names: Vec<_> = joint_names.collect();
        Ok(Self {
            name: robot.name.clone(),
            value_names: value_names(&joints, &joint_names),
            link_names: nodes.iter().map(|node| node.link.to_owned()).collect(),
            joints,
            mechanism,
            joint_names,
        })
    }

    /// The name of the robot.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The mechanism: link j is what joint j carries, link 0 the root.
    #[must_use]
    pub fn mechanism(&self) -> Mechanism<'_, f64> {
        self.mechanism.view()
    }

    /// The same in `f32`, or in other numbers.
    ///
    /// # Errors
    /// If something is beyond the range of these numbers.
    pub fn cast<R: Real>(&self) -> Result<OwnedMechanism<R>, MechanismError> {
        let joints: Vec<_> = self.joints.iter().map(Joint::cast).collect();
        OwnedMechanism::new(&joints)
    }

    /// The joints that the mechanism is made of; link j is what joint j carries.
    #[must_use]
    pub fn joints(&self) -> &[Joint<f64>] {
        &self.joints
    }

    /// The names of the links: link j of the mechanism.
    #[must_use]
    pub fn link_names(&self) -> &[String] {
        &self.link_names
    }

    /// The number of a link.
    #[must_use]
    pub fn link(&self, name: &str) -> Option<usize> {
        self.link_names.iter().position(|other| other == name)
    }

    /// The names of the joints: what carries link j, nothing for the root.
    #[must_use]
    pub fn joint_names(&self) -> &[Option<String>] {
        &self.joint_names
    }

    /// A name for each value of a configuration: that of the joint, with `.x`, `.y` and `.angle` for planar
    /// joints, and `.qx`, `.qy`, `.qz`, `.qw`, `.x`, `.y`, `.z` for floating ones.
    #[must_use]
    pub fn value_names(&self) -> &[String] {
        &self.value_names
    }

    /// Limits for each value; none for continuous, planar and floating joints.
    #[must_use]
    pub fn value_limits(&self) -> Vec<Option<[f64; 2]>> {
        let view = self.mechanism.view();
        let mut limits = vec![None; view.values()];
        for (joint, from) in self.joints.iter().enumerate() {
            if let (None, Some(range)) = (from.mimic, view.values_of(joint)) {
                for slot in limits.get_mut(range).unwrap_or_default() {
                    *slot = from.limits;
                }
            }
        }
        limits
    }
}

/// The name of the joint that a mechanism refuses.
fn refused(source: MechanismError, nodes: &[Node<'_>]) -> UrdfError {
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
    let node = nodes.get(index).and_then(|node| node.joint);
    UrdfError::Mechanism { joint: node.map(|joint| joint.name.clone()).unwrap_or_default(), source }
}

fn value_names(joints: &[Joint<f64>], names: &[Option<String>]) -> Vec<String> {
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
