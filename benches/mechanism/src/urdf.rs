//! Robots as URDF files, the form in which peers take them.

use dq8::representation::{EulerAxes, EulerFrame, EulerOrder};
use dq8_robot::{Joint, JointKind};

/// Roll, pitch and yaw.
const ROLL_PITCH_YAW: EulerOrder =
    EulerOrder { axes: EulerAxes::XYZ, frame: EulerFrame::Extrinsic };

/// The name of link `index`, and of the joint that carries it.
pub fn name(index: usize) -> String {
    format!("link{index}")
}

/// A root named `base`, and hinges without limits.
pub fn text(joints: &[Joint<f64>]) -> String {
    let mut text = String::from("<robot name=\"robot\"><link name=\"base\"/>\n");
    for (index, joint) in joints.iter().enumerate() {
        let JointKind::Revolute { axis } = joint.kind else { panic!("joint {index} is no hinge") };
        let parent = joint.parent.map_or("base".into(), name);
        let rotation = joint.placement.rotation().to_euler(ROLL_PITCH_YAW).angles.angles;
        let numbers = |[x, y, z]: [f64; 3]| format!("\"{x:?} {y:?} {z:?}\"");
        text += &format!(
            "<link name=\"{name}\"/><joint name=\"{name}\" type=\"continuous\">\
             <parent link=\"{parent}\"/><child link=\"{name}\"/>\
             <origin xyz={} rpy={}/><axis xyz={}/></joint>\n",
            numbers(joint.placement.translation()),
            numbers(rotation),
            numbers(axis),
            name = name(index),
        );
    }
    text + "</robot>\n"
}
