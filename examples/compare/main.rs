//! The side-by-side run: this crate and its peers at the same jobs on the same data, in turns, and
//! what the machine could do at most.
//!
//! ```text
//! cargo run --release --example compare -- --quick
//! cargo run --release --example compare -- --json times.json --svg times.svg
//! ```
//!
//! | job | what every contender does |
//! |---|---|
//! | J1 | products of two slices, pair by pair |
//! | J2 | crowds of 64 joints, local poses to model poses |
//! | J3 | the same for one skeleton, one biped, one chain |
//! | J4 | points by one motion, or each by its own |
//! | J5 | normalizing, linear blending, screw interpolation |
//!
//! A `task` makes the data of a `contest`, a `race` checks every contender against `f64` and times
//! them in interleaved rounds; `memory` is how each of them holds motions and points. `table`, `json`
//! and `chart` show the `results`. The least time over the rounds is what counts: whatever else a
//! machine does only adds to it.

mod args;
mod caches;
mod chart;
#[path = "../mocap/command.rs"]
mod command;
mod contest;
mod json;
mod limit;
mod memory;
#[path = "../mocap/output.rs"]
mod output;
mod progress;
mod race;
#[path = "../../benches/representation/mod.rs"]
mod representation;
mod results;
#[path = "../../benches/rows/mod.rs"]
mod rows;
#[path = "../../benches/hierarchy/skeleton.rs"]
mod skeleton;
mod table;
mod task;
#[path = "../../benches/walk/mod.rs"]
mod walk;

use args::Args;
use caches::Caches;
use command::print;
use output::Outputs;
use progress::Progress;
use race::{Effort, race};
use results::Results;
use std::error::Error;
use std::process::ExitCode;
use std::time::Duration;

const QUICK: Effort =
    Effort { budget: Duration::from_millis(700), fewest_rounds: 1, most_rounds: 20 };
const WHOLE: Effort = Effort { budget: Duration::from_secs(7), fewest_rounds: 3, most_rounds: 60 };

fn main() -> ExitCode {
    command::execute("compare", args::USAGE, args::parse, run)
}

fn run(args: &Args) -> Result<(), Box<dyn Error>> {
    let paths = || args.json.iter().chain(&args.svg).map(|path| path.as_path());
    // Minutes before they are needed: a path that cannot be written is better known now.
    let outputs = Outputs::open(paths(), None)?;
    let caches = Caches::of_this_machine();
    let tasks = task::plan(args.quick);
    let effort = if args.quick { QUICK } else { WHOLE };
    let (mut results, mut progress) = (Results::default(), Progress::new(tasks.len()));
    for task in &tasks {
        progress.next();
        task.with_contest(&caches, |contest| race(contest, effort, &mut progress, &mut results))?;
    }
    progress.finish();
    print(&table::text(&results)?)?;

    let mut texts = Vec::new();
    if args.json.is_some() {
        texts.push(json::text(&results));
    }
    if args.svg.is_some() {
        texts.push(chart::picture(&results)?);
    }
    outputs.write(&texts)?;
    for path in paths() {
        print(&format!("wrote {}\n", path.display()))?;
    }
    Ok(())
}
