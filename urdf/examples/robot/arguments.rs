//! What is asked for on the command line.

use std::path::PathBuf;

pub(crate) const USAGE: &str =
    "robot FILE.urdf [--random N | --configurations IN.csv] [--poses OUT.csv] [--svg OUT]";

#[derive(Debug, PartialEq)]
pub(crate) enum Configurations {
    Zero,
    Random(usize),
    File(PathBuf),
}

#[derive(Debug)]
pub(crate) struct Arguments {
    pub(crate) file: PathBuf,
    pub(crate) configurations: Configurations,
    pub(crate) poses: Option<PathBuf>,
    pub(crate) svg: Option<PathBuf>,
}

impl Arguments {
    pub(crate) fn parse(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut file = None;
        let mut configurations = Configurations::Zero;
        let (mut poses, mut svg) = (None, None);
        while let Some(word) = words.next() {
            let mut value = || words.next().ok_or(format!("{word} needs a value"));
            match word.as_str() {
                "--random" | "--configurations" if configurations != Configurations::Zero => {
                    return Err("give configurations once".into());
                }
                "--random" => {
                    let text = value()?;
                    let number = text.parse().map_err(|_| format!("not a number: {text}"))?;
                    configurations = Configurations::Random(number);
                }
                "--configurations" => configurations = Configurations::File(value()?.into()),
                "--poses" => poses = Some(value()?.into()),
                "--svg" => svg = Some(value()?.into()),
                _ if word.starts_with("--") => return Err(format!("no such option: {word}")),
                _ if file.is_some() => return Err(format!("a second file: {word}")),
                _ => file = Some(word.into()),
            }
        }
        let file = file.ok_or("a URDF file is needed")?;
        Ok(Self { file, configurations, poses, svg })
    }
}

#[test]
fn configurations_are_given_once() {
    let parse = |line: &str| Arguments::parse(line.split_whitespace().map(str::to_owned));
    let arguments = parse("a.urdf --random 10 --svg b.svg").unwrap();
    assert_eq!(arguments.configurations, Configurations::Random(10));
    assert_eq!(arguments.svg, Some("b.svg".into()));
    for wrong in ["", "a b", "a --random x", "a --svg", "a --random 1 --configurations b", "a --x"]
    {
        assert!(parse(wrong).is_err(), "{wrong}");
    }
}
