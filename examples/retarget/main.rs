//! The motion of a person on a humanoid: a clip of motion capture and a robot file become joint
//! values for each frame.
//!
//! ```text
//! cargo run --release --example retarget -- \
//!   ROBOT.urdf CLIP.bvh [--map FILE] [--fps HZ] [--rest FRAME] [--ankle METRES] [--smooth HZ] \
//!   [--speed RAD/S] [--csv OUT] [--svg OUT] [--html OUT] [--targets OUT]
//! cargo run --release --example retarget -- \
//!   ROBOT.urdf CLIPS... --out FOLDER [--jobs N] [--map FILE] ...
//! ```
//!
//! The crate `dq8-retarget` does the work. The program prints the roles of links and joints, the
//! measures of the motion, and how long searches take.

mod clips;
mod goals;
mod page;
mod picture;
mod track;

use clips::Clips;
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
       retarget ROBOT.urdf CLIP.bvh|FOLDER... --out FOLDER [--jobs N] [--map FILE] [--fps HZ] [--rest FRAME]
                [--ankle METRES] [--smooth HZ] [--speed RAD/S]

  --out FOLDER    take several clips, or all BVH files of a folder, and write the joint values of each and a
                  table of measures; a clip that fails does not end the others
  --jobs N        the number of clips at once; by default one for each core
  --map FILE      a table of TOML that gives roles to links and joints, where names and the shape do not:
                    [links]
                    left_hip = { link = \"thigh\", centre = \"hip_roll\" }
                    [joints]
                    left_hip = \"LeftUpLeg\"
  --fps HZ        frames per second that are solved, 30 by default; frames between those of the clip
                  are interpolated
  --rest FRAME    a frame in which the person stands, counted from 0; by default the pose with all
                  channels zero, or the mean of the frames in which the person stands
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
    clips: Vec<PathBuf>,
    /// The folder of the results of several clips, and the number of clips at once.
    out: Option<(PathBuf, usize)>,
    map: Option<PathBuf>,
    settings: Settings,
    csv: Option<PathBuf>,
    svg: Option<PathBuf>,
    html: Option<PathBuf>,
    targets: Option<PathBuf>,
}

impl Args {
    /// The files that are read, other than clips: the robot and the table of names.
    fn files(&self) -> impl Iterator<Item = &Path> {
        [Some(&self.robot), self.map.as_ref()].into_iter().flatten().map(|path| path.as_path())
    }
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
        "--out",
        "--jobs",
    ];
    read(
        words,
        options,
        |[map, fps, rest, ankle, smooth, speed, csv, svg, html, targets, out, jobs], others| {
            let mut clips = files(others)?;
            match (clips.len(), &out) {
                (0 | 1, _) => return Err("a robot and a clip are needed".to_owned()),
                (2, _) | (_, Some(_)) => {}
                (given, None) => {
                    return Err(format!("{} clips are given without --out FOLDER", given - 1));
                }
            }
            let robot = clips.remove(0);
            if out.is_some() && [&csv, &svg, &html, &targets].into_iter().any(Option::is_some) {
                return Err(
                    "--csv, --svg, --html and --targets are of one clip without --out".into()
                );
            }
            if jobs.is_some() && out.is_none() {
                return Err("--jobs is of clips with --out FOLDER".to_owned());
            }
            let cores = || std::thread::available_parallelism().map_or(1, usize::from);
            let jobs = number("--jobs", jobs, |jobs| *jobs > 0)?.unwrap_or_else(cores);
            let out = out.map(|folder| (folder, jobs));
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
            Ok(Args { robot, clips, out, map, settings, csv, svg, html, targets })
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
    if let Some((out, jobs)) = &args.out {
        print(&humanoid.to_string())?;
        let (table, settings) = (table.as_deref(), &args.settings);
        let inputs: Vec<_> = args.files().collect();
        return Clips { humanoid: &humanoid, table, settings, out, inputs: &inputs }
            .run(&args.clips, *jobs);
    }
    let clip = &args.clips[0];
    let mut person = Person::from_clip(&mocap::load(clip)?)?;
    if let Some(table) = &table {
        person = person.with_table(table)?;
    }
    let motion = retarget(&person, &humanoid, &args.settings).map_err(hint)?;
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
    output::write(&texts, args.files().chain([clip.as_path()]))
}

/// The error, with the option that helps.
fn hint(error: RetargetError) -> Box<dyn Error> {
    match error {
        RetargetError::NoRest => format!("{error} (--rest FRAME)").into(),
        error => error.into(),
    }
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
