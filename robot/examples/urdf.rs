//! A robot from a file, on a rail and with a tool: where the tool can get to, how it moves, and a
//! straight way for it.
//!
//! ```sh
//! cargo run --release --example urdf
//! ```

use dq8::{DualQuat, Twist};
use dq8_robot::ik::{Goal, Options, OwnedReach};
use dq8_robot::urdf::Robot;
use dq8_robot::{Joint, WorldAligned};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rail = Joint::prismatic(None, DualQuat::IDENTITY, [0.0, 1.0, 0.0]).with_limits([-2.0, 2.0]);
    let robot = Robot::from_urdf(include_str!("../robots/arm7.urdf"))?
        .on("rail", rail)?
        .with_tool("drill", "hand", DualQuat::from_translation([0.0, 0.0, 0.12]))?;
    let (mechanism, drill) = (robot.mechanism(), robot.link("drill").ok_or("no drill")?);
    let (size, rates) = (mechanism.values(), mechanism.rates());

    // 10,000 configurations spread over the limits (radians, metres), a row of values each, on the
    // lanes of the CPU.
    let limits = robot.value_limits();
    let value = |i: usize| {
        let [low, high] = limits[i % size].unwrap_or([-3.1, 3.1]);
        low + (high - low) * (i as f64 * 0.618_033_988_749_895).fract()
    };
    let values: Vec<f64> = (0..10_000 * size).map(value).collect();
    let mut poses = vec![DualQuat::IDENTITY; 10_000];
    let mut columns = vec![Twist::ZERO; 10_000 * rates];
    mechanism.job().links(&[drill]).jacobians(WorldAligned, &values, &mut poses, &mut columns)?;
    let highest = poses.iter().map(|pose| pose.translation()[2]).fold(0.0, f64::max);
    let fastest = columns.iter().map(|c| dq8::scalar::vector::norm(c.linear)).fold(0.0, f64::max);
    println!("{}: up to {highest:.2} m, {fastest:.2} m/s at 1 rad/s", robot.name());

    // From one of them half a metre along the rail in a second: a hundred targets on the screw
    // between two poses.
    let (start, mut now) = (poses[3], values[3 * size..4 * size].to_vec());
    let end = DualQuat::from_translation([0.0, 0.5, 0.0]) * start;
    let mut reach = OwnedReach::new(robot.cast()?, [Goal::pose(drill)])?;
    let mut worst = 0.0_f64;
    for step in 1..=100 {
        let target = start.sclerp(end, f64::from(step) / 100.0);
        let report = reach.solve(&[target], &mut now, &Options::default())?;
        worst = worst.max(report.linear_error);
    }
    // How the joints go on at that speed, with the elbow where it is.
    let (speed, mut velocities) =
        (Twist { linear: [0.0, 0.5, 0.0], ..Twist::ZERO }, vec![0.0; rates]);
    reach.rates(&now, &[speed], 0.01, &mut velocities)?;
    assert!(worst < 1e-5);
    println!("off the way by at most {worst:.1e} m; joints at {velocities:.2?}");
    Ok(())
}

#[test]
fn the_drill_goes_straight() {
    main().unwrap();
}
