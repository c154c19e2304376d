//! The robots of this repository, against nalgebra and another reader of the same elements.

use dq8::DualQuat;
use dq8_robot::JointKind;
use dq8_robot::urdf::Robot;
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use std::collections::HashMap;

const FILES: [(&str, &str, usize); 3] = [
    ("arm6", include_str!("../../robots/arm6.urdf"), 6),
    ("arm7", include_str!("../../robots/arm7.urdf"), 8),
    ("humanoid", include_str!("../../robots/humanoid.urdf"), 29),
];

/// Poses of links by name, by nalgebra, from the elements as urdf-rs reads them.
fn by_nalgebra(text: &str, values: &HashMap<&str, f64>) -> HashMap<String, Isometry3<f64>> {
    let file = urdf_rs::read_from_string(text).unwrap();
    let mut poses = HashMap::from([(file.links[0].name.clone(), Isometry3::identity())]);
    while poses.len() < file.links.len() {
        for joint in &file.joints {
            let Some(&parent) = poses.get(&joint.parent.link) else { continue };
            let value = match &joint.mimic {
                Some(mimic) => values[mimic.joint.as_str()],
                None => values.get(joint.name.as_str()).copied().unwrap_or(0.0),
            };
            let ([roll, pitch, yaw], xyz) = (joint.origin.rpy.0, joint.origin.xyz.0);
            let turn = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
            let placement = Isometry3::from_parts(Translation3::from(xyz), turn);
            let [along, about] = match joint.joint_type {
                urdf_rs::JointType::Fixed => [0.0, 0.0],
                urdf_rs::JointType::Prismatic => [value, 0.0],
                _ => [0.0, value],
            };
            let axis = Vector3::from(joint.axis.xyz.0);
            let motion = Isometry3::new(axis * along, axis * about);
            poses.insert(joint.child.link.clone(), parent * placement * motion);
        }
    }
    poses
}

#[test]
fn poses_of_links_are_those_of_nalgebra() {
    for (name, text, values) in FILES {
        let robot = Robot::from_urdf(text).unwrap();
        assert_eq!((robot.name(), robot.mechanism().values()), (name, values));
        let configurations = 11;
        let all: Vec<f64> =
            (0..configurations * values).map(|i| (i as f64 * 0.739).sin() * 2.5).collect();
        let links = robot.link_names().len();
        let mut poses = vec![DualQuat::IDENTITY; configurations * links];
        robot.mechanism().job().poses(&all, &mut poses).unwrap();
        for (values, poses) in all.chunks_exact(values).zip(poses.chunks_exact(links)) {
            let names = robot.value_names().iter().map(String::as_str);
            let wanted = by_nalgebra(text, &names.zip(values.iter().copied()).collect());
            for (link, pose) in robot.link_names().iter().zip(poses) {
                let wanted = wanted[link].to_homogeneous();
                for (row, numbers) in pose.to_matrix3x4().into_iter().enumerate() {
                    for (column, number) in numbers.into_iter().enumerate() {
                        let error = (number - wanted[(row, column)]).abs();
                        assert!(error < 1e-14, "{name}, {link}: {error}");
                    }
                }
            }
        }
    }
}

#[test]
fn limits_and_names_are_those_of_the_file() {
    let robot = Robot::from_urdf(FILES[1].1).unwrap();
    assert_eq!(robot.value_names()[7], "finger_joint");
    assert_eq!(robot.value_limits()[3], Some([-3.0, -0.1]));
    assert_eq!(robot.joint_names()[0], None);
    assert_eq!(robot.link("hand"), Some(8));
    let continuous = Robot::from_urdf(FILES[0].1).unwrap();
    assert_eq!(continuous.value_limits()[5], None);
    let single = robot.cast::<f32>().unwrap();
    let pose = single.view().link_pose(&[0.0; 8], 8).unwrap();
    let wanted = robot.mechanism().link_pose(&[0.0; 8], 8).unwrap();
    for (found, wanted) in pose.to_array().into_iter().zip(wanted.to_array()) {
        assert!((f64::from(found) - wanted).abs() < 1e-6);
    }
}

#[test]
fn floating_and_planar_joints_have_names_for_their_values() {
    let text = r#"<robot name="cart"><link name="tip"/><link name="world"/><link name="body"/>
        <joint name="base" type="floating"><parent link="world"/><child link="body"/></joint>
        <joint name="table" type="planar"><parent link="body"/><child link="tip"/><axis xyz="0 0 3"/></joint>
        </robot>"#;
    let robot = Robot::from_urdf(text).unwrap();
    // Parents first, although the file has them last.
    assert_eq!(robot.link_names(), ["world", "body", "tip"]);
    let names = ["base.qx", "base.qy", "base.qz", "base.qw", "base.x", "base.y", "base.z"];
    assert_eq!(robot.value_names()[..7], names);
    assert_eq!(robot.value_names()[7..], ["table.x", "table.y", "table.angle"]);
    assert!(matches!(JointKind::<f64>::Floating.values(), 7));
    let values = [0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 3.0, 0.5, 0.25, 0.0];
    let tip = robot.mechanism().link_pose(&values, 2).unwrap();
    assert_eq!(tip.translation(), [1.5, 2.25, 3.0]);
}
