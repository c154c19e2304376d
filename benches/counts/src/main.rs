//! The jobs of `compare` and of `mechanism` on data that fit the first cache, for a program that
//! counts instructions: `scripts/count_arm.py` runs it under an emulator.
//!
//! ```text
//! counts          # the names of all rows
//! counts ROW      # who does the job, and how many transforms a pass has
//! ```
//!
//! Each contender of a row does one pass, and then eight, with a call of [`mark`] before, between
//! and after. The difference is seven passes and nothing else: data are made before the first call,
//! and what a job does before its passes it does twice.

mod robots;
mod rows;

use std::hint::black_box;
use std::process::ExitCode;

/// Passes of the short run and of the long one. Jobs in place restore their input after eight.
const PASSES: [u32; 2] = [1, 8];

/// The place that the emulator looks for. It has a symbol, because it is not inlined.
#[inline(never)]
fn mark() {
    black_box(());
}

/// One contender: a line, and both runs.
fn count(name: &str, transforms: usize, mut run: impl FnMut(u32)) {
    println!("{name}\t{transforms}");
    // What is allocated or found out once.
    run(1);
    for passes in PASSES {
        mark();
        run(passes);
    }
    mark();
}

fn main() -> ExitCode {
    let Some(row) = std::env::args().nth(1) else {
        for (name, _) in rows::rows() {
            println!("{name}");
        }
        for name in robots::ROWS {
            println!("{name}");
        }
        return ExitCode::SUCCESS;
    };
    if robots::ROWS.contains(&row.as_str()) {
        robots::count_all(&row);
        return ExitCode::SUCCESS;
    }
    let Some((_, task)) = rows::rows().into_iter().find(|(name, _)| *name == row) else {
        eprintln!("no such row: {row}");
        return ExitCode::FAILURE;
    };
    rows::count_all(&task);
    ExitCode::SUCCESS
}
