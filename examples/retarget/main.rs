//! The motion of a person on a humanoid: a clip of motion capture and a robot file become joint
//! values for each frame.
//!
//! ```text
//! cargo run --release --example retarget -- \
//!   ROBOT.urdf CLIP.bvh [--map FILE] [--fps HZ] [--rest FRAME] [--ankle METRES] \
//!   [--csv OUT] [--svg OUT]
//! ```
//!
//! The pose of the clip that stands for the robot's own is found (`rest`). The robot stands with
//! its soles at height zero (`ground`). Limbs keep the directions that they have in the clip and
//! the lengths that they have on the robot, whose base floats. Links and joints are found by common
//! names, or named in FILE, a line for each: `ROLE LINK[@CENTRE] JOINT`, where CENTRE is the link
//! whose origin is the joint, if it is another than LINK's own.

mod ground;
mod map;
mod measure;
mod picture;
mod rest;
mod scene;
mod track;

use dq8_robot::JointKind;
use dq8_robot::urdf::{ChangeError, Robot};
use measure::Quality;
use mocap::command::{self, Request, files, print, read};
use mocap::output;
use scene::{Scene, Wishes};
use std::error::Error;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::str::FromStr;

const USAGE: &str = "\
usage: retarget ROBOT.urdf CLIP.bvh [--map FILE] [--fps HZ] [--rest FRAME] [--ankle METRES] [--csv OUT] [--svg OUT]

  --map FILE      which links follow which joints, a line for each: ROLE LINK[@CENTRE] JOINT
  --fps HZ        frames per second that are solved, 30 by default; frames between those of the clip
                  are interpolated
  --rest FRAME    a frame in which the person stands, counted from 0; by default the pose with all
                  channels zero, or the first frame in which the person stands
  --ankle METRES  the height of the robot's ankles above its soles; by default that of the collision
                  shapes of the feet
  --csv OUT       write the joint values, one row per frame
  --svg OUT       draw the clip and the robot at several moments
";

#[derive(Debug, PartialEq)]
struct Args {
    robot: PathBuf,
    clip: PathBuf,
    map: Option<PathBuf>,
    fps: f64,
    rest: Option<usize>,
    ankle: Option<f64>,
    csv: Option<PathBuf>,
    svg: Option<PathBuf>,
}

fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Request<Args>, String> {
    let options = ["--map", "--fps", "--rest", "--ankle", "--csv", "--svg"];
    read(words, options, |[map, fps, rest, ankle, csv, svg], others| {
        let [robot, clip] = <[PathBuf; 2]>::try_from(files(others)?)
            .map_err(|files| format!("two files are needed, and {} given", files.len()))?;
        let fps = number("--fps", fps, |fps: &f64| *fps > 0.0 && fps.is_finite())?.unwrap_or(30.0);
        let rest = number("--rest", rest, |_| true)?;
        let ankle = number("--ankle", ankle, |height: &f64| height.is_finite())?;
        Ok(Args { robot, clip, map, fps, rest, ankle, csv, svg })
    })
}

/// The number that an option is followed by, if the option is there.
fn number<T: FromStr>(
    option: &str,
    text: Option<PathBuf>,
    fits: impl Fn(&T) -> bool,
) -> Result<Option<T>, String> {
    let Some(text) = text else { return Ok(None) };
    let text = text.to_string_lossy();
    match text.parse().ok().filter(fits) {
        Some(number) => Ok(Some(number)),
        None => Err(format!("{option} cannot be {text:?}")),
    }
}

fn main() -> ExitCode {
    command::execute("retarget", USAGE, parse, run)
}

fn run(args: &Args) -> Result<(), Box<dyn Error>> {
    let urdf = std::fs::read(&args.robot)
        .map_err(|error| format!("cannot read {}: {error}", args.robot.display()))?;
    let robot = with_floating_base(Robot::from_bytes(&urdf)?)?;
    let clip = mocap::load(&args.clip)?;
    let text = args.map.as_ref().map(|path| {
        std::fs::read_to_string(path)
            .map_err(|error| format!("cannot read {}: {error}", path.display()))
    });
    let places = match text.transpose()? {
        Some(text) => map::read(&text, &robot, &clip)?,
        None => map::found(&robot, &clip)?,
    };
    // Shapes of collisions are read from UTF-8 text alone.
    let wishes = Wishes {
        fps: args.fps,
        rest: args.rest,
        ankle: args.ankle,
        urdf: std::str::from_utf8(&urdf).unwrap_or_default(),
    };
    let scene = Scene::new(robot, clip, places, wishes)?;
    print(&scene.text())?;
    let motion = track::all(&scene)?;
    for warning in Quality::of(&scene, &motion)?.warnings() {
        eprintln!("retarget: warning: {warning}");
    }

    let mut texts: Vec<(&Path, Vec<u8>)> = Vec::new();
    if let Some(path) = &args.csv {
        texts.push((path, table(&scene, &motion)?.into()));
    }
    if let Some(path) = &args.svg {
        texts.push((path, picture::draw(&scene, &motion)?.into()));
    }
    output::write(&texts, Some(&args.clip))
}

/// Returns the robot with a base that moves freely: as it is, if a floating joint of the file
/// carries all other links that move, and otherwise with one that carries the root.
fn with_floating_base(robot: Robot) -> Result<Robot, ChangeError> {
    let moves = robot.joints().iter().find(|joint| joint.kind != JointKind::Fixed);
    if moves.is_some_and(|joint| joint.kind == JointKind::Floating) {
        return Ok(robot);
    }
    robot.floating()
}

/// A row for each frame.
fn table(scene: &Scene, motion: &[f64]) -> Result<String, std::fmt::Error> {
    let names = scene.robot.value_names();
    let mut text = format!("time,{}\n", names.join(","));
    for (frame, values) in motion.chunks_exact(names.len()).enumerate() {
        write!(text, "{:.6}", frame as f64 * scene.step)?;
        for value in values {
            write!(text, ",{value:.6}")?;
        }
        text.push('\n');
    }
    Ok(text)
}

#[cfg(test)]
mod tests;
