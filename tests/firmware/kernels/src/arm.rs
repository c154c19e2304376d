//! Inverse kinematics of an arm whose number of joints is known at compile time, from its screws on.

use dq8::DualQuat;
use dq8::ik::{Arm, Joint, Options, Outcome};

#[unsafe(no_mangle)]
fn arm_solve(
    joints: &[Joint<f32>; 6],
    home: &DualQuat<f32>,
    target: &DualQuat<f32>,
    values: &mut [f32; 6],
) -> bool {
    let Ok(arm) = Arm::new(*joints, *home) else { return false };
    arm.reach(*target, values, &Options::default()).outcome == Outcome::Converged
}
