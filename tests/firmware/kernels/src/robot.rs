//! Robots: velocities and accelerations of links, with their poses.

use dq8::{DualQuat, Twist};
use dq8_robot::Mechanism;

type Motion = DualQuat<f32>;

#[unsafe(no_mangle)]
fn robot_link_velocities(
    robot: Mechanism<'_, f32>,
    values: &[f32],
    rates: &[f32],
    poses: &mut [Motion],
    twists: &mut [Twist<f32>],
) -> bool {
    robot.link_velocities(values, rates, poses, twists).is_ok()
}
#[unsafe(no_mangle)]
fn robot_link_accelerations(
    robot: Mechanism<'_, f32>,
    [values, rates, second_rates]: [&[f32]; 3],
    poses: &mut [Motion],
    twists: &mut [Twist<f32>],
    accelerations: &mut [Twist<f32>],
) -> bool {
    robot.link_accelerations(values, rates, second_rates, poses, twists, accelerations).is_ok()
}
