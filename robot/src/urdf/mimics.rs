//! What joints mimic in the end: files have joints that mimic joints that mimic.

use super::error::UrdfError;
use super::file::JointElement;
use super::warning::UrdfWarning;
use crate::mechanism::limits::{endless, shared};
use std::collections::HashMap;

/// The joint that has the value, by its number among all joints.
#[derive(Clone, Copy)]
pub(crate) struct Leader {
    pub(crate) joint: usize,
    pub(crate) multiplier: f64,
    pub(crate) offset: f64,
}

impl Leader {
    /// Limits of a joint that mimics this one, which bind the other, or cannot be meant.
    pub(crate) fn warning(&self, from: &JointElement, other: &JointElement) -> Option<UrdfWarning> {
        let (limits, range) = (from.limits?, other.limits.unwrap_or(endless()));
        let text = match shared(range, limits, self.multiplier, self.offset) {
            Some(left) if left == range => return None,
            Some([low, high]) => {
                format!(
                    "its limits narrow those of {:?}, which it mimics, to {low} … {high}",
                    other.name.text
                )
            }
            None => format!(
                "its limits leave no range to {:?}, which it mimics: they are not read",
                other.name.text
            ),
        };
        let element = format!("<joint name={:?}>", from.name.text);
        Some(UrdfWarning { line: from.name.line, element, text })
    }
}

/// For each joint what it mimics, if it does.
pub(crate) fn leaders(
    joints: &[JointElement],
    by_name: &HashMap<&str, usize>,
) -> Result<Vec<Option<Leader>>, UrdfError> {
    let mut leaders: Vec<Option<Leader>> = vec![None; joints.len()];
    for first in 0..joints.len() {
        // To a joint with a value of its own, or one whose leader is known, then back again.
        let (mut way, mut next) = (Vec::new(), first);
        while let Some(mimic) = joints[next].mimic.as_ref().filter(|_| leaders[next].is_none()) {
            let (from, other) = (&joints[next], &mimic.joint);
            let refused = || UrdfError::Mimic {
                line: other.line,
                joint: from.name.text.clone(),
                other: other.text.clone(),
            };
            let leader = *by_name.get(other.text.as_str()).ok_or_else(|| UrdfError::Unknown {
                line: other.line,
                joint: from.name.text.clone(),
                element: "mimic joint",
                name: other.text.clone(),
            })?;
            way.push((next, leader, mimic));
            // Longer than there are joints is a circle.
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
