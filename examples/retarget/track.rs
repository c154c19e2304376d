//! The searches, timed.

use crate::measure::Quality;
use crate::scene::Scene;
use dq8::{DualQuat, Real, Scalar};
use dq8_robot::ik::{Goal, Options, OwnedReach, Report, Tracking};
use mocap::command::print;
use std::error::Error;
use std::time::Instant;

/// So many clips fill all lanes.
const CLIPS: usize = 16;

/// How long the robot lags behind, seconds: two milliseconds. The targets are then farther away by
/// less than a fiftieth.
const LAG: f64 = 1.0 / 480.0;

/// The best of so many: others use the machine, too.
const RUNS: usize = 7;

/// What a robot is told: to follow, to stay near the last frame, and what is left free, near the
/// stance. How far it lags behind is the square of that weight times the way in a frame: so the
/// square is for the time of a frame.
pub(crate) fn tracking(scene: &Scene) -> Tracking<f64> {
    let start_weight = (LAG / scene.step).sqrt();
    Tracking { start_weight, posture_weight: 0.02, ..Tracking::default() }
}

/// The same until a step gains nothing, without a start to stay near.
fn converging(scene: &Scene) -> Tracking<f64> {
    let options = Options { max_iterations: 100, least_gain: 1e-5, ..Options::track() };
    Tracking { options, start_weight: 0.0, ..tracking(scene) }
}

/// What the clip becomes, and what others come to: a line for each.
pub(crate) fn all(scene: &Scene) -> Result<Vec<f64>, Box<dyn Error>> {
    print(&format!(
        "  {:<32}{:>8}{:>18}{:>7}{:>13}{:>15}{:>13}\n",
        "", "frames/s", "mm, mean / p95", "feet", "rad/s, p95", "jerk, rad/s³", "% at limits"
    ))?;
    let (motion, _) = one(scene, &converging(scene), true, 1)?;
    print(&line(scene, "until a step gains nothing", 0.0, &motion)?)?;
    let step = Options { max_iterations: 1, damping: 0.3, restarts: false, ..Options::default() };
    let mut answer = Vec::new();
    for (name, options, tracks) in
        [("a damped step of second order", step.into(), false), ("tracking", tracking(scene), true)]
    {
        let (motion, rate) = one(scene, &options, tracks, RUNS)?;
        print(&line(scene, name, rate, &motion)?)?;
        for (name, (motion, rate)) in [
            ("  16 clips, f64 lanes", many::<f64>(scene, &options, tracks)?),
            ("  16 clips, f32 lanes", many::<f32>(scene, &options, tracks)?),
        ] {
            print(&line(scene, name, rate, &motion)?)?;
        }
        answer = motion;
    }
    Ok(answer)
}

fn line(scene: &Scene, name: &str, rate: f64, motion: &[f64]) -> Result<String, Box<dyn Error>> {
    let Quality { mean, most, feet, speed, jerk, at_limits, beyond } = Quality::of(scene, motion)?;
    let rate = if rate > 0.0 { format!("{rate:.0}") } else { String::new() };
    let outside =
        if beyond > 1e-6 { format!("  {beyond:.1e} beyond limits") } else { String::new() };
    Ok(format!(
        "  {name:<32}{rate:>8}{mean:>10.1} /{most:>6.1}{feet:>7.1}{speed:>13.2}{jerk:>15.0}{at_limits:>13.1}{outside}\n"
    ))
}

fn problem<R: Real>(
    scene: &Scene,
    options: &Tracking<f64>,
) -> Result<OwnedReach<R>, Box<dyn Error>> {
    let goals: Vec<_> = scene.goals.iter().map(Goal::cast).collect();
    let reach = OwnedReach::new(scene.robot.cast()?, goals)?;
    if options.posture_weight == 0.0 {
        return Ok(reach);
    }
    Ok(reach.with_posture(cast::<R>(&scene.start))?)
}

fn cast<R: Real>(numbers: &[f64]) -> Vec<R> {
    numbers.iter().map(|&number| R::from_f64(number)).collect()
}

/// One clip, a frame at a time, and frames per second.
pub(crate) fn one(
    scene: &Scene,
    options: &Tracking<f64>,
    tracks: bool,
    runs: usize,
) -> Result<(Vec<f64>, f64), Box<dyn Error>> {
    let reach = problem::<f64>(scene, options)?;
    let (reach, mut scratch) = (reach.view(), vec![0.0; reach.view().scratch_len()]);
    let start = first(scene)?;
    let (mut motion, mut best) = (Vec::new(), f64::INFINITY);
    for _ in 0..runs {
        let mut values = start.clone();
        motion.clear();
        let start = Instant::now();
        for targets in scene.targets.chunks_exact(scene.goals.len()) {
            if tracks {
                reach.track(targets, &mut values, &mut scratch, options)?;
            } else {
                reach.follow(targets, &mut values, &mut scratch, &options.options)?;
            }
            motion.extend(&values);
        }
        best = best.min(start.elapsed().as_secs_f64());
    }
    Ok((motion, scene.frames() as f64 / best))
}

/// Where the first frame is reached.
fn first(scene: &Scene) -> Result<Vec<f64>, Box<dyn Error>> {
    let options = converging(scene);
    let (mut reach, mut values) = (problem::<f64>(scene, &options)?, scene.start.clone());
    reach.track(&scene.targets[..scene.goals.len()], &mut values, &options)?;
    Ok(values)
}

/// Clips at a time, as they are in an archive: the motion of the first, and frames per second of
/// all.
pub(crate) fn many<R: Scalar>(
    scene: &Scene,
    options: &Tracking<f64>,
    tracks: bool,
) -> Result<(Vec<f64>, f64), Box<dyn Error>> {
    let reach = problem::<R>(scene, options)?;
    let (frames, goals, start) = (scene.frames(), scene.goals.len(), cast::<R>(&first(scene)?));
    let numbers = scene.targets.iter().map(|target| target.to_array().map(<R as Real>::from_f64));
    let targets: Vec<_> = numbers.map(DualQuat::from_array).collect();
    let (all, options) = (targets.repeat(CLIPS), options.cast());
    let in_step: Vec<_> = targets.chunks_exact(goals).map(|frame| frame.repeat(CLIPS)).collect();
    let mut values = start.repeat(CLIPS * frames);
    let (mut reports, mut best) = (vec![Report::default(); CLIPS * frames], f64::INFINITY);
    for _ in 0..RUNS {
        for clip in values.chunks_exact_mut(frames * start.len()) {
            clip[..start.len()].copy_from_slice(&start);
        }
        let mut now = start.repeat(CLIPS);
        let clock = Instant::now();
        if tracks {
            reach.job().sequence(&[frames; CLIPS], &all, &mut values, &mut reports, &options)?;
        } else {
            // A call a frame, and all clips in step.
            for (frame, targets) in in_step.iter().enumerate() {
                reach.job().solve(targets, &mut now, &mut reports[..CLIPS], &options.options)?;
                values[frame * start.len()..][..start.len()].copy_from_slice(&now[..start.len()]);
            }
        }
        best = best.min(clock.elapsed().as_secs_f64());
    }
    let motion = values[..frames * start.len()].iter().map(|&value| value.into());
    Ok((motion.collect(), (CLIPS * frames) as f64 / best))
}
