//! Inverse kinematics: how often and how fast arms reach random targets.
//!
//! ```text
//! cargo run --release --example reach
//! ```
//!
//! Targets are from random joint values within the limits, random starts, and the default options:
//! 10⁻⁵ m, 10⁻⁵ rad, at most 100 iterations of which restarts are a part. Its last column
//! is the worst error of those that were reached, found by nalgebra.

use dq8::{Backend, Real, simd::Float};
use dq8_arms::{Plan, Random, exact, gantry, puma, rounded, ur5};
use dq8_robot::ik::{Options, Outcome, Report};
use std::error::Error;
use std::time::Instant;

const TARGETS: usize = 10_000;

fn main() -> Result<(), Box<dyn Error>> {
    if let Some(argument) = std::env::args().nth(1) {
        return Err(format!("usage: reach, without arguments such as {argument}").into());
    }
    println!("| arm | numbers | backend | reached | iterations | restarts | µs | worst error |");
    println!("|---|---|---|---|---|---|---|---|");
    for (name, plan) in [("UR5", ur5()), ("PUMA 560, narrow limits", puma())] {
        rows::<f64, 6>(name, "f64", &plan)?;
        rows::<f32, 6>(name, "f32", &plan)?;
    }
    rows::<f64, 8>("UR5 on a screw on a slide", "f64", &gantry())
}

/// A row for each backend.
fn rows<R: Real + Float, const N: usize>(
    name: &str,
    numbers: &str,
    plan: &Plan<N>,
) -> Result<(), Box<dyn Error>> {
    let arm = plan.arm::<R>();
    let mut random = Random(1);
    let goals: Vec<_> = (0..TARGETS).map(|_| plan.draw(&mut random)).collect();
    let starts: Vec<[R; N]> = (0..TARGETS).map(|_| rounded(plan.draw(&mut random))).collect();
    let targets: Vec<_> = goals.iter().map(|&goal| arm.forward(&rounded(goal))).collect();
    for backend in Backend::available() {
        let (mut values, mut reports) = (starts.clone(), vec![Report::default(); TARGETS]);
        let clock = Instant::now();
        let job = arm.0.job().backend(backend);
        job.solve(&targets, values.as_flattened_mut(), &mut reports, &Options::default())?;
        let micros = clock.elapsed().as_secs_f64() * 1e6 / TARGETS as f64;
        let (mut reached, mut iterations, mut restarts, mut worst) = (0.0, 0.0, 0.0, 0.0_f64);
        for ((goal, value), report) in goals.iter().zip(values).zip(reports) {
            if report.outcome == Outcome::Converged {
                reached += 1.0;
                iterations += f64::from(report.iterations);
                restarts += f64::from(report.restarts);
                let [turn, distance] = plan.apart(&exact(value), goal);
                worst = worst.max(turn).max(distance);
            }
        }
        let share = 100.0 * reached / TARGETS as f64;
        let (iterations, restarts) = (iterations / reached, restarts / reached);
        println!(
            "| {name} | {numbers} | {backend} | {share:.1} % | {iterations:.1} | {restarts:.2} | \
             {micros:.1} | {worst:.1e} |"
        );
    }
    Ok(())
}
