//! Which link is the tool.

use dq8_robot::urdf::Robot;

/// The link with the most moving joints between it and the base; of several the last.
pub(crate) fn tool(robot: &Robot) -> usize {
    let mut depths: Vec<usize> = Vec::new();
    for joint in robot.joints() {
        let moves = usize::from(joint.kind.values() > 0);
        depths.push(joint.parent.map_or(0, |parent| depths[parent]) + moves);
    }
    let deepest = depths.iter().enumerate().max_by_key(|(link, depth)| (**depth, *link));
    deepest.map_or(0, |(link, _)| link)
}
