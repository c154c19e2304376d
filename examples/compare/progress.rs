//! [`Progress`]: a line that says what is being measured.

use dq8_contest::contest::Contest;
use std::io::{IsTerminal, Write, stderr};
use std::time::{Duration, Instant};

/// Writing takes time that must not be measured, and cools the caches.
const RARELY: Duration = Duration::from_millis(100);

pub(crate) struct Progress {
    contests: usize,
    done: usize,
    begin: Instant,
    shown: Option<Instant>,
    to: To,
}

enum To {
    /// One line, written over and over.
    Terminal,
    /// A line a contest, for logs.
    Lines,
    #[cfg(test)]
    Nobody,
}

impl Progress {
    pub(crate) fn new(contests: usize) -> Self {
        let to = if stderr().is_terminal() { To::Terminal } else { To::Lines };
        Self { contests, done: 0, begin: Instant::now(), shown: None, to }
    }

    #[cfg(test)]
    pub(crate) fn silent() -> Self {
        Self { to: To::Nobody, ..Self::new(1) }
    }

    /// What comes is another contest.
    pub(crate) fn next(&mut self) {
        self.done += 1;
        self.shown = None;
    }

    pub(crate) fn show(&mut self, contest: &Contest<'_>, round: usize, contender: &str) {
        let due = match self.to {
            To::Terminal => self.shown.is_none_or(|shown| shown.elapsed() > RARELY),
            To::Lines => self.shown.is_none(),
            #[cfg(test)]
            To::Nobody => false,
        };
        if !due {
            return;
        }
        self.shown = Some(Instant::now());
        let seconds = self.begin.elapsed().as_secs();
        let Self { contests, done, .. } = self;
        let Contest { job, size, title, .. } = contest;
        let text = format!("{done}/{contests} {seconds:>3} s  {job} {size}, {title}");
        // Nobody watching is no reason to stop.
        let _ = match self.to {
            To::Terminal => write!(stderr(), "\r\x1b[K{text}, round {}: {contender}", round + 1),
            _ => writeln!(stderr(), "{text}"),
        };
    }

    pub(crate) fn finish(&self) {
        if let To::Terminal = self.to {
            let _ = write!(stderr(), "\r\x1b[K");
        }
    }
}
