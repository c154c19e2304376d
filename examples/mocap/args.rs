//! The command line.

use crate::command::{Misuse, Request, set, value};
use std::ffi::OsString;
use std::path::PathBuf;

pub(crate) const USAGE: &str = "\
usage: mocap [FILE.bvh] [--csv OUT] [--svg OUT] [--pack OUT]

Without FILE.bvh, animates an embedded biped.
  --csv OUT   write the world positions, one row per frame
  --svg OUT   draw the skeleton at several frames and the path of its root
  --pack OUT  write the clip in 8 bytes for each track that moves, and frame; play it, and say what it keeps
";

#[derive(Debug, PartialEq)]
pub(crate) struct Args {
    pub(crate) clip: Option<PathBuf>,
    pub(crate) csv: Option<PathBuf>,
    pub(crate) svg: Option<PathBuf>,
    pub(crate) pack: Option<PathBuf>,
}

pub(crate) fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Request<Args>, Misuse> {
    let (mut clip, mut csv, mut svg, mut pack) = (None, None, None, None);
    let mut words = words.into_iter();
    while let Some(word) = words.next() {
        let text = word.to_string_lossy();
        match text.as_ref() {
            "-h" | "--help" => return Ok(Request::Help),
            "--csv" => set(&mut csv, "--csv", value("--csv", &mut words)?.into())?,
            "--svg" => set(&mut svg, "--svg", value("--svg", &mut words)?.into())?,
            "--pack" => set(&mut pack, "--pack", value("--pack", &mut words)?.into())?,
            option if option.starts_with('-') => {
                return Err(Misuse(format!("no such option: `{option}`")));
            }
            _ => set(&mut clip, "FILE.bvh", word.into())?,
        }
    }
    Ok(Request::Run(Args { clip, csv, svg, pack }))
}

#[cfg(test)]
mod tests {
    use super::{Args, parse};
    use crate::command::{Misuse, Request};

    fn words(line: &str) -> Result<Request<Args>, Misuse> {
        parse(line.split_whitespace().map(Into::into))
    }

    #[test]
    fn options_stand_in_any_order() {
        let args = Args {
            clip: Some("walk.bvh".into()),
            csv: Some("a.csv".into()),
            svg: Some("b.svg".into()),
            pack: Some("c.dq8".into()),
        };
        let line = "--csv a.csv --pack c.dq8 walk.bvh --svg b.svg";
        assert_eq!(words(line), Ok(Request::Run(args)));
        let none = Args { clip: None, csv: None, svg: None, pack: None };
        assert_eq!(words(""), Ok(Request::Run(none)));
        assert_eq!(words("walk.bvh --help"), Ok(Request::Help));
    }

    #[test]
    fn misuse_is_named() {
        for (line, named) in [
            ("--cvs a", "`--cvs`"),
            ("--instances 20", "`--instances`"),
            ("--csv", "--csv needs"),
            ("--csv --svg a", "--csv needs"),
            ("a.bvh b.bvh", "FILE.bvh is given twice"),
            ("--svg a --svg b", "--svg is given twice"),
        ] {
            let misuse = words(line).unwrap_err();
            assert!(misuse.0.contains(named), "{line}: {misuse}");
        }
    }
}
