//! The motion of a person on a humanoid: a clip of motion capture and a robot file become joint
//! values for each frame.
//!
//! ```text
//! cargo run --release --example retarget -- \
//!   ROBOT.urdf CLIP.bvh [--map FILE] [--fps HZ] [--rest FRAME] [--ankle METRES] [--smooth HZ] \
//!   [--speed RAD/S] [--csv OUT] [--svg OUT] [--html OUT] [--targets OUT]
//! ```
//!
//! The crate `dq8-retarget` does the work. The program prints the roles of links and joints, the
//! measures of the motion, and how long searches take.

mod goals;
mod page;
mod picture;
mod track;

use dq8_retarget::{Humanoid, Person, RetargetError, Role, Settings, Speeds, Targets, retarget};
use mocap::command::{self, Request, files, print, read};
use mocap::{output, svg};
use std::error::Error;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::str::FromStr;

const USAGE: &str = "\
usage: retarget ROBOT.urdf CLIP.bvh [--map FILE] [--fps HZ] [--rest FRAME] [--ankle METRES] [--smooth HZ]
                [--speed RAD/S] [--csv OUT] [--svg OUT] [--html OUT] [--targets OUT]

  --map FILE      a table of TOML that gives roles to links and joints, where names and the shape do not:
                    [links]
                    left_hip = { link = \"thigh\", centre = \"hip_roll\" }
                    [joints]
                    left_hip = \"LeftUpLeg\"
  --fps HZ        frames per second that are solved, 30 by default; frames between those of the clip
                  are interpolated
  --rest FRAME    a frame in which the person stands, counted from 0; by default the pose with all
                  channels zero, or the first frame in which the person stands
  --ankle METRES  the height of the robot's ankles above its soles; by default that of the collision
                  shapes of the feet
  --smooth HZ     the frequency that passes over the whole motion halve, 4 by default; with 0 nothing
                  is smoothed
  --speed RAD/S   the greatest speed of all joints; with `file` that of each joint in the robot's file
  --csv OUT       write the joint values, one row per frame
  --svg OUT       draw the clip and the robot at several moments, with soles and contacts
  --html OUT      write a page that plays the clip and the robot, with the measures
  --targets OUT   write the goals of the search and their targets as JSON, for other programs
";

#[derive(Debug, PartialEq)]
struct Args {
    robot: PathBuf,
    clip: PathBuf,
    map: Option<PathBuf>,
    settings: Settings,
    csv: Option<PathBuf>,
    svg: Option<PathBuf>,
    html: Option<PathBuf>,
    targets: Option<PathBuf>,
}

fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Request<Args>, String> {
    let options = [
        "--map",
        "--fps",
        "--rest",
        "--ankle",
        "--smooth",
        "--speed",
        "--csv",
        "--svg",
        "--html",
        "--targets",
    ];
    read(
        words,
        options,
        |[map, fps, rest, ankle, smooth, speed, csv, svg, html, targets], others| {
            let [robot, clip] = <[PathBuf; 2]>::try_from(files(others)?)
                .map_err(|files| format!("two files are needed, and {} given", files.len()))?;
            let positive = |number: &f64| *number > 0.0 && number.is_finite();
            let own = Settings::default();
            let smooth = number("--smooth", smooth, |hz| *hz == 0.0 || positive(hz))?;
            let settings = Settings {
                fps: number("--fps", fps, positive)?.unwrap_or(own.fps),
                rest: number("--rest", rest, |_| true)?,
                ankle: number("--ankle", ankle, |height: &f64| height.is_finite())?,
                smooth: smooth.map_or(own.smooth, |hz| Some(hz).filter(positive)),
                speeds: match speed {
                    Some(word) if word.as_os_str() == "file" => Speeds::File,
                    speed => number("--speed", speed, positive)?.map_or(own.speeds, Speeds::AtMost),
                },
                ..own
            };
            Ok(Args { robot, clip, map, settings, csv, svg, html, targets })
        },
    )
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
    let file = |path: &Path| {
        std::fs::read(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
    };
    let table = args.map.as_ref().map(|path| {
        String::from_utf8(file(path)?)
            .map_err(|error| format!("{} is not text: {error}", path.display()))
    });
    let table = table.transpose()?;
    let humanoid = Humanoid::from_bytes(&file(&args.robot)?, table.as_deref())?;
    let mut person = Person::from_clip(&mocap::load(&args.clip)?)?;
    if let Some(table) = &table {
        person = person.with_table(table)?;
    }
    let motion = retarget(&person, &humanoid, &args.settings).map_err(|error| match error {
        RetargetError::NoRest => format!("{error} (--rest FRAME)").into(),
        error => Box::<dyn Error>::from(error),
    })?;
    print(&heading(&person, &humanoid, &motion.told))?;
    print(&motion.report.to_string())?;
    print(&track::table(&person, &humanoid, &args.settings)?)?;
    for warning in motion.report.warnings() {
        eprintln!("retarget: warning: {warning} (--map, --rest)");
    }

    let mut texts: Vec<(&Path, Vec<u8>)> = Vec::new();
    if let Some(path) = &args.csv {
        texts.push((path, csv(&humanoid, &motion.values, motion.step)?.into()));
    }
    let targets = || Targets::new(&person, &humanoid, &args.settings);
    if let Some(path) = &args.targets {
        texts.push((path, goals::json(&person, &humanoid, &targets()?, &motion)?.into()));
    }
    if args.svg.is_some() || args.html.is_some() {
        let figures = picture::figures(&person, &humanoid, &targets()?, &motion)?;
        if let Some(path) = &args.svg {
            texts.push((path, svg::rows(&figures)?.into()));
        }
        if let Some(path) = &args.html {
            let title = format!("{} on {}", person.title(), humanoid.robot().name());
            texts.push((path, page::html(&title, &figures, &motion.report).into()));
        }
    }
    output::write(&texts, Some(&args.clip))
}

/// The lines that say which links follow which joints.
fn heading(person: &Person, humanoid: &Humanoid, told: &[String]) -> String {
    let mut text = format!("{} on {humanoid}", person.title());
    for sentence in told {
        text += &format!("  {sentence}\n");
    }
    for role in Role::ALL.into_iter().filter(|&role| person.joint(role).is_none()) {
        text += &format!("  {:<15} not found on the person\n", role.name());
    }
    text
}

/// A row for each frame.
fn csv(humanoid: &Humanoid, values: &[f64], step: f64) -> Result<String, std::fmt::Error> {
    let names = humanoid.robot().value_names();
    let mut text = format!("time,{}\n", names.join(","));
    for (frame, values) in values.chunks_exact(names.len()).enumerate() {
        write!(text, "{:.6}", frame as f64 * step)?;
        for value in values {
            write!(text, ",{value:.6}")?;
        }
        text.push('\n');
    }
    Ok(text)
}

#[cfg(test)]
mod tests;
