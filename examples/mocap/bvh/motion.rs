//! The part after `MOTION`: how many frames, how long each lasts, and their values.

use super::error::{BvhError, Reason};
use super::source::{Source, Word};
use std::fmt;

#[derive(Debug)]
pub(crate) struct Motion {
    /// In seconds.
    pub(crate) frame_time: f64,
    /// `[frame][channel]`.
    pub(crate) values: Vec<f64>,
    pub(crate) warning: Option<Warning>,
}

/// The file has one frame more than it announces. Those of well-known collections do, which count from zero.
#[derive(Debug, PartialEq)]
pub(crate) struct Warning {
    /// The line on which that frame begins, counted from one.
    line: usize,
    announced: usize,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, announced } = self;
        write!(f, "line {line}: `Frames: {announced}` is announced, and one more is read")
    }
}

/// `channels` is not zero.
pub(crate) fn read(source: &mut Source<'_>, channels: usize) -> Result<Motion, BvhError> {
    let count = heading(source, &["Frames"], "`Frames:` and a whole number")?;
    let frames = match count.text.parse::<usize>() {
        Ok(0) => {
            return Err(BvhError { line: count.line, reason: Reason::NoFrames });
        }
        Ok(frames) => frames,
        Err(_) => return Err(BvhError::expected("`Frames:` and a whole number", count)),
    };
    let time = heading(source, &["Frame", "Time"], "`Frame Time:` and a number")?;
    let Some(frame_time) = time.number().filter(|&seconds| seconds > 0.0) else {
        let found = time.text.to_owned();
        return Err(BvhError { line: time.line, reason: Reason::FrameTime { found } });
    };
    let (values, warning) = values(source, frames, channels)?;
    Ok(Motion { frame_time, values, warning })
}

/// The word behind the keywords and the colon, which stand on one line.
fn heading<'a>(
    source: &mut Source<'a>,
    keywords: &[&str],
    what: &'static str,
) -> Result<Word<'a>, BvhError> {
    let reached = source.line();
    let Some(line) = source.next_line() else {
        return Err(BvhError { line: reached, reason: Reason::Ends { before: what } });
    };
    let words = line.text.split([' ', '\t', '\r', ':']).filter(|word| !word.is_empty());
    let words: Vec<&str> = words.collect();
    match words.split_last() {
        Some((&text, before))
            if before.len() == keywords.len()
                && before
                    .iter()
                    .zip(keywords)
                    .all(|(word, keyword)| word.eq_ignore_ascii_case(keyword)) =>
        {
            Ok(Word { line: line.line, text })
        }
        _ => Err(BvhError::expected(what, Word { text: line.text.trim(), ..line })),
    }
}

fn values(
    source: &mut Source<'_>,
    frames: usize,
    channels: usize,
) -> Result<(Vec<f64>, Option<Warning>), BvhError> {
    // Not reserved from `frames`: a wrong count must not cost memory.
    let mut values = Vec::new();
    let (mut line_before, mut warning) = (source.line(), None);
    while let Some(line) = source.next_line() {
        let (complete, begun) = (values.len() / channels, values.len() % channels);
        let frame = complete + 1;
        if complete == frames && begun == 0 {
            warning = Some(Warning { line: line.line, announced: frames });
        }
        if complete > frames {
            let reason = Reason::TooManyFrames { announced: frames };
            return Err(BvhError { line: line.line, reason });
        }
        let here = line.text.split_whitespace().count();
        if begun + here > channels {
            // A frame that began on an earlier line was not wrapped but short, for this line starts
            // another one.
            return Err(if begun == 0 {
                let reason = Reason::TooManyValues { frame, expected: channels, found: here };
                BvhError { line: line.line, reason }
            } else {
                let reason = Reason::TooFewValues { frame, expected: channels, found: begun };
                BvhError { line: line_before, reason }
            });
        }
        for text in line.text.split_whitespace() {
            let word = Word { text, ..line };
            let Some(value) = word.number() else {
                let found = text.to_owned();
                return Err(BvhError { line: line.line, reason: Reason::Value { frame, found } });
            };
            values.push(value);
        }
        line_before = line.line;
    }
    let (complete, begun) = (values.len() / channels, values.len() % channels);
    if begun > 0 {
        let reason = Reason::TooFewValues { frame: complete + 1, expected: channels, found: begun };
        return Err(BvhError { line: line_before, reason });
    }
    if complete < frames {
        let reason = Reason::TooFewFrames { announced: frames, found: complete };
        return Err(BvhError { line: line_before, reason });
    }
    Ok((values, warning))
}
