//! The side-by-side run: this crate and its peers at the same jobs on the same data, in turns, and
//! what the machine could do at most.
//!
//! ```text
//! cargo run --release --example compare -- --quick
//! cargo run --release --example compare -- J6
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
//! | J6 | a frame of a crowd: two clips sampled, blended, to model space, 3×4 matrices |
//! | J7 | skinning with four influences: linear (LBS) and dual quaternion blends (DLB) |
//!
//! The package `dq8-contest` has the jobs, their data and the contenders; `plan` says which, a
//! `race` checks every contender against `f64` and times them in interleaved rounds. `table`,
//! `json`, `chart` and `markdown` show the `results`; `machine` says how disturbed it was, and what
//! is disturbed is timed again. The least time over the rounds is what counts: whatever else a
//! machine does only adds to it.

mod args;
mod best;
mod chart;
mod forms;
mod json;
mod machine;
mod markdown;
mod plan;
mod profile;
mod progress;
mod race;
mod results;
mod table;

use args::Args;
use best::Best;
use dq8_contest::caches::Caches;
use machine::Machine;
use mocap::command::{self, print};
use mocap::output::Outputs;
use progress::Progress;
use race::{Effort, race};
use results::Results;
use std::error::Error;
use std::process::ExitCode;
use std::time::Duration;

const QUICK: Effort =
    Effort { budget: Duration::from_millis(700), fewest_rounds: 1, most_rounds: 20, attempts: 1 };
const WHOLE: Effort =
    Effort { budget: Duration::from_secs(7), fewest_rounds: 3, most_rounds: 60, attempts: 4 };

fn main() -> ExitCode {
    command::execute("compare", args::USAGE, args::parse, run)
}

fn run(args: &Args) -> Result<(), Box<dyn Error>> {
    let paths = || args.json.iter().chain(&args.svg).chain(&args.md).map(|path| path.as_path());
    // Minutes before they are needed: a path that cannot be written is better known now.
    let outputs = Outputs::open(paths(), [])?;
    let caches = Caches::of_this_machine();
    let tasks = plan::plan(args.quick, &args.jobs);
    let effort = if args.quick { QUICK } else { WHOLE };
    let (mut results, mut progress) = (Results::default(), Progress::new(tasks.len()));
    let mut machine = Machine::new();
    for task in &tasks {
        progress.next();
        task.with_contest(&caches, |contest| {
            race(contest, effort, &mut machine, &mut progress, &mut results)
        })?;
        progress.finish();
        // Whoever reads along waits for one contest, not for all.
        if let Some(rows) = results.contests().last().filter(|_| task.job().is_some()) {
            print(&table::contest(&rows, &results.limits)?)?;
        }
    }
    print(&table::limits(&results.limits)?)?;
    print(table::LEGEND)?;

    let mut texts = Vec::new();
    if args.json.is_some() {
        texts.push(json::text(&results));
    }
    if args.svg.is_some() {
        texts.push(chart::picture(&Best::of_all(&results))?);
    }
    if args.md.is_some() {
        texts.push(markdown::text(&results)?);
    }
    outputs.write(&texts)?;
    for path in paths() {
        print(&format!("wrote {}\n", path.display()))?;
    }
    Ok(())
}
