//! A robot from a URDF file: where can its tool get to, and how fast does it move?
//!
//! ```sh
//! cargo run --release --example urdf
//! ```

use dq8::DualQuat;
use dq8_robot::WorldAligned;
use dq8_robot::urdf::Robot;
use std::error::Error;

const CONFIGURATIONS: usize = 10_000;

fn main() -> Result<(), Box<dyn Error>> {
    let robot = Robot::from_urdf(include_str!("../robots/arm7.urdf"))?;
    let mechanism = robot.mechanism();
    let tool = robot.link("hand").ok_or("the robot has no hand")?;
    println!("{}: {} values, tool {}", robot.name(), mechanism.values(), robot.link_names()[tool]);

    // Configurations spread over the limits (radians, metres), one row of values each.
    let limits = robot.value_limits();
    let value = |i: usize| {
        let [low, high] = limits[i % limits.len()].unwrap_or([-3.1, 3.1]);
        low + (high - low) * (i as f64 * 0.618_033_988_749_895).fract()
    };
    let values: Vec<f64> = (0..CONFIGURATIONS * limits.len()).map(value).collect();

    // All of them on the lanes of the CPU, for this link alone.
    let mut poses = vec![DualQuat::IDENTITY; CONFIGURATIONS];
    mechanism.job().links(&[tool]).poses(&values, &mut poses)?;
    let reach =
        poses.iter().map(|pose| pose.translation().map(|x| x * x).iter().sum::<f64>().sqrt());
    println!("farthest from the base: {:.3} m", reach.fold(0.0, f64::max));

    // One configuration: the Jacobian, in the axes of the base, turns joint velocities into the tool's.
    let mut columns = vec![dq8::Twist::default(); mechanism.rates()];
    mechanism.link_jacobian(WorldAligned, &values[..limits.len()], tool, &mut columns)?;
    let fastest = columns.iter().map(|c| c.linear.map(|x| x * x).iter().sum::<f64>().sqrt());
    println!("fastest joint: {:.3} m/s at 1 rad/s", fastest.fold(0.0, f64::max));
    Ok(())
}

#[test]
fn the_tool_has_a_reach() {
    main().unwrap();
}
