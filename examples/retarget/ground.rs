//! The floor: how high ankles are above the soles of the robot, and when the clip stands.

use crate::map::{Place, ROLES};
use dq8::{DualQuat, Quat};
use dq8_robot::urdf::Robot;
use roxmltree::{Document, Node};

/// A foot that is slower than this stands, if it is also low. Metres per second.
const SLOW: f64 = 0.2;

/// A foot that is at most so far above the lowest twentieth is low. Metres.
const LOW: f64 = 0.05;

/// The height of the robot's ankle above its sole, as it stands. The sole is the origin of a link
/// that is called so, or the lowest point of the boxes, spheres and cylinders that the file gives
/// for collisions of the foot. `None` if there are neither, such as where all shapes are meshes.
pub(crate) fn ankle_height(
    urdf: &str,
    robot: &Robot,
    places: &[Place],
    poses: &[DualQuat<f64>],
) -> Option<f64> {
    let document = Document::parse(urdf).ok()?;
    let heights = places.iter().filter(|place| is_foot(place)).filter_map(|place| {
        let ankle = poses[place.centre].translation()[2];
        let lowest = robot.link_names().iter().enumerate().filter_map(|(link, name)| {
            if !carried_rigidly(robot, place.link, link) {
                return None;
            }
            if name.contains("sole") {
                return Some(poses[link].translation()[2]);
            }
            let element = element(&document, name)?;
            let shapes = element.children().filter(|child| child.has_tag_name("collision"));
            shapes.filter_map(|shape| lowest_point(poses[link], shape)).reduce(f64::min)
        });
        lowest.reduce(f64::min).map(|lowest| ankle - lowest)
    });
    heights.reduce(f64::max)
}

/// The height by which targets must be lowered, so that standing soles are at height zero: the
/// median height of the ankles that stand, less the height of the ankle above the sole.
///
/// `targets` is `[frame][goal]`, a goal for each place; `step` is the time of a frame in seconds.
pub(crate) fn floor(
    places: &[Place],
    targets: &[DualQuat<f64>],
    step: f64,
    ankle_height: f64,
) -> f64 {
    let feet = || places.iter().enumerate().filter(|(_, place)| is_foot(place));
    let at = |foot: usize| targets.iter().skip(foot).step_by(places.len());
    let mut heights: Vec<_> =
        feet().flat_map(|(foot, _)| at(foot).map(|target| target.translation()[2])).collect();
    heights.sort_by(f64::total_cmp);
    let Some(&low) = heights.get(heights.len() / 20) else { return 0.0 };
    let mut standing = Vec::new();
    for (foot, _) in feet() {
        let course: Vec<_> = at(foot).map(|target| target.translation()).collect();
        for frame in course.windows(2) {
            let [x, y, z] = core::array::from_fn(|axis| frame[1][axis] - frame[0][axis]);
            let speed = (x * x + y * y + z * z).sqrt() / step;
            if speed < SLOW && frame[0][2] < low + LOW {
                standing.push(frame[0][2]);
            }
        }
    }
    standing.sort_by(f64::total_cmp);
    standing.get(standing.len() / 2).copied().unwrap_or(low) - ankle_height
}

pub(crate) fn is_foot(place: &Place) -> bool {
    ROLES[place.role].name.ends_with("foot")
}

/// Returns `true` if `link` is `foot`, or hangs on it by fixed joints alone.
fn carried_rigidly(robot: &Robot, foot: usize, mut link: usize) -> bool {
    while link != foot {
        let joint = &robot.joints()[link];
        match joint.parent {
            Some(parent) if joint.kind.values() == 0 => link = parent,
            _ => return false,
        }
    }
    true
}

fn element<'d>(document: &'d Document<'_>, name: &str) -> Option<Node<'d, 'd>> {
    let mut links = document.root_element().children().filter(|child| child.has_tag_name("link"));
    links.find(|link| link.attribute("name") == Some(name))
}

/// The height of the lowest point of a shape on a link with this pose.
fn lowest_point(link: DualQuat<f64>, collision: Node<'_, '_>) -> Option<f64> {
    let child = |of: Node<'_, '_>, name: &str| {
        of.children().find(|child| child.has_tag_name(name)).map(|found| found.id())
    };
    let find = |of: Node<'_, '_>, name: &str| {
        child(of, name).and_then(|id| collision.document().get_node(id))
    };
    let three = |node: Node<'_, '_>, name: &str| -> Option<[f64; 3]> {
        let words: Vec<f64> =
            node.attribute(name)?.split_whitespace().map_while(|word| word.parse().ok()).collect();
        words.try_into().ok()
    };
    let number = |node: Node<'_, '_>, name: &str| node.attribute(name)?.trim().parse::<f64>().ok();
    let origin = find(collision, "origin");
    let place = |name: &str| origin.and_then(|origin| three(origin, name)).unwrap_or_default();
    let [roll, pitch, yaw] = place("rpy");
    let turn = Quat::from_rpy(roll, pitch, yaw);
    let pose = link * DualQuat::from_rotation_translation(turn, place("xyz"));
    let geometry = find(collision, "geometry")?;
    // The third row of the rotation: the heights of the three unit vectors of the shape.
    let [x, y, z] = core::array::from_fn(|axis| {
        let mut unit = [0.0; 3];
        unit[axis] = 1.0;
        pose.transform_vector(unit)[2].abs()
    });
    let reach = if let Some(shape) = find(geometry, "box") {
        let [a, b, c] = three(shape, "size")?;
        0.5 * (a * x + b * y + c * z)
    } else if let Some(shape) = find(geometry, "sphere") {
        number(shape, "radius")?
    } else if let Some(shape) = find(geometry, "cylinder") {
        0.5 * number(shape, "length")? * z + number(shape, "radius")? * (x * x + y * y).sqrt()
    } else {
        return None;
    };
    Some(pose.translation()[2] - reach)
}
