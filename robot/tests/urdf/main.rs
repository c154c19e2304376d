//! Robots from URDF files: what is read, what is refused and what is reported.

mod changed;
mod large;
mod limits;
mod refused;
mod robots;
mod text;
mod warnings;

use dq8_robot::urdf::Robot;

/// A sound file, as those of real robots are: a hinge, and a slide that follows it.
const FILE: &str = r#"<?xml version="1.0"?>
<robot name="case" xmlns:v="http://vendor.example/x">
  <link name="base"/>
  <link name="tip"/>
  <link name="end"/>
  <joint name="hinge" type="revolute">
    <parent link="base"/>
    <child link="tip"/>
    <origin xyz="0.1 0.2 0.3" rpy="0.4 -0.5 0.6"/>
    <axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="9" velocity="3"/>
  </joint>
  <joint name="slide" type="prismatic">
    <parent link="tip"/>
    <child link="end"/>
    <limit lower="-3" upper="5"/>
    <mimic joint="hinge" multiplier="2" offset="1"/>
  </joint>
</robot>
"#;

/// The file with one text changed into another.
fn changed_to(from: &str, to: &str) -> String {
    assert!(FILE.contains(from), "{from}");
    FILE.replacen(from, to, 1)
}

/// Rows of a table: what is changed in the file, into what, and what comes of it; ⏎ ends a line.
fn rows(table: &str) -> impl Iterator<Item = (String, String)> {
    table.trim_matches('\n').lines().map(|row| {
        let [from, to, wanted] = row.splitn(3, " | ").collect::<Vec<_>>()[..] else {
            panic!("{row}")
        };
        (changed_to(from, &to.replace('⏎', "\n")), wanted.to_owned())
    })
}

/// The robot of a file whose hinge is at 0.7 rad, which is at (0.1, 0.2, 0.3) and turned by roll,
/// pitch and yaw (0.4, −0.5, 0.6): computed elsewhere.
#[track_caller]
fn stands(file: &[u8], link: &str) -> Robot {
    let robot = Robot::from_bytes(file)
        .unwrap_or_else(|error| panic!("{error} in {}", String::from_utf8_lossy(file)));
    let pose = robot.mechanism().link_pose(&[0.7], robot.link(link).unwrap()).unwrap();
    let wanted =
        [0.18013404935788466, -0.25178997373755496, 0.6138129886041426, 0.7262142579211889];
    let found = pose.rotation().to_array().into_iter().chain(pose.translation());
    for (found, wanted) in found.zip(wanted.into_iter().chain([0.1, 0.2, 0.3])) {
        assert!((found - wanted).abs() < 1e-15, "{pose}");
    }
    robot
}
