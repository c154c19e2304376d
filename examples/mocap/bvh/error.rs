//! Why a file is not a BVH clip, and where.

use super::source::Word;
use std::error::Error;
use std::fmt;

#[derive(Debug, PartialEq)]
pub(crate) struct BvhError {
    /// Counted from one.
    pub(crate) line: usize,
    pub(crate) reason: String,
}

impl BvhError {
    pub(crate) fn new(line: usize, reason: impl Into<String>) -> Self {
        Self { line, reason: reason.into() }
    }

    /// Another word stands where this one must.
    pub(crate) fn expected(what: &str, found: Word<'_>) -> Self {
        Self::new(found.line, format!("expected {what}, found `{}`", Short(found.text)))
    }

    /// The file ends where this must follow.
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

/// Text of the file inside a message: a wrong file may hold a word of a megabyte, or control
/// characters.
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
