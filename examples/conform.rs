//! Runs reference vectors on every implementation and prints the worst error of each operation and
//! kind of input together with the bound of the accuracy contract.
//!
//! ```text
//! cargo run --release --example conform -- FILE.jsonl
//! ```
//!
//! Errors are relative to max(1, |t|), |t| the largest translation among inputs and result. The
//! exit code is 1 if a bound is broken or a row cannot be read.

use dq8_contract::conformance::{Worst, worst_errors};
use dq8_contract::implementation::implementations;
use dq8_contract::vectors;
use mocap::command::{self, files, read};
use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let parse = |words| {
        read(words, [], |[], others| match &files(others)?[..] {
            [path] => Ok(path.clone()),
            others => Err(format!("one file is needed, and {} given", others.len())),
        })
    };
    command::execute("conform", "usage: conform FILE.jsonl\n", parse, |path| run(path))
}

fn run(path: &Path) -> Result<(), Box<dyn Error>> {
    let bytes = std::fs::read(path).map_err(|error| error.to_string());
    let worst = bytes.and_then(|bytes| text(&bytes).and_then(conform));
    report(&worst.map_err(|reason| format!("{}: {reason}", path.display()))?)
}

/// The text of a file; where it is none, the row is named as for any other that cannot be read.
fn text(bytes: &[u8]) -> Result<&str, String> {
    str::from_utf8(bytes).map_err(|error| {
        let before = &bytes[..error.valid_up_to()];
        let row = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        format!("row {row}: {error}")
    })
}

/// The worst errors of every implementation, sorted by operation and kind.
fn conform(text: &str) -> Result<Vec<Worst>, String> {
    let vectors = vectors::parse(text).map_err(|error| error.to_string())?;
    if vectors.is_empty() {
        return Err("no rows".to_owned());
    }
    let mut all = Vec::new();
    for on in implementations() {
        all.extend(worst_errors(on, &vectors)?);
    }
    all.sort_by(|a, b| (&a.op, &a.kind).cmp(&(&b.op, &b.kind)));
    Ok(all)
}

fn report(worst: &[Worst]) -> Result<(), Box<dyn Error>> {
    println!(
        "{:26} {:12} {:13} {:>5} {:>9} {:>9} {:>6}",
        "operation", "kind", "backend", "rows", "worst", "allowed", "row"
    );
    for w in worst {
        println!(
            "{:26} {:12} {:13} {:5} {:9.2e} {:9.2e} {:6}{}",
            w.op,
            w.kind,
            w.implementation,
            w.vectors,
            w.error,
            w.allowed,
            w.row,
            if w.breaks_bound() { "  BROKEN" } else { "" }
        );
    }
    let broken = worst.iter().filter(|w| w.breaks_bound()).count();
    if broken > 0 {
        return Err(format!("FAIL: {broken} of {} bounds broken", worst.len()).into());
    }
    println!("\nPASS: {} bounds kept", worst.len());
    Ok(())
}
