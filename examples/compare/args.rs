//! The command line.

use crate::plan::JOBS;
use mocap::command::{Misuse, Request, set, value};
use std::ffi::OsString;
use std::path::PathBuf;

pub(crate) const USAGE: &str = "\
usage: compare [JOB ...] [--quick] [--json OUT] [--svg OUT] [--md OUT]

  JOB         only these: J1 products, J2 crowds, J3 one skeleton, J4 points, J5 blends,
              J6 animation, J7 skins

  --quick     few rounds, and only what fits into the first caches: seconds, not minutes
  --json OUT  write all times and the machine's limits
  --svg OUT   draw them as bars
  --md OUT    write the best of each kind as a table for documents
";

#[derive(Debug, Default, PartialEq)]
pub(crate) struct Args {
    /// All if there is none.
    pub(crate) jobs: Vec<&'static str>,
    pub(crate) quick: bool,
    pub(crate) json: Option<PathBuf>,
    pub(crate) svg: Option<PathBuf>,
    pub(crate) md: Option<PathBuf>,
}

pub(crate) fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Request<Args>, Misuse> {
    let mut args = Args::default();
    let mut words = words.into_iter();
    while let Some(word) = words.next() {
        match word.to_string_lossy().as_ref() {
            "-h" | "--help" => return Ok(Request::Help),
            "--quick" => args.quick = true,
            "--json" => set(&mut args.json, "--json", value("--json", &mut words)?.into())?,
            "--svg" => set(&mut args.svg, "--svg", value("--svg", &mut words)?.into())?,
            "--md" => set(&mut args.md, "--md", value("--md", &mut words)?.into())?,
            other => match JOBS.iter().find(|job| job.eq_ignore_ascii_case(other)) {
                Some(job) => args.jobs.push(job),
                None => return Err(Misuse(format!("no such argument: `{other}`"))),
            },
        }
    }
    Ok(Request::Run(args))
}

#[cfg(test)]
mod tests {
    use super::{Args, parse};
    use mocap::command::{Misuse, Request};

    fn words(line: &str) -> Result<Request<Args>, Misuse> {
        parse(line.split_whitespace().map(Into::into))
    }

    #[test]
    fn options_stand_in_any_order() {
        let jobs = vec!["J7", "J1"];
        let [json, svg, md] = ["a", "b", "c"].map(|path| Some(path.into()));
        let args = Args { jobs, quick: true, json, svg, md };
        assert_eq!(words("J7 --svg b --quick j1 --md c --json a"), Ok(Request::Run(args)));
        assert_eq!(words(""), Ok(Request::Run(Args::default())));
        assert_eq!(words("--quick --help"), Ok(Request::Help));
    }

    #[test]
    fn misuse_is_named() {
        for (line, named) in [
            ("--fast", "`--fast`"),
            ("J8", "`J8`"),
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
