//! The searches, timed.

use crate::measure::Quality;
use crate::scene::Scene;
use dq8::{DualQuat, Real, Scalar};
use dq8_robot::ik::{Options, OwnedReach, Report};
use std::error::Error;
use std::time::Instant;

/// So many clips fill all lanes.
const CLIPS: usize = 16;

/// What the clip becomes, and what others come to: a line for each.
pub(crate) fn all(
    scene: &Scene,
    print: &mut dyn FnMut(&str) -> Result<(), Box<dyn Error>>,
) -> Result<Vec<f64>, Box<dyn Error>> {
    print(
        "                                  frames/s  position mean/p95, mm   feet  speed p95, rad/s  jerk, rad/s³  at limits, %\n",
    )?;
    let patient =
        Options { max_iterations: 100, least_gain: 1e-5, damping: 0.0, ..Options::track() };
    let dense = Options {
        tracks: false,
        max_iterations: 1,
        damping: 0.3,
        least_gain: 0.0,
        ..Options::track()
    };
    let (motion, _) = one(scene, &patient)?;
    print(&line(scene, "until nothing is gained", 0.0, &motion)?)?;
    for (name, options) in
        [("one step of second order", dense), ("Options::track()", Options::track())]
    {
        // The best of a few: others use the machine, too.
        let mut best = f64::INFINITY;
        let mut motion = Vec::new();
        for _ in 0..3 {
            let seconds;
            (motion, seconds) = one(scene, &options)?;
            best = best.min(seconds);
        }
        print(&line(scene, name, scene.frames() as f64 / best, &motion)?)?;
        let (motion, seconds) = many::<f64>(scene, &options)?;
        let frames = (CLIPS * scene.frames()) as f64;
        print(&line(scene, "  16 clips, f64 lanes", frames / seconds, &motion)?)?;
        let (motion, seconds) = many::<f32>(scene, &options)?;
        print(&line(scene, "  16 clips, f32 lanes", frames / seconds, &motion)?)?;
    }
    Ok(one(scene, &Options::track())?.0)
}

fn line(scene: &Scene, name: &str, rate: f64, motion: &[f64]) -> Result<String, Box<dyn Error>> {
    let Quality { mean, most, feet, speed, jerk, at_limits, beyond } = Quality::of(scene, motion)?;
    let rate = if rate > 0.0 { format!("{rate:.0}") } else { String::new() };
    let outside =
        if beyond > 1e-6 { format!("  {beyond:.1e} beyond limits") } else { String::new() };
    Ok(format!(
        "  {name:<32}{rate:>8}{mean:>15.1} /{most:>6.1}{feet:>7.1}{speed:>18.2}{jerk:>14.0}{at_limits:>14.1}{outside}\n"
    ))
}

fn problem<R: Real>(scene: &Scene) -> Result<OwnedReach<R>, Box<dyn Error>> {
    let goals: Vec<_> = scene.goals.iter().map(|goal| goal.cast()).collect();
    Ok(OwnedReach::new(scene.robot.cast()?, goals)?)
}

/// One clip, a frame at a time. The first frame takes what it needs.
pub(crate) fn one(
    scene: &Scene,
    options: &Options<f64>,
) -> Result<(Vec<f64>, f64), Box<dyn Error>> {
    let reach = problem::<f64>(scene)?;
    let (reach, mut scratch) = (reach.view(), vec![0.0; reach.view().scratch_len()]);
    let mut values = first(scene)?;
    let mut motion = Vec::with_capacity(values.len() * scene.frames());
    let start = Instant::now();
    for targets in scene.targets.chunks_exact(scene.goals.len()) {
        reach.follow(targets, &mut values, &mut scratch, options)?;
        motion.extend(&values);
    }
    Ok((motion, start.elapsed().as_secs_f64()))
}

/// Where the first frame is reached.
fn first(scene: &Scene) -> Result<Vec<f64>, Box<dyn Error>> {
    let (mut reach, mut values) = (problem::<f64>(scene)?, scene.start.clone());
    let options = Options { max_iterations: 100, least_gain: 1e-5, ..Options::track() };
    reach.solve(&scene.targets[..scene.goals.len()], &mut values, &options)?;
    Ok(values)
}

/// Clips at a time, as they are in an archive. The motion of the first.
fn many<R: Scalar>(
    scene: &Scene,
    options: &Options<f64>,
) -> Result<(Vec<f64>, f64), Box<dyn Error>> {
    let reach = problem::<R>(scene)?;
    let count = reach.view().mechanism().values();
    let cast = |number: f64| <R as Real>::from_f64(number);
    let targets: Vec<DualQuat<R>> = scene
        .targets
        .iter()
        .map(|target| DualQuat::from_array(target.to_array().map(cast)))
        .collect();
    let targets = targets.repeat(CLIPS);
    let frames = scene.frames();
    let mut values = vec![R::ZERO; CLIPS * frames * count];
    for clip in values.chunks_exact_mut(frames * count) {
        for (value, number) in clip.iter_mut().zip(first(scene)?) {
            *value = cast(number);
        }
    }
    let (mut reports, mut best) = (vec![Report::default(); CLIPS * frames], f64::INFINITY);
    for _ in 0..3 {
        let start = Instant::now();
        let job = reach.job();
        job.sequence(&[frames; CLIPS], &targets, &mut values, &mut reports, &options.cast())?;
        best = best.min(start.elapsed().as_secs_f64());
        let keep = first(scene)?;
        for clip in values.chunks_exact_mut(frames * count).skip(1) {
            clip.iter_mut().zip(&keep).for_each(|(value, number)| *value = cast(*number));
        }
    }
    Ok((values[..frames * count].iter().map(|&value| value.into()).collect(), best))
}
