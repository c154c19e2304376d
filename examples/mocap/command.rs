//! What the command lines of the larger examples have in common.

use std::error::Error;
use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;
use std::{env, fmt, io};

#[derive(Debug, PartialEq)]
pub enum Request<A> {
    Run(A),
    Help,
}

/// What is wrong with the command line.
#[derive(Debug, PartialEq)]
pub struct Misuse(pub String);

impl fmt::Display for Misuse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// The program `name`: 0 if `work` went well, 1 if not, 2 if the command line makes no sense.
pub fn execute<A>(
    name: &str,
    usage: &str,
    parse: impl FnOnce(env::ArgsOs) -> Result<Request<A>, Misuse>,
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

/// What follows `option`.
pub fn value(option: &str, words: &mut impl Iterator<Item = OsString>) -> Result<OsString, Misuse> {
    // An option in place of a value is a value forgotten; a file of such a name is `./--svg`.
    let value = words.next().filter(|word| !word.to_string_lossy().starts_with("--"));
    value.ok_or_else(|| Misuse(format!("{option} needs a value")))
}

pub fn set<T>(slot: &mut Option<T>, name: &str, value: T) -> Result<(), Misuse> {
    match slot.replace(value) {
        None => Ok(()),
        Some(_) => Err(Misuse(format!("{name} is given twice"))),
    }
}

/// Not `print!`, which panics when the reader of a pipe has gone; then there is nobody to tell.
pub fn print(text: &str) -> Result<(), Box<dyn Error>> {
    match io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}
