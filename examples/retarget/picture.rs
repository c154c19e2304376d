//! The clip and the robot at the same moments.

use crate::scene::Scene;
use dq8::DualQuat;
use mocap::clip::{Clip, Joint};
use mocap::svg;
use std::error::Error;

pub(crate) fn draw(scene: &Scene, motion: &[f64]) -> Result<String, Box<dyn Error>> {
    let mechanism = scene.robot.mechanism();
    let mut poses = vec![DualQuat::IDENTITY; scene.frames() * mechanism.links()];
    mechanism.job().poses(motion, &mut poses)?;
    // Clips have y up.
    let up = |[x, y, z]: [f64; 3]| [x, z, -y];
    let robot: Vec<_> = poses.iter().map(|pose| up(pose.translation())).collect();
    let skeleton: Vec<_> = scene.skeleton.iter().map(|&place| up(place)).collect();

    let links = scene.robot.link_names().iter().zip(scene.robot.joints());
    let links = links.map(|(name, joint)| Joint::new(name, joint.parent, [0.0; 3], Vec::new()));
    let clip = Clip { frame_time: scene.step, ..scene.clip.clone() };
    let links = Clip { joints: links.collect(), ..clip.clone() };
    Ok(svg::rows(&[("The clip", &clip, &skeleton), ("The robot", &links, &robot)])?)
}
