use mocap::command::{Request, files, read};
use std::ffi::OsString;
use std::path::{Path, PathBuf};

pub(crate) const USAGE: &str = "\
usage: skin [FILE.glb [--animation NAME] [--method lbs|dlb|mix=X] [--normalize] [--times T0,T1,…] [--obj DIR] [--pack OUT]] [--svg OUT]
";

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
    /// Weights are divided by their sum.
    pub(crate) normalize: bool,
    pub(crate) times: Option<Vec<f64>>,
    pub(crate) obj: Option<PathBuf>,
    pub(crate) svg: Option<PathBuf>,
    pub(crate) pack: Option<PathBuf>,
}

pub(crate) fn parse(words: impl IntoIterator<Item = OsString>) -> Result<Request<Args>, String> {
    let options = ["--animation", "--method", "--times", "--obj", "--pack", "--svg"];
    read(words, options, |[animation, method, times, obj, pack, svg], mut others| {
        let all = others.len();
        others.retain(|word| word != "--normalize");
        let normalize = all > others.len();
        let mut files = files(others)?;
        if let Some(second) = files.get(1) {
            return Err(format!("{} is not expected", second.display()));
        }
        let [animation, method, times] = [animation, method, times]
            .map(|word| word.as_deref().map(Path::to_string_lossy).map(String::from));
        let method = method.map_or(Ok(Method::Dual), |word| self::method(&word))?;
        let times = times.map(|list| self::times(&list)).transpose()?;
        Ok(Args { file: files.pop(), animation, method, normalize, times, obj, svg, pack })
    })
}

fn method(word: &str) -> Result<Method, String> {
    match (word, word.strip_prefix("mix=").map(str::parse)) {
        ("lbs", _) => Ok(Method::Linear),
        ("dlb", _) => Ok(Method::Dual),
        (_, Some(Ok(share))) if (0.0..=1.0).contains(&share) => Ok(Method::Mix(share)),
        _ => Err(format!("--method {word}: not lbs, dlb or mix=X with X from 0 to 1")),
    }
}

fn times(list: &str) -> Result<Vec<f64>, String> {
    let time = |word: &str| match word.trim().parse::<f64>() {
        Ok(time) if time.is_finite() => Ok(time),
        _ => Err(format!("--times: {word:?} is not a number of seconds")),
    };
    list.split(',').map(time).collect()
}
