//! What the command lines of the larger examples have in common.

use std::error::Error;
use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;
use std::{env, io};

#[derive(Debug, PartialEq)]
pub enum Request<A> {
    Run(A),
    Help,
}

/// The program `name`: 0 if `work` went well, 1 if not, 2 if `parse` says what is wrong with the
/// command line.
pub fn execute<A>(
    name: &str,
    usage: &str,
    parse: impl FnOnce(env::ArgsOs) -> Result<Request<A>, String>,
    work: impl FnOnce(&A) -> Result<(), Box<dyn Error>>,
) -> ExitCode {
    let mut words = env::args_os();
    words.next();
    let result = match parse(words) {
        Ok(Request::Run(args)) => work(&args),
        Ok(Request::Help) => print(usage),
        Err(misuse) => {
            eprint!("{name}: {misuse}\n\n{usage}");
            return ExitCode::from(2);
        }
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{name}: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Reads a command line of `options` with a value each and of other words: for help, or what `make`
/// makes of both.
pub fn read<A, const N: usize>(
    words: impl IntoIterator<Item = OsString>,
    options: [&str; N],
    make: impl FnOnce([Option<PathBuf>; N], Vec<OsString>) -> Result<A, String>,
) -> Result<Request<A>, String> {
    let (mut values, mut others) = ([const { None }; N], Vec::new());
    let mut words = words.into_iter();
    while let Some(word) = words.next() {
        let text = word.to_string_lossy();
        if let Some(at) = options.iter().position(|option| *option == text) {
            // An option in place of a value is a value forgotten; a file of such a name is
            // `./--svg`.
            let value = words.next().filter(|word| !word.to_string_lossy().starts_with("--"));
            let value = value.ok_or_else(|| format!("{text} needs a value"))?;
            if values[at].replace(value.into()).is_some() {
                return Err(format!("{text} is given twice"));
            }
        } else if ["-h", "--help"].contains(&text.as_ref()) {
            return Ok(Request::Help);
        } else {
            others.push(word);
        }
    }
    make(values, others).map(Request::Run)
}

/// The other words of a command line as files.
pub fn files(others: Vec<OsString>) -> Result<Vec<PathBuf>, String> {
    match others.iter().find(|word| word.to_string_lossy().starts_with('-')) {
        Some(option) => Err(format!("no such option: `{}`", option.to_string_lossy())),
        None => Ok(others.into_iter().map(PathBuf::from).collect()),
    }
}

/// Not `print!`, which panics when the reader of a pipe has gone; then there is nobody to tell.
pub fn print(text: &str) -> Result<(), Box<dyn Error>> {
    match io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::{Request, files, read};

    type Read = ([Option<std::path::PathBuf>; 2], Vec<std::path::PathBuf>);

    fn words(line: &str) -> Result<Request<Read>, String> {
        let words = line.split_whitespace().map(Into::into);
        read(words, ["--csv", "--svg"], |values, others| Ok((values, files(others)?)))
    }

    #[test]
    fn options_stand_in_any_order() {
        let [csv, svg] = ["a.csv", "b.svg"].map(|path| Some(path.into()));
        let read = ([csv, svg], vec!["walk.bvh".into(), "run.bvh".into()]);
        assert_eq!(words("walk.bvh --svg b.svg run.bvh --csv a.csv"), Ok(Request::Run(read)));
        assert_eq!(words(""), Ok(Request::Run(([None, None], vec![]))));
        assert_eq!(words("walk.bvh --help"), Ok(Request::Help));
    }

    #[test]
    fn misuse_is_named() {
        for (line, named) in [
            ("--cvs a", "`--cvs`"),
            ("--csv", "--csv needs"),
            ("--csv --svg a", "--csv needs"),
            ("--svg a --svg b", "--svg is given twice"),
        ] {
            let misuse = words(line).unwrap_err();
            assert!(misuse.contains(named), "{line}: {misuse}");
        }
    }
}
