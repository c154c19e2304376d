//! The command line.

use std::ffi::OsString;
use std::fmt;
use std::path::PathBuf;

pub(crate) const USAGE: &str = "\
usage: compare [--quick] [--json OUT] [--svg OUT]

  --quick     few rounds, and only what fits into the first caches: seconds, not minutes
  --json OUT  write all times and the machine's limits
  --svg OUT   draw them as bars
";

#[derive(Debug, Default, PartialEq)]
pub(crate) struct Args {
    pub(crate) quick: bool,
    pub(crate) json: Option<PathBuf>,
    pub(crate) svg: Option<PathBuf>,
}

#[derive(Debug, PartialEq)]
pub(crate) enum Request {
    Run(Args),
    Help,
}

/// What is wrong with the command line.
#[derive(Debug, PartialEq)]
pub(crate) struct Misuse(String);

impl fmt::Display for Misuse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

pub(crate) fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Request, Misuse> {
    let mut args = Args::default();
    let mut words = words.into_iter();
    while let Some(word) = words.next() {
        match word.to_string_lossy().as_ref() {
            "-h" | "--help" => return Ok(Request::Help),
            "--quick" => args.quick = true,
            "--json" => set(&mut args.json, "--json", &mut words)?,
            "--svg" => set(&mut args.svg, "--svg", &mut words)?,
            other => return Err(Misuse(format!("no such argument: `{other}`"))),
        }
    }
    Ok(Request::Run(args))
}

fn set(
    slot: &mut Option<PathBuf>,
    option: &str,
    words: &mut impl Iterator<Item = OsString>,
) -> Result<(), Misuse> {
    // An option in place of a path is a path forgotten; a file of such a name is `./--svg`.
    let path = words.next().filter(|word| !word.to_string_lossy().starts_with("--"));
    let path = path.ok_or_else(|| Misuse(format!("{option} needs a path")))?;
    match slot.replace(path.into()) {
        None => Ok(()),
        Some(_) => Err(Misuse(format!("{option} is given twice"))),
    }
}

#[cfg(test)]
mod tests {
    use super::{Args, Misuse, Request, parse};

    fn words(line: &str) -> Result<Request, Misuse> {
        parse(line.split_whitespace().map(Into::into))
    }

    #[test]
    fn options_stand_in_any_order() {
        let args = Args { quick: true, json: Some("a".into()), svg: Some("b".into()) };
        assert_eq!(words("--svg b --quick --json a"), Ok(Request::Run(args)));
        assert_eq!(words(""), Ok(Request::Run(Args::default())));
        assert_eq!(words("--quick --help"), Ok(Request::Help));
    }

    #[test]
    fn misuse_is_named() {
        for (line, named) in [
            ("--fast", "`--fast`"),
            ("a.json", "`a.json`"),
            ("--json", "--json needs"),
            ("--json --svg a", "--json needs"),
            ("--svg a --svg b", "--svg is given twice"),
        ] {
            let misuse = words(line).unwrap_err();
            assert!(misuse.0.contains(named), "{line}: {misuse}");
        }
    }
}
