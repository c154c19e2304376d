use crate::error::Error;
use std::path::PathBuf;

pub(crate) const USAGE: &str = "skin [FILE.glb [--animation NAME] [--method lbs|dlb|mix=X] [--times T0,T1,…] [--obj DIR] [--pack OUT]] \
                                [--svg OUT]";

/// How a mesh is posed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Method {
    Linear,
    Dual,
    /// With this share of the dual quaternions.
    Mix(f64),
}

#[derive(Debug)]
pub(crate) struct Args {
    pub(crate) file: Option<PathBuf>,
    pub(crate) animation: Option<String>,
    pub(crate) method: Method,
    pub(crate) times: Option<Vec<f64>>,
    pub(crate) obj: Option<PathBuf>,
    pub(crate) svg: Option<PathBuf>,
    pub(crate) pack: Option<PathBuf>,
}

impl Args {
    pub(crate) fn parse(mut words: impl Iterator<Item = String>) -> Result<Self, Error> {
        let mut args = Self {
            file: None,
            animation: None,
            method: Method::Dual,
            times: None,
            obj: None,
            svg: None,
            pack: None,
        };
        while let Some(word) = words.next() {
            let mut value = || words.next().ok_or_else(|| Error(format!("{word} needs a value")));
            match word.as_str() {
                "--animation" => args.animation = Some(value()?),
                "--method" => args.method = method(&value()?)?,
                "--times" => args.times = Some(times(&value()?)?),
                "--obj" => args.obj = Some(value()?.into()),
                "--pack" => args.pack = Some(value()?.into()),
                "--svg" => args.svg = Some(value()?.into()),
                _ if word.starts_with('-') || args.file.is_some() => {
                    return Err(Error(format!("{word} is not expected: {USAGE}")));
                }
                _ => args.file = Some(word.into()),
            }
        }
        Ok(args)
    }
}

fn method(word: &str) -> Result<Method, Error> {
    match (word, word.strip_prefix("mix=").map(str::parse)) {
        ("lbs", _) => Ok(Method::Linear),
        ("dlb", _) => Ok(Method::Dual),
        (_, Some(Ok(share))) if (0.0..=1.0).contains(&share) => Ok(Method::Mix(share)),
        _ => Err(Error(format!("--method {word}: not lbs, dlb or mix=X with X from 0 to 1"))),
    }
}

fn times(list: &str) -> Result<Vec<f64>, Error> {
    let time = |word: &str| match word.trim().parse::<f64>() {
        Ok(time) if time.is_finite() => Ok(time),
        _ => Err(Error(format!("--times: {word:?} is not a number of seconds"))),
    };
    list.split(',').map(time).collect()
}
