//! The clip and the robot at the same moments.

use dq8::DualQuat;
use dq8_retarget::{Humanoid, Person, Targets};
use mocap::clip::{Clip, Joint};
use mocap::svg;
use std::error::Error;

pub(crate) fn draw(
    person: &Person,
    humanoid: &Humanoid,
    targets: &Targets,
    values: &[f64],
) -> Result<String, Box<dyn Error>> {
    let robot = humanoid.robot();
    let mut poses = vec![DualQuat::IDENTITY; targets.frames() * robot.mechanism().links()];
    robot.mechanism().job().poses(values, &mut poses)?;
    // Pictures have y up.
    let up = |[x, y, z]: [f64; 3]| [x, z, -y];
    let links: Vec<_> = poses.iter().map(|pose| up(pose.translation())).collect();
    let skeleton: Vec<_> = targets.skeleton.iter().map(|&place| up(place)).collect();

    let tree = |names: &[String], parents: &[Option<usize>]| {
        let joints = names.iter().zip(parents);
        let joints = joints.map(|(name, &parent)| Joint::new(name, parent, [0.0; 3], Vec::new()));
        let title = person.title().to_owned();
        Clip { title, joints: joints.collect(), frame_time: targets.step, values: Vec::new() }
    };
    let parents: Vec<_> = robot.joints().iter().map(|joint| joint.parent).collect();
    let person = tree(person.joint_names(), person.parents());
    let robot = tree(robot.link_names(), &parents);
    Ok(svg::rows(&[("The clip", &person, &skeleton), ("The robot", &robot, &links)])?)
}
