//! The robots: an arm of seven axes and a humanoid of 29, with dimensions of our own.

use dq8::{DualQuat, Quat};
use dq8_robot::Joint;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

fn at(translation: [f64; 3], about_x: f64) -> DualQuat<f64> {
    DualQuat::from_rotation_translation(Quat::from_axis_angle(X, about_x), translation)
}

/// Hinges about z, frames laid as Denavit and Hartenberg do.
pub fn arm() -> Vec<Joint<f64>> {
    let quarter = core::f64::consts::FRAC_PI_2;
    let placements = [
        at([0.0, 0.0, 0.34], 0.0),
        at([0.0, 0.0, 0.0], -quarter),
        at([0.0, -0.32, 0.0], quarter),
        at([0.08, 0.0, 0.0], quarter),
        at([-0.08, 0.39, 0.0], -quarter),
        at([0.0, 0.0, 0.0], quarter),
        at([0.09, 0.0, 0.0], quarter),
    ];
    let parent = |joint: usize| joint.checked_sub(1);
    (0..7).map(|joint| Joint::revolute(parent(joint), placements[joint], Z)).collect()
}

/// A spherical wrist on a shoulder and an elbow, or three parallel axes.
pub fn six(three_parallel: bool) -> Vec<Joint<f64>> {
    let (axes, placements) = if three_parallel {
        let places = [[0.0, 0.13, 0.1], [0.42, -0.12, 0.0], [0.4, 0.0, 0.0], [0.0, 0.1, 0.0]];
        ([Z, Y, Y, Y, Z, Y], [places[0], places[1], places[2], places[3], [0.0, 0.0, -0.1]])
    } else {
        let places = [[0.0, 0.0, 0.4], [0.0, 0.15, 0.43], [0.02, 0.0, 0.43]];
        ([Z, Y, Y, Z, Y, Z], [places[0], places[1], places[2], [0.0; 3], [0.0; 3]])
    };
    let joint = |joint: usize| match joint.checked_sub(1) {
        Some(on) => Joint::revolute(Some(on), at(placements[on], 0.0), axes[joint]),
        None => Joint::revolute(None, DualQuat::IDENTITY, axes[joint]),
    };
    (0..6).map(joint).collect()
}

/// Two legs of six, a waist of three, two arms of seven.
pub fn humanoid() -> Vec<Joint<f64>> {
    let tilted = |translation, about: [f64; 3], angle: f64| {
        DualQuat::from_rotation_translation(Quat::from_axis_angle(about, angle), translation)
    };
    let mut joints = Vec::new();
    let mut add = |parent, placement, axis| {
        joints.push(Joint::revolute(parent, placement, axis));
        Some(joints.len() - 1)
    };
    for side in [1.0, -1.0] {
        let hip = add(None, at([0.0, 0.065 * side, -0.1], 0.0), Y);
        let hip = add(hip, tilted([0.0, 0.05 * side, -0.03], Y, -0.17), X);
        let hip = add(hip, at([0.025, 0.0, -0.12], 0.0), Z);
        let knee = add(hip, tilted([-0.08, 0.002 * side, -0.18], Y, 0.17), Y);
        let ankle = add(knee, at([0.0, 0.0, -0.3], 0.0), Y);
        add(ankle, at([0.0, 0.0, -0.018], 0.0), X);
    }
    let waist = add(None, at([0.0, 0.0, 0.0], 0.0), Z);
    let waist = add(waist, at([-0.004, 0.0, 0.044], 0.0), X);
    let chest = add(waist, at([0.0, 0.0, 0.0], 0.0), Y);
    for side in [1.0, -1.0] {
        let turned = DualQuat::from_rotation_translation(
            Quat::from_axis_angle(X, 0.28 * side),
            [0.004, 0.1 * side, 0.24],
        );
        let shoulder = add(chest, turned, Y);
        let shoulder = add(shoulder, tilted([0.0, 0.04 * side, -0.014], X, -0.28 * side), X);
        let shoulder = add(shoulder, at([0.0, 0.006 * side, -0.1], 0.0), Z);
        let elbow = add(shoulder, at([0.016, 0.0, -0.08], 0.0), Y);
        let wrist = add(elbow, at([0.1, 0.002 * side, -0.01], 0.0), X);
        let wrist = add(wrist, at([0.038, 0.0, 0.0], 0.0), Y);
        add(wrist, at([0.046, 0.0, 0.0], 0.0), Z);
    }
    joints
}
