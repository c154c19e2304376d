//! The example `mocap`: forward kinematics of a motion-capture clip, all frames at once, eight at a
//! time.
//!
//! A clip ([`clip`]) comes from the biped ([`biped`]) or from a file; `positions` concatenates
//! it by lanes; `packed` packs it; `table`, `csv` and `svg` show the result. [`command`],
//! [`output`] and [`svg::rows`] serve other examples as well, and the biped serves tests.

#![allow(missing_docs, reason = "parts of a program")]

mod args;
pub mod biped;
pub mod command;
mod csv;
pub mod output;
mod packed;
mod positions;
pub mod svg;
mod table;
#[cfg(test)]
mod written;

pub use dq8_bvh as clip;

use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

use args::Args;
use command::print;
use dq8_bvh::Clip;
use positions::Positions;

/// The whole program.
pub fn main() -> ExitCode {
    command::execute("mocap", args::USAGE, args::parse, run)
}

fn run(args: &Args) -> Result<(), Box<dyn Error>> {
    let clip = match &args.clip {
        Some(path) => load(path)?,
        None => biped::clip(),
    };
    let positions = Positions::of(&clip)?;
    print(&table::text(&clip, &positions)?)?;
    positions.check()?;

    let mut texts: Vec<(&Path, Vec<u8>)> = Vec::new();
    if let Some(path) = &args.csv {
        texts.push((path, csv::table(&clip, &positions)?.into()));
    }
    if let Some(path) = &args.svg {
        texts.push((path, svg::picture(&clip, &positions.world, positions.size)?.into()));
    }
    if let Some(path) = &args.pack {
        let (bytes, text) = packed::pack(&clip, positions.size)?;
        print(&text)?;
        texts.push((path, bytes));
    }
    output::write(&texts, args.clip.as_deref())
}

/// A clip from a file; a warning goes to standard error.
pub fn load(path: &Path) -> Result<Clip, Box<dyn Error>> {
    let shown = path.display();
    let bytes = fs::read(path).map_err(|error| format!("cannot read {shown}: {error}"))?;
    let title =
        path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let (clip, warning) =
        dq8_bvh::parse(title, &bytes).map_err(|error| format!("{shown}, {error}"))?;
    if let Some(warning) = warning {
        eprintln!("mocap: {shown}, {warning}");
    }
    Ok(clip)
}
