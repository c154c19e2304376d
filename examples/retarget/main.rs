//! The motion of a person on a humanoid: a clip of motion capture and a robot file become joint
//! values for each frame.
//!
//! ```text
//! cargo run --release --example retarget -- \
//!   ROBOT.urdf CLIP.bvh [--map FILE] [--rate HZ] [--csv OUT] [--svg OUT]
//! ```
//!
//! Limbs keep the directions that they have in the clip and the lengths that they have on the
//! robot, whose base floats. Links and joints are found by common names, or named in FILE, a line
//! for each: `ROLE LINK[@CENTRE] JOINT`, where CENTRE is the link whose origin is the joint, if it
//! is another than LINK's own.

mod map;
mod measure;
mod picture;
mod scene;
mod track;

use dq8_robot::urdf::Robot;
use mocap::command::{self, Request, files, print, read};
use mocap::output;
use scene::Scene;
use std::error::Error;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "\
usage: retarget ROBOT.urdf CLIP.bvh [--map FILE] [--rate HZ] [--csv OUT] [--svg OUT]

  --map FILE  which links follow which joints, a line for each: ROLE LINK[@CENTRE] JOINT
  --rate HZ   frames per second that are solved, 30 unless said
  --csv OUT   write the joint values, one row per frame
  --svg OUT   draw the clip and the robot at several moments
";

#[derive(Debug, PartialEq)]
struct Args {
    robot: PathBuf,
    clip: PathBuf,
    map: Option<PathBuf>,
    rate: f64,
    csv: Option<PathBuf>,
    svg: Option<PathBuf>,
}

fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Request<Args>, String> {
    read(words, ["--map", "--rate", "--csv", "--svg"], |[map, rate, csv, svg], others| {
        let [robot, clip] = <[PathBuf; 2]>::try_from(files(others)?)
            .map_err(|files| format!("two files are needed, and {} given", files.len()))?;
        let text = rate.as_deref().map_or("30".into(), Path::to_string_lossy);
        let rate = text.parse().ok().filter(|rate: &f64| *rate > 0.0 && rate.is_finite());
        let rate = rate.ok_or_else(|| format!("--rate is no rate: {text:?}"))?;
        Ok(Args { robot, clip, map, rate, csv, svg })
    })
}

fn main() -> ExitCode {
    command::execute("retarget", USAGE, parse, run)
}

fn run(args: &Args) -> Result<(), Box<dyn Error>> {
    let robot = Robot::from_file(&args.robot)?.floating()?;
    let clip = mocap::load(&args.clip)?;
    let text = args.map.as_ref().map(|path| {
        std::fs::read_to_string(path)
            .map_err(|error| format!("cannot read {}: {error}", path.display()))
    });
    let places = match text.transpose()? {
        Some(text) => map::read(&text, &robot, &clip)?,
        None => map::found(&robot, &clip)?,
    };
    let scene = Scene::new(robot, clip, places, args.rate)?;
    print(&scene.text())?;
    let motion = track::all(&scene)?;

    let mut texts: Vec<(&Path, Vec<u8>)> = Vec::new();
    if let Some(path) = &args.csv {
        texts.push((path, table(&scene, &motion)?.into()));
    }
    if let Some(path) = &args.svg {
        texts.push((path, picture::draw(&scene, &motion)?.into()));
    }
    output::write(&texts, Some(&args.clip))
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
