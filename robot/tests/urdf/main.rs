//! Robots from URDF files: what is read, what is refused and what is reported.

mod changed;
mod elements;
mod errors;
mod large;
mod limits;
mod reach;
mod robots;
mod text;
mod warnings;

use dq8_robot::urdf::Robot;

/// The link behind a hinge about z at 0.7 rad, which is at (0.1, 0.2, 0.3) and turned by roll, pitch and yaw (0.4, −0.5, 0.6): computed
/// elsewhere.
fn stands(robot: &Robot, link: &str) {
    let pose = robot.mechanism().link_pose(&[0.7], robot.link(link).unwrap()).unwrap();
    let wanted =
        [0.18013404935788466, -0.25178997373755496, 0.6138129886041426, 0.7262142579211889];
    for (found, wanted) in pose.rotation().to_array().into_iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-15, "{pose}");
    }
    for (found, wanted) in pose.translation().into_iter().zip([0.1, 0.2, 0.3]) {
        assert!((found - wanted).abs() < 1e-15, "{pose}");
    }
}
