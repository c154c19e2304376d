//! Which link hangs on which.

use crate::error::UrdfError;
use crate::file::{File, JointElement};
use std::collections::HashMap;

/// A link, and the joint that carries it unless it is the root.
#[derive(Clone, Copy)]
pub(crate) struct Node<'u> {
    pub(crate) link: &'u str,
    pub(crate) joint: Option<&'u JointElement>,
}

/// The links of a file, parents first, and otherwise in its order.
pub(crate) fn nodes(robot: &File) -> Result<Vec<Node<'_>>, UrdfError> {
    let mut carried: HashMap<&str, Option<&JointElement>> = HashMap::new();
    for link in &robot.links {
        if carried.insert(link, None).is_some() {
            return Err(UrdfError::Twice { element: "link", name: link.clone() });
        }
    }
    for joint in &robot.joints {
        let unknown = |element, name: &str| UrdfError::Unknown {
            joint: joint.name.clone(),
            element,
            name: name.to_owned(),
        };
        if !carried.contains_key(joint.parent.as_str()) {
            return Err(unknown("parent link", &joint.parent));
        }
        let Some(slot) = carried.get_mut(joint.child.as_str()) else {
            return Err(unknown("child link", &joint.child));
        };
        if slot.replace(joint).is_some() {
            let (link, joint) = (joint.child.clone(), joint.name.clone());
            return Err(UrdfError::TwoParents { link, joint });
        }
    }
    let mut nodes = Vec::new();
    let mut done: HashMap<&str, bool> = HashMap::new();
    for link in &robot.links {
        // Up to what is there already, then down again.
        let mut way = Vec::new();
        let mut next = Some(link.as_str());
        while let Some(link) = next.filter(|link| !done.contains_key(link)) {
            if way.len() > robot.links.len() {
                return Err(UrdfError::Circle { link: link.to_owned() });
            }
            let joint = carried.get(link).copied().flatten();
            way.push(Node { link, joint });
            next = joint.map(|joint| joint.parent.as_str());
        }
        for node in way.into_iter().rev() {
            done.insert(node.link, true);
            nodes.push(node);
        }
    }
    let roots = nodes.iter().filter(|node| node.joint.is_none());
    let roots: Vec<_> = roots.map(|node| node.link.to_owned()).collect();
    if roots.len() == 1 { Ok(nodes) } else { Err(UrdfError::Roots { links: roots }) }
}
