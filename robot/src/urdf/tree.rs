//! The tree of a file's links, and the joints that mimic others.

use super::error::{UrdfError, UrdfWarning};
use super::file::{File, JointElement, Name};
use super::names::Names;
use crate::mechanism::step::{common_range, unlimited};

/// A link, and the index of the joint that carries it, unless the link is the root.
#[derive(Clone, Copy)]
pub(crate) struct Node<'u> {
    pub(crate) link: &'u Name,
    pub(crate) joint: Option<usize>,
}

/// Returns the order of the names of `elements`, which must differ.
pub(crate) fn named<E>(
    element: &'static str,
    elements: &[E],
    name: impl Fn(&E) -> &Name,
) -> Result<Names, UrdfError> {
    let name_of = |index: usize| name(&elements[index]).text.as_str();
    let names = Names::new((0..elements.len()).map(name_of));
    let Some([second, first]) = names.twice(name_of) else { return Ok(names) };
    let Name { text, line } = name(&elements[second]).clone();
    Err(UrdfError::Twice { line, element, name: text, first: name(&elements[first]).line })
}

/// Returns the links in the order of the file, except that a parent comes before its children.
pub(crate) fn nodes(robot: &File) -> Result<Vec<Node<'_>>, UrdfError> {
    let numbers = named("link", &robot.links, |link| link)?;
    // For each link, `carried` holds the joint that carries it and the parent link; `None` for the
    // root.
    let mut carried: Vec<Option<(usize, usize)>> = vec![None; robot.links.len()];
    for (number, joint) in robot.joints.iter().enumerate() {
        let link = |element, name: &Name| {
            let found = numbers.find(&name.text, |link| &robot.links[link].text);
            found.ok_or_else(|| UrdfError::Unknown {
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
        // The inner loop goes from a link up to the root, or to an ancestor that is in `nodes`
        // already. Then the links on this path are appended, ancestors first.
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

/// The index, in the file, of the joint whose value another joint follows, and the rule of the
/// follower.
#[derive(Clone, Copy)]
pub(crate) struct Leader {
    pub(crate) joint: usize,
    pub(crate) multiplier: f64,
    pub(crate) offset: f64,
}

impl Leader {
    /// Returns a warning if the limits of the joint `from`, which mimics the leader `other`, narrow
    /// the leader's range, or are ignored because they would leave no range.
    pub(crate) fn warning(&self, from: &JointElement, other: &JointElement) -> Option<UrdfWarning> {
        let (limits, range) = (from.limits?, other.limits.unwrap_or(unlimited()));
        let text = match common_range(range, limits, self.multiplier, self.offset) {
            Some(left) if left == range => return None,
            Some([low, high]) => {
                format!(
                    "its limits narrow those of {:?}, which it mimics, to {low} … {high}",
                    other.name.text
                )
            }
            None => format!(
                "its limits leave no range to {:?}, which it mimics, and are not read",
                other.name.text
            ),
        };
        let element = format!("<joint name={:?}>", from.name.text);
        Some(UrdfWarning { line: from.name.line, element, text })
    }
}

/// Returns, for each joint that mimics another joint, the joint with a value of its own whose value
/// it follows. That is not always the joint that the file names, because in some files the named
/// joint mimics a third joint.
pub(crate) fn leaders(
    joints: &[JointElement],
    by_name: &Names,
) -> Result<Vec<Option<Leader>>, UrdfError> {
    let mut leaders: Vec<Option<Leader>> = vec![None; joints.len()];
    for first in 0..joints.len() {
        // The inner loop follows the rules to a joint with a value of its own, or to a joint whose
        // leader is already known. Then the rules are combined on the way back.
        let (mut way, mut next) = (Vec::new(), first);
        while let Some(mimic) = joints[next].mimic.as_ref().filter(|_| leaders[next].is_none()) {
            let (from, other) = (&joints[next], &mimic.joint);
            let refused = || UrdfError::Mimic {
                line: other.line,
                joint: from.name.text.clone(),
                other: other.text.clone(),
            };
            let found = by_name.find(&other.text, |joint| &joints[joint].name.text);
            let leader = found.ok_or_else(|| UrdfError::Unknown {
                line: other.line,
                joint: from.name.text.clone(),
                element: "mimic joint",
                name: other.text.clone(),
            })?;
            way.push((next, leader, mimic));
            // A path longer than the count of joints goes in a circle.
            let valued = |joint: &JointElement| joint.kind.values() == 1;
            if way.len() > joints.len() || !valued(from) || !valued(&joints[leader]) {
                return Err(refused());
            }
            next = leader;
        }
        for (joint, other, mimic) in way.into_iter().rev() {
            let none = Leader { joint: other, multiplier: 1.0, offset: 0.0 };
            let further = leaders[other].unwrap_or(none);
            leaders[joint] = Some(Leader {
                joint: further.joint,
                multiplier: mimic.multiplier * further.multiplier,
                offset: mimic.multiplier * further.offset + mimic.offset,
            });
        }
    }
    Ok(leaders)
}
