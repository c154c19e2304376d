//! [`BvhError`], the reason why a file is not a clip, with the line.

use crate::source::Word;
use std::error::Error;
use std::fmt;

/// The error of a file that is not a BVH clip.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BvhError {
    /// The line of the fault, counted from one.
    pub line: usize,
    /// The sentence that says which fault the line has.
    pub reason: String,
}

impl BvhError {
    pub(crate) fn new(line: usize, reason: impl Into<String>) -> Self {
        Self { line, reason: reason.into() }
    }

    /// Makes the error of a word that stands where another must.
    pub(crate) fn expected(what: &str, found: Word<'_>) -> Self {
        Self::new(found.line, format!("expected {what}, found `{}`", Short(found.text)))
    }

    /// Makes the error of a file that ends too early.
    pub(crate) fn ends(line: usize, before: &str) -> Self {
        Self::new(line, format!("the file ends where {before} must follow"))
    }
}

impl fmt::Display for BvhError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.reason)
    }
}

impl Error for BvhError {}

/// A text of the file inside a message. It is cut and escaped, because a wrong file may hold a word
/// of a megabyte, or control characters.
pub(crate) struct Short<'a>(pub(crate) &'a str);

impl fmt::Display for Short<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const LONGEST: usize = 40;
        for character in self.0.chars().take(LONGEST) {
            if character.is_control() {
                write!(f, "{}", character.escape_default())?;
            } else {
                write!(f, "{character}")?;
            }
        }
        if self.0.chars().nth(LONGEST).is_some() { write!(f, "…") } else { Ok(()) }
    }
}
