//! What is asked for on the command line.

use crate::reach::Target;
use std::path::PathBuf;

pub(crate) const USAGE: &str = "robot FILE.urdf [--random N | --configurations IN.csv] [--poses OUT.csv] [--svg OUT]\n      \
     [--reach X,Y,Z[,QX,QY,QZ,QW] [--link NAME]]";

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
    pub(crate) reach: Option<Target>,
    pub(crate) link: Option<String>,
}

impl Arguments {
    pub(crate) fn parse(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut file = None;
        let mut configurations = Configurations::Zero;
        let (mut poses, mut svg, mut reach, mut link) = (None, None, None, None);
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
                "--reach" => reach = Some(value()?.parse()?),
                "--link" => link = Some(value()?),
                _ if word.starts_with("--") => return Err(format!("no such option: {word}")),
                _ if file.is_some() => return Err(format!("a second file: {word}")),
                _ => file = Some(word.into()),
            }
        }
        let file = file.ok_or("a URDF file is needed")?;
        if link.is_some() && reach.is_none() {
            return Err("--link is for --reach".into());
        }
        Ok(Self { file, configurations, poses, svg, reach, link })
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

#[test]
fn a_target_is_a_point_or_a_pose() {
    let parse = |line: &str| Arguments::parse(line.split_whitespace().map(str::to_owned));
    let point = parse("a --reach 1,-2,0.5").unwrap().reach;
    assert!(matches!(point, Some(Target::Point([1.0, -2.0, 0.5]))));
    let arguments = parse("a --reach 1,2,3,0,0,0.6,0.8 --link hand").unwrap();
    let Some(Target::Pose(pose)) = arguments.reach else { panic!("{:?}", arguments.reach) };
    assert_eq!(pose.translation(), [1.0, 2.0, 3.0]);
    assert_eq!(pose.rotation().to_array(), [0.0, 0.0, 0.6, 0.8]);
    assert_eq!(arguments.link.as_deref(), Some("hand"));
    for wrong in "1,2 1,2,3,4 1,2,x 1,NaN,3 1,2,3,0,0,0,0 1,2,3,0,0,0,1.1 inf,0,0".split(' ') {
        assert!(parse(&format!("a --reach {wrong}")).is_err(), "{wrong}");
    }
    assert!(parse("a --link hand").is_err());
}
