//! The person and the robot as figures in the same world, with soles and contacts, for pictures and
//! pages.

use dq8::DualQuat;
use dq8_retarget::{Humanoid, Motion, Person, Role, Targets};
use mocap::clip::{Clip, Joint};
use mocap::svg::{Figure, Sole};
use std::error::Error;

/// The joints of the person in the size of the robot, and the links of the robot.
pub(crate) fn figures(
    person: &Person,
    humanoid: &Humanoid,
    targets: &Targets,
    motion: &Motion,
) -> Result<[Figure; 2], Box<dyn Error>> {
    let robot = humanoid.robot();
    let links = robot.mechanism().links();
    let mut poses = vec![DualQuat::IDENTITY; targets.frames() * links];
    robot.mechanism().job().poses(&motion.values, &mut poses)?;

    let joints = person.joint_names().len();
    let mut positions: Vec<_> = targets.skeleton.iter().map(|&place| up(place)).collect();
    let feet = [Role::LeftFoot, Role::RightFoot];
    let stands = |foot: usize| motion.contacts.iter().map(|contact| contact[foot]).collect();
    let mut soles = [0, 1].map(|foot| {
        let joint = targets.places.iter().find(|place| place.role == feet[foot]);
        let toes = joint.map(|place| carried(person.parents(), place.joint)).unwrap_or_default();
        let frames = positions.chunks_exact(joints);
        let corners = frames.flat_map(|frame| toes.iter().map(|&joint| frame[joint]));
        Sole { corners: corners.collect(), stands: stands(foot) }
    });
    let floor = floor(&soles);
    let all = soles.iter_mut().flat_map(|sole| &mut sole.corners).chain(&mut positions);
    all.for_each(|place| place[1] -= floor);
    let of_links = [0, 1].map(|foot| {
        let place = targets.places.iter().find(|place| place.role == feet[foot]);
        let (link, sole) = (place.map(|place| place.link), targets.sole(feet[foot]));
        let frames = poses.chunks_exact(links).filter_map(|frame| Some(frame[link?]));
        let sole = sole.unwrap_or_default();
        let corners = frames.flat_map(|pose| sole.iter().map(move |&at| pose.transform_point(at)));
        Sole { corners: corners.map(up).collect(), stands: stands(foot) }
    });

    let tree = |names: &[String], parents: &[Option<usize>]| {
        let joints = names.iter().zip(parents);
        let joints = joints.map(|(name, &parent)| Joint::new(name, parent, [0.0; 3], Vec::new()));
        let title = person.title().to_owned();
        Clip { title, joints: joints.collect(), frame_time: targets.step, values: Vec::new() }
    };
    let parents: Vec<_> = robot.joints().iter().map(|joint| joint.parent).collect();
    Ok([
        Figure {
            caption: "The clip".to_owned(),
            clip: tree(person.joint_names(), person.parents()),
            positions,
            soles,
        },
        Figure {
            caption: "The robot".to_owned(),
            clip: tree(robot.link_names(), &parents),
            positions: poses.iter().map(|pose| up(pose.translation())).collect(),
            soles: of_links,
        },
    ])
}

/// The height of the ground under the person's own feet, which is not that under the soles of the
/// robot: the median of the lowest corners that stand, or the lowest corner of all.
fn floor(soles: &[Sole]) -> f64 {
    let lowest = |stands: bool| -> Vec<f64> {
        let frames = soles.iter().flat_map(|sole| {
            let frames = (0..sole.stands.len()).filter(move |&frame| !stands || sole.stands[frame]);
            frames.map(|frame| sole.corners_in(frame).iter().map(|at| at[1]).reduce(f64::min))
        });
        let mut heights: Vec<_> = frames.flatten().collect();
        heights.sort_by(f64::total_cmp);
        heights
    };
    let standing = lowest(true);
    let ground = standing.get(standing.len() / 2).copied().or(lowest(false).first().copied());
    ground.unwrap_or(0.0)
}

/// Pictures have y up.
fn up([x, y, z]: [f64; 3]) -> [f64; 3] {
    [x, z, -y]
}

/// A joint and all that it carries.
fn carried(parents: &[Option<usize>], joint: usize) -> Vec<usize> {
    let mut carried = vec![joint];
    for (index, parent) in parents.iter().enumerate() {
        if parent.is_some_and(|parent| carried.contains(&parent)) {
            carried.push(index);
        }
    }
    carried
}
