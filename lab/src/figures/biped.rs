//! Kenwright's figure 5: the biped in its stance, with the limits of its joints.

use super::canvas::{Canvas, Side, colour};
use crate::report::Table;
use dq8::{DualQuat, Quat};
use mocap::biped;
use mocap::clip::{Axis, Channel, Joint};
use std::error::Error;

/// How far one degree of freedom of a joint goes, degrees; of the left one of a pair.
#[derive(Clone, Copy, Debug)]
pub struct Limit {
    /// The link behind the joint, of a pair without its side.
    pub link: &'static str,
    /// About which axis of the link before it: x to the left, y up, z ahead.
    pub axis: Axis,
    /// From and to, with 0 in the stance.
    pub range: [f64; 2],
}

const fn limit(link: &'static str, axis: Axis, low: f64, high: f64) -> Limit {
    Limit { link, axis, range: [low, high] }
}

/// Round numbers within what clinicians find on adults: no paper gives them. The pelvis is free.
pub const LIMITS: [Limit; 19] = [
    limit("Abdomen", Axis::X, -15.0, 40.0),
    limit("Abdomen", Axis::Z, -20.0, 20.0),
    limit("Abdomen", Axis::Y, -15.0, 15.0),
    limit("Chest", Axis::X, -15.0, 30.0),
    limit("Chest", Axis::Z, -15.0, 15.0),
    limit("Chest", Axis::Y, -30.0, 30.0),
    limit("Head", Axis::X, -50.0, 45.0),
    limit("Head", Axis::Y, -70.0, 70.0),
    limit("UpperArm", Axis::X, -170.0, 50.0),
    limit("UpperArm", Axis::Z, -20.0, 150.0),
    limit("UpperArm", Axis::Y, -80.0, 80.0),
    limit("Forearm", Axis::X, -145.0, 0.0),
    limit("Hand", Axis::X, -70.0, 70.0),
    limit("Thigh", Axis::X, -115.0, 25.0),
    limit("Thigh", Axis::Z, -25.0, 40.0),
    limit("Thigh", Axis::Y, -40.0, 40.0),
    limit("Shin", Axis::X, 0.0, 135.0),
    limit("Foot", Axis::X, -35.0, 50.0),
    limit("Foot", Axis::Z, -25.0, 30.0),
];

/// The range of a joint of the biped about an axis, degrees.
pub fn limit_of(name: &str, axis: Axis) -> Option<[f64; 2]> {
    let (side, link) = match (name.strip_prefix("Left"), name.strip_prefix("Right")) {
        (Some(link), _) => (1.0, link),
        (_, Some(link)) => (-1.0, link),
        _ => (1.0, name),
    };
    let found = LIMITS.iter().find(|limit| limit.link == link && limit.axis == axis)?;
    let [low, high] = found.range;
    // What turns a left limb outward turns a right one inward.
    Some(if side < 0.0 && axis != Axis::X { [-high, -low] } else { [low, high] })
}

/// Degrees of a joint in the stance: arms a little away from the body, elbows and knees not quite
/// straight.
fn stance(name: &str, axis: Axis) -> f64 {
    match (name, axis) {
        ("LeftUpperArm", Axis::Z) => 12.0,
        ("RightUpperArm", Axis::Z) => -12.0,
        ("LeftForearm" | "RightForearm", Axis::X) => -12.0,
        _ => 0.0,
    }
}

fn unit(axis: Axis) -> [f64; 3] {
    let mut unit = [0.0; 3];
    unit[axis as usize] = 1.0;
    unit
}

/// The poses of all joints in the stance, the pelvis above the origin.
fn poses(joints: &[Joint]) -> Vec<DualQuat<f64>> {
    let mut models: Vec<DualQuat<f64>> = Vec::new();
    for joint in joints {
        let mut local = DualQuat::from_translation(joint.offset);
        for channel in &joint.channels {
            if let Channel::Rotation(axis) = *channel {
                let angle = stance(&joint.name, axis).to_radians();
                local = local * DualQuat::from_rotation(Quat::from_axis_angle(unit(axis), angle));
            }
        }
        models.push(joint.parent.map_or(local, |parent| models[parent] * local));
    }
    models
}

/// Where a point of space is on the canvas.
type Projection = dyn Fn([f64; 3]) -> [f64; 2];

/// The drawing from the front and from the side, and the table of limits.
///
/// # Errors
/// If a joint of the biped has no limit.
pub(super) fn figure() -> Result<String, Box<dyn Error>> {
    /// For a metre.
    const PIXELS: f64 = 250.0;
    let joints = biped::clip().joints;
    let models = poses(&joints);
    let mut canvas =
        Canvas::new([820.0, 570.0], "The biped in its stance: 16 links, 36 degrees of freedom");
    // Who looks from the front has the left of the body to the right.
    let front = |p: [f64; 3]| [250.0 + PIXELS * p[0], 285.0 - PIXELS * p[1]];
    let side = |p: [f64; 3]| [640.0 + PIXELS * p[2], 285.0 - PIXELS * p[1]];
    let views: [(&Projection, Axis, &str); 2] =
        [(&front, Axis::Z, "from the front: leaning"), (&side, Axis::X, "from its left: bending")];
    for (place, axis, caption) in views {
        let ground = models.iter().map(|model| model.translation()[1]).fold(0.0, f64::min);
        let [left, y] = place([-0.45, ground, -0.45]);
        canvas.path([[left, y], [left + 0.9 * PIXELS, y]], colour::FRAME, 1.0);
        canvas.text([left + 0.45 * PIXELS, y + 26.0], Side::Middle, 14.0, colour::INK, caption);
        for (index, joint) in joints.iter().enumerate() {
            // From the side the right limbs are behind the left ones.
            let hidden = axis == Axis::X && joint.name.starts_with("Right");
            let limited = joint.channels.contains(&Channel::Rotation(axis));
            if limited && !hidden && joint.parent.is_some() {
                let range = limit_of(&joint.name, axis)
                    .ok_or_else(|| format!("{} has no limit about {axis:?}", joint.name))?;
                sector(&mut canvas, place, &joints, &models, index, axis, range);
            }
        }
        for (joint, model) in joints.iter().zip(&models) {
            let Some(parent) = joint.parent else { continue };
            let ends = [models[parent].translation(), model.translation()].map(place);
            canvas.path(ends, colour::BLUE, 5.0);
        }
        for (joint, model) in joints.iter().zip(&models) {
            let (radius, fill) =
                if joint.end_site { (2.5, colour::BLUE) } else { (4.5, colour::INK) };
            canvas.dot(place(model.translation()), radius, fill);
        }
    }
    names(&mut canvas, &front, &joints, &models);
    canvas.legend(
        [22.0, 52.0],
        &[
            (colour::BLUE, "links"),
            (colour::INK, "joints: degrees of freedom"),
            (colour::OCHRE, "between limits"),
        ],
    );
    Ok(canvas.to_svg() + &table())
}

/// What a link sweeps between its limits, about an axis that points at the eye.
fn sector(
    canvas: &mut Canvas,
    place: &Projection,
    joints: &[Joint],
    models: &[DualQuat<f64>],
    index: usize,
    axis: Axis,
    [low, high]: [f64; 2],
) {
    let Some(child) = joints.iter().rposition(|joint| joint.parent == Some(index)) else { return };
    // Of the children of the chest the neck, of those of the abdomen and shoulders the only one.
    let child = joints
        .iter()
        .position(|joint| joint.parent == Some(index) && joint.name == "Head")
        .unwrap_or(child);
    let at = models[index].translation();
    let link: [f64; 3] = core::array::from_fn(|i| models[child].translation()[i] - at[i]);
    let length = link[0].hypot(link[1]).hypot(link[2]);
    let radius = 0.6 * length;
    let now = stance(&joints[index].name, axis);
    let direction = |degrees: f64| {
        let turn = Quat::from_axis_angle(unit(axis), (degrees - now).to_radians());
        let turned = turn.rotate(link);
        place(core::array::from_fn(|i| at[i] + radius / length * turned[i]))
    };
    let arc = (0..=40).map(|i| direction(low + (high - low) * f64::from(i) / 40.0));
    let outline: Vec<_> = core::iter::once(place(at)).chain(arc).chain([place(at)]).collect();
    canvas.area(outline.clone(), colour::OCHRE, 0.28);
    canvas.path(outline, colour::OCHRE, 1.0);
}

/// Names and degrees of freedom beside the front view: of the left ones, and of those in the
/// middle.
fn names(canvas: &mut Canvas, place: &Projection, joints: &[Joint], models: &[DualQuat<f64>]) {
    // The lowest name so far, on the left and on the right.
    let mut lowest = [f64::NEG_INFINITY; 2];
    let mut named: Vec<_> = joints.iter().zip(models).collect();
    named.retain(|(joint, _)| !joint.end_site && !joint.name.starts_with("Right"));
    named.sort_by(|a, b| b.1.translation()[1].total_cmp(&a.1.translation()[1]));
    for (joint, model) in named {
        let at = place(model.translation());
        let (name, paired) = match joint.name.strip_prefix("Left") {
            Some(name) => (name, true),
            None => (joint.name.as_str(), false),
        };
        let freedom = joint.channels.len();
        let said =
            if paired { format!("{name} 2 × {freedom}") } else { format!("{name} {freedom}") };
        let (end, anchor) = if paired { (395.0, Side::Right) } else { (105.0, Side::Left) };
        let toward = if paired { end - 4.0 } else { end + 4.0 };
        let y = at[1].max(lowest[usize::from(paired)] + 17.0);
        lowest[usize::from(paired)] = y;
        let elbow = if paired { toward - 30.0 } else { toward + 30.0 };
        canvas.path([at, [elbow, at[1]], [toward, y]], colour::FRAME, 0.7);
        canvas.text([end, y + 4.5], anchor, 13.0, colour::INK, &said);
    }
}

fn table() -> String {
    let caption = "Limits of joints, degrees from the straight limb; of the left one of a pair";
    let mut table =
        Table::new(caption, &["link", "bend, about x", "lean, about z", "turn, about y"]);
    let mut links: Vec<_> = LIMITS.iter().map(|limit| limit.link).collect();
    links.dedup();
    for link in links {
        let cell = |axis| {
            limit_of(link, axis).map_or_else(String::new, |[low, high]| {
                format!("{low} to {high}").replace('-', "−")
            })
        };
        table.row([link.to_owned(), cell(Axis::X), cell(Axis::Z), cell(Axis::Y)]);
    }
    table.to_html()
}
