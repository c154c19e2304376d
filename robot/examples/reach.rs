//! Inverse kinematics: how often and how fast arms reach random targets, and a figure that stands with
//! its feet where they should be and reaches for things.
//!
//! ```text
//! cargo run --release --example reach
//! ```
//!
//! The first table has targets from random joint values within the limits, random starts, and the
//! default options: 10⁻⁵ m, 10⁻⁵ rad, at most 100 iterations of which restarts are a part. Its last column is
//! the worst error of those that were reached, found by nalgebra.

use dq8::geometry::Screw;
use dq8::ik::TwoBone;
use dq8::{Backend, DualQuat, Hierarchy, Line, Quat, Real, simd::Float};
use dq8_arms::{Plan, Random, exact, gantry, puma, rounded, ur5};
use dq8_robot::OwnedMechanism;
use dq8_robot::ik::{Goal, Options, Outcome, OwnedReach, Report};
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
    rows::<f64, 8>("UR5 on a screw on a slide", "f64", &gantry())?;
    println!();
    feet()?;
    println!();
    hand()
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

// A figure of 1.75 m in metres, y up, z forward, x to its left. Bones hang down at rest.
const PELVIS: [f64; 3] = [0.0, 0.94, 0.0];
const HIP: [f64; 3] = [0.09, -0.02, 0.0];
const LEG: [f64; 2] = [0.44, 0.44];
const WAIST: [f64; 3] = [0.0, 0.10, 0.0];
const RIBS: [f64; 3] = [0.0, 0.27, 0.0];
const SHOULDER: [f64; 3] = [0.19, 0.50, 0.0];
const ELBOW: [f64; 3] = [0.19, 0.20, 0.0];
const WRIST: [f64; 3] = [0.19, -0.06, 0.0];
const PALM: [f64; 3] = [0.19, -0.15, 0.0];

/// The left ankle on steps of several heights, the knee forward.
fn feet() -> Result<(), Box<dyn Error>> {
    // Columns: along the bone, away from the knee, the hinge.
    let columns = [[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]];
    let row = |i: usize| [columns[0][i], columns[1][i], columns[2][i], 0.0];
    let at_rest = DualQuat::from_matrix3x4([row(0), row(1), row(2)]).rotation();
    let hip: [f64; 3] = core::array::from_fn(|i| PELVIS[i] + HIP[i]);
    let parents = [Hierarchy::ROOT, 0, 1];
    let leg = Hierarchy::new(&parents)?;

    println!("| ankle | span | knee, degrees | missed, m | by the hierarchy |");
    println!("|---|---|---|---|---|");
    for (height, forward) in [(0.08, 0.0), (0.08, 0.3), (0.25, 0.3), (0.5, 0.2), (0.08, 0.6)] {
        let ankle = [HIP[0], height, forward];
        let limb = TwoBone::reach(hip, LEG, ankle, [0.0, 0.0, 1.0])?;
        // Hip, knee and ankle, each relative to the one before.
        let thigh = limb.upper * at_rest.conjugate();
        let shin = limb.lower * at_rest.conjugate();
        let mut models = [
            DualQuat::from_rotation_translation(thigh, hip),
            DualQuat::from_rotation_translation(thigh.conjugate() * shin, [0.0, -LEG[0], 0.0]),
            DualQuat::from_translation([0.0, -LEG[1], 0.0]),
        ];
        leg.job().local_to_model_in_place(&mut models)?;
        let missed = models[2].distance_to(DualQuat::from_translation(ankle));
        println!(
            "| {ankle:?} | {:?} | {:.1} | {:.1e} | {missed:.1e} |",
            limb.span,
            limb.bend.to_degrees(),
            limb.missed
        );
    }
    Ok(())
}

/// Eleven hinges from the pelvis to the left palm: three each at waist, ribs and shoulder, elbow, wrist.
fn palm() -> Result<OwnedReach<f64>, Box<dyn Error>> {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let hinge = |axis, through, limits: [f64; 2]| {
        let axis = Line::from_point_direction(through, axis);
        (Screw { axis, angle: 1.0, slide: 0.0 }, limits.map(f64::to_radians))
    };
    let joints = [
        hinge(y, WAIST, [-25.0, 25.0]),
        hinge(z, WAIST, [-15.0, 15.0]),
        hinge(x, WAIST, [-15.0, 40.0]),
        hinge(y, RIBS, [-25.0, 25.0]),
        hinge(z, RIBS, [-15.0, 15.0]),
        hinge(x, RIBS, [-15.0, 30.0]),
        hinge(y, SHOULDER, [-90.0, 90.0]),
        hinge(z, SHOULDER, [-30.0, 170.0]),
        hinge(x, SHOULDER, [-180.0, 50.0]),
        hinge(x, ELBOW, [-150.0, 0.0]),
        hinge(x, WRIST, [-70.0, 70.0]),
    ];
    let arm = OwnedMechanism::from_screws(&joints, DualQuat::from_translation(PALM))?;
    Ok(OwnedReach::new(arm, [Goal::pose(joints.len())])?)
}

/// The left palm at things around, the arm hanging down to begin with.
fn hand() -> Result<(), Box<dyn Error>> {
    let arm = palm()?;
    let arm = arm.view();
    let mut scratch = vec![0.0; arm.scratch_len()];
    let pelvis = DualQuat::from_translation(PELVIS);
    println!(
        "| palm | pitch, degrees | outcome | iterations | restarts | left, degrees | left, m |"
    );
    println!("|---|---|---|---|---|---|---|");
    for (palm, pitch) in [
        ([0.20, 0.80, 0.05], -10.0),
        ([0.20, 1.10, 0.45], -90.0),
        ([0.00, 1.30, 0.40], -110.0),
        ([0.30, 1.85, 0.10], -170.0),
        ([0.25, 0.60, 0.45], -60.0),
        ([0.20, 1.10, -0.45], 90.0),
        ([0.30, 2.90, 0.10], -170.0),
    ] {
        let turn = Quat::from_axis_angle([1.0, 0.0, 0.0], f64::to_radians(pitch));
        let target = DualQuat::from_rotation_translation(turn, palm);
        let mut angles = [0.0; 11];
        let from_pelvis = [pelvis.conjugate() * target];
        let report = arm.solve(&from_pelvis, &mut angles, &mut scratch, &Options::default())?;
        let there = pelvis * arm.mechanism().link_pose(&angles, angles.len())?;
        println!(
            "| {palm:?} | {pitch} | {:?} | {} | {} | {:.1e} | {:.1e} |",
            report.outcome,
            report.iterations,
            report.restarts,
            there.angle_to(target).to_degrees(),
            there.distance_to(target)
        );
    }
    Ok(())
}
