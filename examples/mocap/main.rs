//! Forward kinematics of a motion-capture clip: all frames at once, eight at a time, and what that
//! is worth.
//!
//! ```text
//! cargo run --release --example mocap                                    # an embedded biped
//! cargo run --release --example mocap -- walk.bvh --csv walk.csv --svg walk.svg
//! cargo run --release --example mocap -- walk.bvh --instances 20         # more frames, for timing
//! ```
//!
//! A clip (`clip`) comes from the biped (`biped`) or a file (`bvh`); `contest` concatenates it by
//! lanes, by both scalars and by matrices; `table`, `csv` and `svg` show the result.

mod args;
mod biped;
mod bvh;
mod clip;
mod command;
mod contest;
mod csv;
mod matrix;
mod output;
mod stopwatch;
mod svg;
mod table;

use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

use args::Args;
use clip::Clip;
use command::print;
use output::Outputs;

fn main() -> ExitCode {
    command::execute("mocap", args::USAGE, args::parse, run)
}

fn run(args: &Args) -> Result<(), Box<dyn Error>> {
    let clip = match &args.clip {
        Some(path) => load(path)?,
        None => biped::clip(),
    };
    let contest = contest::run(&clip, args.instances)?;
    print(&table::text(&clip, args.instances, &contest)?)?;
    contest.check()?;

    let (mut paths, mut texts): (Vec<&Path>, _) = (Vec::new(), Vec::new());
    if let Some(path) = &args.csv {
        paths.push(path);
        texts.push(csv::table(&clip, &contest.positions)?);
    }
    if let Some(path) = &args.svg {
        paths.push(path);
        texts.push(svg::picture(&clip, &contest.positions, contest.size)?);
    }
    Outputs::open(paths.iter().copied(), args.clip.as_deref())?.write(&texts)?;
    for path in paths {
        print(&format!("  wrote {}\n", path.display()))?;
    }
    Ok(())
}

fn load(path: &Path) -> Result<Clip, Box<dyn Error>> {
    let shown = path.display();
    let bytes = fs::read(path).map_err(|error| format!("cannot read {shown}: {error}"))?;
    let title =
        path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    Ok(bvh::parse(title, &bytes).map_err(|error| format!("{shown}, {error}"))?)
}
