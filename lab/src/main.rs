//! `cargo run --release --manifest-path lab/Cargo.toml -- --out DIR` writes the report,
//! `DIR/index.html`.

use lab::report::{self, Section};
use std::error::Error;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

type Experiment = fn() -> Result<Section, Box<dyn Error>>;

/// In the order of the page.
const SECTIONS: &[Experiment] = &[
    lab::drift::section,
    lab::figures::section,
    lab::products::section,
    lab::operations::section,
    lab::speed::section,
    lab::interpolation::section,
    lab::keyframing::section,
    lab::forward_kinematics::section,
    lab::differentiation::section,
];

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let Some(out) = directory(&arguments) else {
        eprintln!("usage: lab --out DIR");
        return ExitCode::from(2);
    };
    match write(&out) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("cannot write {}: {error}", out.display());
            ExitCode::FAILURE
        }
    }
}

/// What follows `--out`, if nothing else is asked for.
fn directory(arguments: &[OsString]) -> Option<PathBuf> {
    match arguments {
        [flag, out] if flag == "--out" && !out.is_empty() => Some(out.into()),
        _ => None,
    }
}

/// Runs all experiments, prints what they find, and writes the page.
fn write(out: &Path) -> Result<(), Box<dyn Error>> {
    // First what can fail at once.
    std::fs::create_dir_all(out)?;
    let mut sections = Vec::new();
    for run in SECTIONS {
        let section = run()?;
        println!("{}", section.title);
        for line in &section.found {
            println!("  {line}");
        }
        sections.push(section);
    }
    std::fs::write(out.join("index.html"), report::page(&sections))?;
    Ok(())
}
