//! The motion of a person on a humanoid: a clip of motion capture and a robot file become joint values for each frame.
//!
//! ```text
//! cargo run --release --example retarget -- ROBOT.urdf CLIP.bvh [--map FILE] [--rate HZ] [--csv OUT] [--svg OUT]
//! ```
//!
//! Limbs keep the directions that they have in the clip and the lengths that they have on the robot, whose base floats.
//! Links and joints are found by common names, or named in FILE, a line for each: `ROLE LINK[@CENTRE] JOINT`, where CENTRE
//! is the link whose origin is the joint, if it is another than LINK's own.

mod map;
mod measure;
mod picture;
mod scene;
mod track;

use dq8_robot::urdf::Robot;
use mocap::command::{self, Misuse, Request, print, set, value};
use mocap::output::Outputs;
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

fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Request<Args>, Misuse> {
    let (mut files, mut map, mut rate) = (Vec::new(), None, None);
    let (mut csv, mut svg) = (None, None);
    let mut words = words.into_iter();
    while let Some(word) = words.next() {
        match word.to_string_lossy().as_ref() {
            "-h" | "--help" => return Ok(Request::Help),
            "--map" => set(&mut map, "--map", value("--map", &mut words)?.into())?,
            "--csv" => set(&mut csv, "--csv", value("--csv", &mut words)?.into())?,
            "--svg" => set(&mut svg, "--svg", value("--svg", &mut words)?.into())?,
            "--rate" => {
                let text = value("--rate", &mut words)?;
                let number = text.to_string_lossy().parse().ok();
                let number = number.filter(|rate: &f64| *rate > 0.0 && rate.is_finite());
                let number = number.ok_or(Misuse(format!("--rate is no rate: {text:?}")))?;
                set(&mut rate, "--rate", number)?;
            }
            option if option.starts_with('-') => {
                return Err(Misuse(format!("no such option: `{option}`")));
            }
            _ => files.push(PathBuf::from(word)),
        }
    }
    let [robot, clip] = <[PathBuf; 2]>::try_from(files)
        .map_err(|files| Misuse(format!("two files are needed, and {} given", files.len())))?;
    Ok(Request::Run(Args { robot, clip, map, rate: rate.unwrap_or(30.0), csv, svg }))
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

    let (mut paths, mut texts): (Vec<&Path>, Vec<String>) = Default::default();
    if let Some(path) = &args.csv {
        paths.push(path);
        texts.push(table(&scene, &motion)?);
    }
    if let Some(path) = &args.svg {
        paths.push(path);
        texts.push(picture::draw(&scene, &motion)?);
    }
    Outputs::open(paths.iter().copied(), Some(&args.clip))?.write(&texts)?;
    for path in paths {
        print(&format!("  wrote {}\n", path.display()))?;
    }
    Ok(())
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
