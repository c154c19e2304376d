//! Why a file is not a BVH clip, and where.

use std::error::Error;
use std::fmt;

use super::source::Word;

#[derive(Debug, PartialEq)]
pub(crate) struct BvhError {
    /// Counted from one.
    pub(crate) line: usize,
    pub(crate) reason: Reason,
}

#[derive(Debug, PartialEq)]
pub(crate) enum Reason {
    Empty,
    NotUtf8,
    /// Another word stands where this one must.
    Expected {
        what: &'static str,
        found: String,
    },
    /// The file ends where this must follow.
    Ends {
        before: &'static str,
    },
    NoRoot,
    NoName {
        what: &'static str,
    },
    /// The brace opened on line `opened` is never closed.
    Unclosed {
        joint: String,
        opened: usize,
    },
    Incomplete {
        joint: String,
        missing: &'static str,
    },
    Repeated {
        joint: String,
        what: &'static str,
    },
    DuplicateJoint {
        name: String,
        first: usize,
    },
    ChannelCount {
        joint: String,
        announced: usize,
        found: usize,
    },
    UnknownChannel {
        joint: String,
        found: String,
    },
    DuplicateChannel {
        joint: String,
        found: String,
    },
    EndSiteMoves,
    NoChannels,
    Offset {
        joint: String,
        found: String,
    },
    Value {
        frame: usize,
        found: String,
    },
    FrameTime {
        found: String,
    },
    NoFrames,
    TooFewValues {
        frame: usize,
        expected: usize,
        found: usize,
    },
    TooManyValues {
        frame: usize,
        expected: usize,
        found: usize,
    },
    TooFewFrames {
        announced: usize,
        found: usize,
    },
    TooManyFrames {
        announced: usize,
    },
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "the file is empty"),
            Self::NotUtf8 => write!(f, "not UTF-8 text"),
            Self::Expected { what, found } => {
                write!(f, "expected {what}, found `{}`", Short(found))
            }
            Self::Ends { before } => write!(f, "the file ends where {before} must follow"),
            Self::NoRoot => write!(f, "no ROOT before MOTION"),
            Self::NoName { what } => write!(f, "{what} without a name"),
            Self::Unclosed { joint, opened } => {
                write!(f, "`{}` is not closed: no `}}` for the `{{` of line {opened}", Short(joint))
            }
            Self::Incomplete { joint, missing } => write!(f, "`{}` has no {missing}", Short(joint)),
            Self::Repeated { joint, what } => write!(f, "`{}` has a second {what}", Short(joint)),
            Self::DuplicateJoint { name, first } => {
                write!(f, "a second joint named `{}`, the first is on line {first}", Short(name))
            }
            Self::ChannelCount { joint, announced, found } => {
                write!(f, "`{}` announces {announced} channels and lists {found}", Short(joint))
            }
            Self::UnknownChannel { joint, found } => {
                write!(f, "`{}` is no channel (in `{}`)", Short(found), Short(joint))
            }
            Self::DuplicateChannel { joint, found } => {
                write!(f, "`{}` lists {} twice", Short(joint), Short(found))
            }
            Self::EndSiteMoves => write!(f, "an end site has no channels"),
            Self::NoChannels => write!(f, "no joint has a channel, so nothing can move"),
            Self::Offset { joint, found } => {
                let (joint, found) = (Short(joint), Short(found));
                write!(f, "`{found}` is not a finite number (OFFSET of `{joint}`)")
            }
            Self::Value { frame, found } => {
                write!(f, "`{}` is not a finite number (frame {frame})", Short(found))
            }
            Self::FrameTime { found } => {
                write!(f, "the frame time `{}` is not a positive number of seconds", Short(found))
            }
            Self::NoFrames => write!(f, "the clip has no frames"),
            Self::TooFewValues { frame, expected, found } => {
                write!(f, "too few values: frame {frame} has {found}, its channels need {expected}")
            }
            Self::TooManyValues { frame, expected, found } => {
                write!(
                    f,
                    "too many values: frame {frame} has {found}, its channels need {expected}"
                )
            }
            Self::TooFewFrames { announced, found } => {
                write!(f, "`Frames: {announced}` is announced, but the file ends after {found}")
            }
            Self::TooManyFrames { announced } => {
                write!(f, "`Frames: {announced}` is announced, but more than one more follows")
            }
        }
    }
}

impl BvhError {
    pub(crate) fn expected(what: &'static str, found: Word<'_>) -> Self {
        let (line, found) = (found.line, found.text.to_owned());
        Self { line, reason: Reason::Expected { what, found } }
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
struct Short<'a>(&'a str);

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
