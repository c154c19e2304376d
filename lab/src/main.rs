//! `cargo run --release -p lab -- --out DIR` writes the report, `DIR/index.html`.

use lab::report::{self, Section};
use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let [flag, out] = arguments.as_slice() else {
        eprintln!("usage: lab --out DIR");
        return ExitCode::from(2);
    };
    if flag != "--out" {
        eprintln!("usage: lab --out DIR");
        return ExitCode::from(2);
    }
    let sections: Vec<Section> = Vec::new();
    let out = PathBuf::from(out);
    let written = std::fs::create_dir_all(&out)
        .and_then(|()| std::fs::write(out.join("index.html"), report::page(&sections)));
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("cannot write {}: {error}", out.display());
            ExitCode::FAILURE
        }
    }
}
