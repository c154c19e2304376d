//! The searches, timed: what each of them costs and gives.

use dq8::{DualQuat, Real, Scalar};
use dq8_retarget::{Humanoid, Person, Report, Settings, Targets};
use dq8_robot::ik::{self, Goal, Options, OwnedReach, Tracking};
use std::error::Error;
use std::time::Instant;

/// So many clips fill all lanes.
const CLIPS: usize = 16;

/// The best of so many: others use the machine, too.
const RUNS: usize = 7;

/// A line for each search: of targets as the person gives them, and of the whole pipeline.
pub(crate) fn table(
    person: &Person,
    humanoid: &Humanoid,
    settings: &Settings,
) -> Result<String, Box<dyn Error>> {
    let plain = Settings { feet: false, smooth: None, collide: false, ..*settings };
    let targets = Targets::new(person, humanoid, &plain)?;
    let mut text = format!(
        "  {:<32}{:>8}{:>18}{:>7}{:>7}{:>6}{:>13}{:>15}{:>13}\n",
        "",
        "frames/s",
        "mm, mean / p95",
        "feet",
        "slide",
        "sink",
        "rad/s, p95",
        "jerk, rad/s³",
        "% at limits"
    );
    let mut line = |name: &str, (motion, rate): (Vec<f64>, f64)| -> Result<(), Box<dyn Error>> {
        text += &row(name, rate, &Report::of(&targets, humanoid, &motion)?);
        Ok(())
    };
    let (motion, _) = one(&targets, humanoid, &targets.converging(), true, 1)?;
    line("until a step gains nothing", (motion, 0.0))?;
    let step = Options { max_iterations: 1, damping: 0.3, restarts: false, ..Options::default() };
    for (name, options, tracks) in [
        ("a damped step of second order", step.into(), false),
        ("tracking", targets.tracking(), true),
    ] {
        line(name, one(&targets, humanoid, &options, tracks, RUNS)?)?;
        line("  16 clips, f64 lanes", many::<f64>(&targets, humanoid, &options, tracks)?)?;
        line("  16 clips, f32 lanes", many::<f32>(&targets, humanoid, &options, tracks)?)?;
    }
    let (mut best, mut report) = (f64::INFINITY, None);
    for _ in 0..RUNS {
        let clock = Instant::now();
        let targets = Targets::new(person, humanoid, settings)?;
        let values = targets.solve(humanoid, settings)?;
        best = best.min(clock.elapsed().as_secs_f64());
        report = Some((Report::of(&targets, humanoid, &values)?, targets.frames()));
    }
    if let Some((report, frames)) = report {
        text += &row("all: targets, feet, passes", frames as f64 / best, &report);
    }
    Ok(text)
}

fn row(name: &str, rate: f64, report: &Report) -> String {
    let Report {
        residual, residual_high, feet, slide, sink, speed, jerk, at_limits, beyond, ..
    } = report;
    let rate = if rate > 0.0 { format!("{rate:.0}") } else { String::new() };
    let outside =
        if *beyond > 1e-6 { format!("  {beyond:.1e} beyond limits") } else { String::new() };
    format!(
        "  {name:<32}{rate:>8}{residual:>10.1} /{residual_high:>6.1}{feet:>7.1}{slide:>7.0}{sink:>6.0}{speed:>13.2}{jerk:>15.0}\
         {at_limits:>13.1}{outside}\n"
    )
}

fn problem<R: Real>(
    targets: &Targets,
    humanoid: &Humanoid,
    options: &Tracking<f64>,
) -> Result<OwnedReach<R>, Box<dyn Error>> {
    let goals: Vec<_> = targets.goals.iter().map(Goal::cast).collect();
    let reach = OwnedReach::new(humanoid.robot().cast()?, goals)?;
    if options.posture_weight == 0.0 {
        return Ok(reach);
    }
    Ok(reach.with_posture(cast::<R>(&targets.start))?)
}

fn cast<R: Real>(numbers: &[f64]) -> Vec<R> {
    numbers.iter().map(|&number| R::from_f64(number)).collect()
}

/// One clip, a frame at a time, and frames per second.
pub(crate) fn one(
    targets: &Targets,
    humanoid: &Humanoid,
    options: &Tracking<f64>,
    tracks: bool,
    runs: usize,
) -> Result<(Vec<f64>, f64), Box<dyn Error>> {
    let reach = problem::<f64>(targets, humanoid, options)?;
    let (reach, mut scratch) = (reach.view(), vec![0.0; reach.view().scratch_len()]);
    let start = targets.first(humanoid)?;
    let (mut motion, mut best) = (Vec::new(), f64::INFINITY);
    for _ in 0..runs {
        let mut values = start.clone();
        motion.clear();
        let clock = Instant::now();
        for targets in targets.poses.chunks_exact(targets.goals.len()) {
            if tracks {
                reach.track(targets, &mut values, &mut scratch, options)?;
            } else {
                reach.follow(targets, &mut values, &mut scratch, &options.options)?;
            }
            motion.extend(&values);
        }
        best = best.min(clock.elapsed().as_secs_f64());
    }
    Ok((motion, targets.frames() as f64 / best))
}

/// Clips at a time, as they are in an archive: the motion of the first, and frames per second of
/// all.
pub(crate) fn many<R: Scalar>(
    targets: &Targets,
    humanoid: &Humanoid,
    options: &Tracking<f64>,
    tracks: bool,
) -> Result<(Vec<f64>, f64), Box<dyn Error>> {
    let reach = problem::<R>(targets, humanoid, options)?;
    let (frames, goals) = (targets.frames(), targets.goals.len());
    let start = cast::<R>(&targets.first(humanoid)?);
    let numbers = targets.poses.iter().map(|target| target.to_array().map(<R as Real>::from_f64));
    let targets: Vec<_> = numbers.map(DualQuat::from_array).collect();
    let (all, options) = (targets.repeat(CLIPS), options.cast());
    let in_step: Vec<_> = targets.chunks_exact(goals).map(|frame| frame.repeat(CLIPS)).collect();
    let mut values = start.repeat(CLIPS * frames);
    let mut reports = vec![ik::Report::default(); CLIPS * frames];
    let mut best = f64::INFINITY;
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
