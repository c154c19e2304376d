//! The crate dynibo: isometries of nalgebra, one configuration at a time, into memory of the
//! caller.

use super::agree;
use crate::urdf;
use dq8::DualQuat;
use dq8_fixtures::turns::Job;
use dynibo::{Frame, Robot};
use std::hint::black_box;
use std::path::Path;

pub fn jobs<'a>(path: &Path, values: &'a [f64], expected: &[DualQuat<f64>]) -> Vec<Job<'a>> {
    let mut robot = Robot::from_urdf(path).expect("a robot");
    let (joints, links) = (robot.joint_count(), robot.link_count());
    let configurations = values.len() / joints;
    // The order of dynibo's values and links is that of its own tree; link 0 is the root.
    let order: Vec<usize> = (0..joints)
        .map(|joint| {
            let name = robot.joint_name(joint).expect("a joint");
            (0..joints).find(|&link| name == urdf::name(link)).expect("a joint of this name")
        })
        .collect();
    let values: Vec<f64> = values
        .chunks_exact(joints)
        .flat_map(|values| order.iter().map(|&link| values[link]))
        .collect();
    let places: Vec<usize> = (0..joints)
        .map(|link| {
            let id = robot.link_id(&urdf::name(link)).expect("a link");
            (0..links).find(|&at| robot.link_id_at(at).expect("a link") == id).expect("a place")
        })
        .collect();
    let tool = robot.link_id(&urdf::name(joints - 1)).expect("a link");

    let mut poses = vec![Frame::identity(); configurations * links];
    for (values, poses) in values.chunks_exact(joints).zip(poses.chunks_exact_mut(links)) {
        robot.forward_kinematics_all(values, poses).expect("shape");
    }
    let found: Vec<_> = poses
        .chunks_exact(links)
        .flat_map(|poses| places.iter().map(|&place| poses[place]))
        .map(|pose| (pose.translation.vector.into(), pose.rotation.coords.into()))
        .collect();
    agree("dynibo", 1e-12, expected, &found);

    let (mut other, its_values) = (robot.fork(), values.clone());
    let mut tools = vec![Frame::identity(); configurations];
    vec![
        Job::new("dynibo: all poses", move || {
            let poses = poses.chunks_exact_mut(links);
            for (values, poses) in black_box(&values).chunks_exact(joints).zip(poses) {
                robot.forward_kinematics_all(values, poses).expect("shape");
            }
        }),
        Job::new("dynibo: tool", move || {
            for (values, pose) in black_box(&its_values).chunks_exact(joints).zip(&mut tools) {
                *pose = other.forward_kinematics(values, tool).expect("shape");
            }
        }),
    ]
}
