//! Hand-eye calibration: where is the camera on the robot's hand?
//!
//! ```text
//! cargo run --release --example hand_eye
//! ```
//!
//! The robot makes some motions; its joints tell how the hand moved (A), a pattern that the camera
//! looks at tells how the camera moved (B). Camera and hand are one body, so A X = X B, where X is
//! the pose of the camera on the hand. `simultaneous` solves this in dual quaternions for rotation
//! and translation at once (Daniilidis 1999), `separate` for the one and then the other; `robot` is
//! a robot whose X is known.

mod calibration;
mod robot;
mod separate;
mod simultaneous;
#[cfg(test)]
mod tests;

use calibration::{CalibrationError, Pair};
use dq8::DualQuat;
use robot::Robot;
use std::error::Error;

/// How many robots, each with a camera somewhere else, make one line of the table.
const ROBOTS: u64 = 200;

/// A way to find X.
type Solve = fn(&[Pair]) -> Result<DualQuat<f64>, CalibrationError>;

/// Root mean squares over all robots of the error of X in rotation (radians) and translation
/// (metres).
fn errors(solve: Solve, motions: usize, noise: f64) -> Result<[f64; 2], CalibrationError> {
    let error = |seed| {
        let mut robot = Robot::new(seed);
        let found = solve(&robot.pairs(motions, noise))?;
        Ok([robot.camera.angle_to(found), robot.camera.distance_to(found)])
    };
    Ok(root_mean_squares(&(1..=ROBOTS).map(error).collect::<Result<Vec<_>, _>>()?))
}

/// The same of the difference between the screws of A and B, which needs no X.
fn mismatches(motions: usize, noise: f64) -> [f64; 2] {
    let pairs = (1..=ROBOTS).flat_map(|seed| Robot::new(seed).pairs(motions, noise));
    root_mean_squares(&pairs.map(|pair| pair.mismatch()).collect::<Vec<_>>())
}

fn root_mean_squares(errors: &[[f64; 2]]) -> [f64; 2] {
    let mean = |c: usize| errors.iter().map(|e| e[c] * e[c]).sum::<f64>() / errors.len() as f64;
    [mean(0).sqrt(), mean(1).sqrt()]
}

fn main() -> Result<(), Box<dyn Error>> {
    if let Some(argument) = std::env::args().nth(1) {
        return Err(format!("usage: hand_eye, without arguments such as {argument}").into());
    }
    println!(
        "Root mean squares of {ROBOTS} robots: how far the screws of A and B differ, and the errors"
    );
    println!("of X in both solutions; radians and metres. The noise is that of B, in each axis.");
    println!();
    println!("| motions | noise | A and B | | simultaneous | | separate | |");
    println!("|---|---|---|---|---|---|---|---|");
    for motions in [3, 6, 12, 24, 48] {
        for noise in [0.0, 1e-4, 1e-3, 1e-2] {
            let columns = [
                mismatches(motions, noise),
                errors(simultaneous::solve, motions, noise)?,
                errors(separate::solve, motions, noise)?,
            ];
            let columns = columns.map(|[angle, length]| format!("{angle:.1e} | {length:.1e}"));
            println!("| {motions} | {noise} | {} |", columns.join(" | "));
        }
    }
    Ok(())
}
