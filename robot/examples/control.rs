//! A control loop as firmware has it: no heap, no panic, every number in memory of a size that is
//! known.
//!
//! ```sh
//! cargo run --release --example control
//! ```

use dq8::DualQuat;
use dq8_robot::ik::{Freedom, Goal, Options, Reach};
use dq8_robot::{Joint, Mechanism, Step};

/// Six hinges and a tool.
const AXES: usize = 6;
const TOOL: usize = AXES;
/// Memory for one goal of the tool.
const SCRATCH: usize = Reach::<f32>::chain_scratch_bound(AXES, 1);

/// Makes the angles follow a target, one tick after the other. How far off it was at worst, in
/// metres.
fn run(
    ticks: u16,
    target: impl Fn(u16) -> DualQuat<f32>,
    angles: &mut [f32; AXES],
) -> Result<f32, Box<dyn core::error::Error>> {
    let (x, z) = ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let up = DualQuat::from_translation([0.0, 0.0, 0.2]); // metres
    let joints: [Joint<f32>; AXES + 1] = core::array::from_fn(|index| match index {
        TOOL => Joint::fixed(Some(TOOL - 1), up),
        _ => Joint::revolute(index.checked_sub(1), up, if index % 2 == 0 { z } else { x }),
    });
    let (mut steps, mut freedoms) = ([Step::default(); AXES + 1], [Freedom::default(); AXES]);
    let (goals, mut scratch) = ([Goal::pose(TOOL)], [0.0; SCRATCH]);
    let arm = Mechanism::new(&joints, &mut steps)?;
    let reach = Reach::new(arm, &goals, &mut freedoms)?;
    let mut worst = 0.0_f32;
    for tick in 0..ticks {
        let report = reach.follow(&[target(tick)], angles, &mut scratch, &Options::default())?;
        worst = worst.max(report.linear_error);
    }
    Ok(worst)
}

fn main() -> Result<(), Box<dyn core::error::Error>> {
    let mut angles = [0.3, 0.6, -0.2, 0.9, 0.4, 0.5]; // radians
    // A circle of 10 cm around a point that the tool can get to, once in 500 ticks.
    let target = |tick: u16| {
        let (sin, cos) = (f32::from(tick) * core::f32::consts::TAU / 500.0).sin_cos();
        DualQuat::from_translation([-0.3 + 0.05 * cos, 0.5 + 0.05 * sin, 0.6])
    };
    run(1, target, &mut angles)?; // gets there
    let worst = run(500, target, &mut angles)?;
    println!("off the circle by at most {worst:.1e} m");
    assert!(worst < 1e-5);
    Ok(())
}

#[test]
fn the_tool_stays_on_the_circle() {
    main().unwrap();
}
