//! Which link hangs on which.

use super::error::UrdfError;
use super::file::{File, Name};
use std::collections::HashMap;

/// A link, and the number of the joint that carries it unless it is the root.
#[derive(Clone, Copy)]
pub(crate) struct Node<'u> {
    pub(crate) link: &'u Name,
    pub(crate) joint: Option<usize>,
}

/// The links of a file, parents first, and otherwise in its order.
pub(crate) fn nodes(robot: &File) -> Result<Vec<Node<'_>>, UrdfError> {
    let mut numbers: HashMap<&str, usize> = HashMap::new();
    for (number, link) in robot.links.iter().enumerate() {
        if let Some(first) = numbers.insert(&link.text, number) {
            let (line, name) = (link.line, link.text.clone());
            let first = robot.links[first].line;
            return Err(UrdfError::Twice { line, element: "link", name, first });
        }
    }
    // The joint that carries each link, and the link it hangs on.
    let mut carried: Vec<Option<(usize, usize)>> = vec![None; robot.links.len()];
    for (number, joint) in robot.joints.iter().enumerate() {
        let link = |element, name: &Name| {
            numbers.get(name.text.as_str()).copied().ok_or_else(|| UrdfError::Unknown {
                line: name.line,
                joint: joint.name.text.clone(),
                element,
                name: name.text.clone(),
            })
        };
        let (parent, child) =
            (link("parent link", &joint.parent)?, link("child link", &joint.child)?);
        if let Some((first, _)) = carried[child].replace((number, parent)) {
            return Err(UrdfError::TwoParents {
                line: joint.child.line,
                link: joint.child.text.clone(),
                joint: joint.name.text.clone(),
                first: robot.joints[first].name.text.clone(),
            });
        }
    }
    let mut nodes = Vec::with_capacity(robot.links.len());
    let mut done = vec![false; robot.links.len()];
    for link in 0..robot.links.len() {
        // Up to what is there already, then down again.
        let (mut way, mut next) = (Vec::new(), Some(link));
        while let Some(link) = next.filter(|&link| !done[link]) {
            if way.len() > robot.links.len() {
                let Name { text, line } = robot.links[link].clone();
                return Err(UrdfError::Circle { line, link: text });
            }
            way.push(link);
            next = carried[link].map(|(_, parent)| parent);
        }
        for link in way.into_iter().rev() {
            done[link] = true;
            let joint = carried[link].map(|(joint, _)| joint);
            nodes.push(Node { link: &robot.links[link], joint });
        }
    }
    let roots = nodes.iter().filter(|node| node.joint.is_none()).map(|node| node.link);
    let roots: Vec<_> = roots.collect();
    if roots.len() == 1 {
        return Ok(nodes);
    }
    let line = roots.get(1).map_or(robot.line, |second| second.line);
    Err(UrdfError::Roots { line, links: roots.into_iter().map(|root| root.text.clone()).collect() })
}
