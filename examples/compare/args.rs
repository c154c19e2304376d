//! The command line.

use crate::plan::JOBS;
use mocap::command::{Request, read};
use std::ffi::OsString;
use std::path::PathBuf;

pub(crate) const USAGE: &str = "\
usage: compare [JOB ...] [--quick] [--json OUT] [--svg OUT] [--md OUT]

  JOB         only these: J1 products, J2 crowds, J3 one skeleton, J4 points, J5 blends,
              J6 animation, J7 skins

  --quick     few rounds, and only what fits into the first caches: seconds, not minutes
  --json OUT  write all times and the machine's limits
  --svg OUT   draw the best of each kind, as times of glam's
  --md OUT    write a page: the best of each kind, and all contenders
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

pub(crate) fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Request<Args>, String> {
    read(words, ["--json", "--svg", "--md"], |[json, svg, md], others| {
        let mut args = Args { json, svg, md, ..Args::default() };
        for word in others {
            let word = word.to_string_lossy();
            match JOBS.iter().find(|job| job.eq_ignore_ascii_case(&word)) {
                Some(job) => args.jobs.push(job),
                None if word == "--quick" => args.quick = true,
                None => return Err(format!("no such argument: `{word}`")),
            }
        }
        Ok(args)
    })
}

#[test]
fn jobs_are_named_in_any_case_and_others_are_no_jobs() {
    let words = |line: &str| parse(line.split_whitespace().map(Into::into));
    let jobs = vec!["J7", "J1"];
    let [json, svg, md] = ["a", "b", "c"].map(|path| Some(path.into()));
    let args = Args { jobs, quick: true, json, svg, md };
    assert_eq!(words("J7 --svg b --quick j1 --md c --json a"), Ok(Request::Run(args)));
    assert_eq!(words(""), Ok(Request::Run(Args::default())));
    for word in ["--fast", "J8", "a.json"] {
        assert_eq!(words(word), Err(format!("no such argument: `{word}`")));
    }
}
