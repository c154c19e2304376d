//! The command line.

use crate::command::{Request, files, read};
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

pub(crate) fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Request<Args>, String> {
    read(words, ["--csv", "--svg", "--pack"], |[csv, svg, pack], others| {
        let mut clips = files(others)?;
        match clips.len() {
            0 | 1 => Ok(Args { clip: clips.pop(), csv, svg, pack }),
            _ => Err("FILE.bvh is given twice".into()),
        }
    })
}

#[test]
fn a_command_line_has_one_clip_at_most() {
    let words = |line: &str| parse(line.split_whitespace().map(Into::into));
    let [clip, csv, svg, pack] = ["walk.bvh", "a", "b", "c"].map(|path| Some(path.into()));
    let args = Args { clip, csv, svg, pack };
    assert_eq!(words("--csv a --pack c walk.bvh --svg b"), Ok(Request::Run(args)));
    let none = Args { clip: None, csv: None, svg: None, pack: None };
    assert_eq!(words(""), Ok(Request::Run(none)));
    let twice = Err("FILE.bvh is given twice".into());
    assert_eq!(words("a.bvh b.bvh"), twice);
}
