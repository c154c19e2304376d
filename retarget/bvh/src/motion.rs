//! The part of a file after `MOTION`: the number of frames, the time of a frame, and the values.

use crate::error::{BvhError, Short};
use crate::number::{is_space, plain};
use crate::source::{Source, Word};
use std::fmt;

#[derive(Debug)]
pub(crate) struct Motion {
    /// In seconds.
    pub(crate) frame_time: f64,
    /// `[frame][channel]`.
    pub(crate) values: Vec<f64>,
    pub(crate) warning: Option<Warning>,
}

/// The warning about a file that has one frame more than it announces. Files of well-known
/// collections count their frames from zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// The line on which the frame too many begins, counted from one.
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
        Ok(0) => return Err(BvhError::new(count.line, "the clip has no frames")),
        Ok(frames) => frames,
        Err(_) => return Err(BvhError::expected("`Frames:` and a whole number", count)),
    };
    let time = heading(source, &["Frame", "Time"], "`Frame Time:` and a number")?;
    let Some(frame_time) = time.number().filter(|&seconds| seconds > 0.0) else {
        let found = Short(time.text);
        let reason = format!("the frame time `{found}` is not a positive number of seconds");
        return Err(BvhError::new(time.line, reason));
    };
    let (values, warning) = values(source, frames, channels)?;
    Ok(Motion { frame_time, values, warning })
}

/// The word behind the keywords and the colon, which stand on one line.
fn heading<'a>(
    source: &mut Source<'a>,
    keywords: &[&str],
    what: &str,
) -> Result<Word<'a>, BvhError> {
    let reached = source.line();
    let Some(line) = source.next_line() else {
        return Err(BvhError::ends(reached, what));
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
    let announced = format!("`Frames: {frames}` is announced, but");
    let (mut line_before, mut warning) = (source.line(), None);
    while let Some(line) = source.next_line() {
        let (complete, begun) = (values.len() / channels, values.len() % channels);
        if complete == frames && begun == 0 {
            warning = Some(Warning { line: line.line, announced: frames });
        }
        if complete > frames {
            return Err(BvhError::new(line.line, announced + " more than one more follows"));
        }
        let end = (complete + 1) * channels;
        if let Err(wrong) = read_line(line.text, &mut values, end) {
            let (frame, here) = (complete + 1, line.text.split_whitespace().count());
            return Err(match begun {
                0 if here > channels => uneven(line.line, "many", frame, here, channels),
                // A frame that began on an earlier line was not wrapped but short, for this line
                // starts another one.
                _ if begun + here > channels => uneven(line_before, "few", frame, begun, channels),
                _ => {
                    let wrong = Short(wrong);
                    let reason = format!("`{wrong}` is not a finite number (frame {frame})");
                    BvhError::new(line.line, reason)
                }
            });
        }
        line_before = line.line;
    }
    let (complete, begun) = (values.len() / channels, values.len() % channels);
    if begun > 0 {
        return Err(uneven(line_before, "few", complete + 1, begun, channels));
    }
    if complete < frames {
        let reason = format!("{announced} the file ends after {complete}");
        return Err(BvhError::new(line_before, reason));
    }
    Ok((values, warning))
}

fn uneven(line: usize, many: &str, frame: usize, found: usize, channels: usize) -> BvhError {
    let reason =
        format!("too {many} values: frame {frame} has {found}, its channels need {channels}");
    BvhError::new(line, reason)
}

/// Appends the numbers of a line until there are `end`. If a word is not a finite number, or is one
/// too many, it is the error.
fn read_line<'t>(line: &'t str, values: &mut Vec<f64>, end: usize) -> Result<(), &'t str> {
    let bytes = line.as_bytes();
    let mut at = 0;
    loop {
        while bytes.get(at).is_some_and(|&byte| is_space(byte)) {
            at += 1;
        }
        let Some(rest) = bytes.get(at..).filter(|rest| !rest.is_empty()) else { return Ok(()) };
        if let (Some((value, length)), true) = (plain(rest), values.len() < end) {
            values.push(value);
            at += length;
            continue;
        }
        // A word, a number or white space of ASCII ends here, so `at` is a boundary of a character.
        // The white space that follows need not be ASCII.
        let rest = line[at..].trim_start();
        let Some(text) = rest.split(char::is_whitespace).next().filter(|text| !text.is_empty())
        else {
            return Ok(());
        };
        let number = Word { line: 0, text }.number().filter(|_| values.len() < end);
        values.push(number.ok_or(text)?);
        at = line.len() - rest.len() + text.len();
    }
}
