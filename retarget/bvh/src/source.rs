//! The text of a file, read word by word in the hierarchy and line by line in the motion.

/// A word and the line it stands on, counted from one.
#[derive(Clone, Copy)]
pub(crate) struct Word<'a> {
    pub(crate) line: usize,
    pub(crate) text: &'a str,
}

impl Word<'_> {
    pub(crate) fn is(&self, keyword: &str) -> bool {
        self.text.eq_ignore_ascii_case(keyword)
    }

    /// `parse` alone would also take `inf` and `nan`, and round `1e999` to infinity.
    pub(crate) fn number(&self) -> Option<f64> {
        self.text.parse().ok().filter(|number: &f64| number.is_finite())
    }
}

/// Lines end with LF, with CR, or with LF after any number of CR. There is one at least.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = &str> {
    text.split('\n').flat_map(|line| line.trim_end_matches('\r').split('\r'))
}

pub(crate) struct Source<'a> {
    lines: Vec<&'a str>,
    /// What is left of the current line.
    rest: &'a str,
    /// The current line, counted from one.
    line: usize,
}

impl<'a> Source<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        // Windows programs like to put a byte order mark in front.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        // DOS ended text with this character, and some programs fill up with it or with zeros.
        let text = text.trim_end_matches(|c: char| c.is_whitespace() || "\u{1a}\0".contains(c));
        let lines: Vec<_> = lines(text).collect();
        Self { rest: lines[0], lines, line: 1 }
    }

    /// The line reached so far; at the end of the file, its last one.
    pub(crate) fn line(&self) -> usize {
        self.line
    }

    /// The next line that is not blank. What is left of the current line counts as one.
    pub(crate) fn next_line(&mut self) -> Option<Word<'a>> {
        self.seek()?;
        let text = std::mem::take(&mut self.rest);
        Some(Word { line: self.line, text })
    }

    /// The next word. A brace is a word of its own, also where no space surrounds it.
    pub(crate) fn next_word(&mut self) -> Option<Word<'a>> {
        self.seek()?;
        let is_end = |c: char| c.is_whitespace() || c == '{' || c == '}';
        let end = match self.rest.find(is_end) {
            Some(0) => 1, // a brace, since `seek` has skipped the space
            Some(end) => end,
            None => self.rest.len(),
        };
        let (text, rest) = self.rest.split_at(end);
        self.rest = rest;
        Some(Word { line: self.line, text })
    }

    pub(crate) fn peek_word(&mut self) -> Option<Word<'a>> {
        let here = (self.rest, self.line);
        let word = self.next_word();
        (self.rest, self.line) = here;
        word
    }

    /// The words up to a brace or the end of this line: names of joints may contain spaces.
    pub(crate) fn next_name(&mut self) -> String {
        let end = self.rest.find(['{', '}']).unwrap_or(self.rest.len());
        let (name, rest) = self.rest.split_at(end);
        self.rest = rest;
        name.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// Goes to the next thing that is not white space.
    fn seek(&mut self) -> Option<()> {
        self.rest = self.rest.trim_start();
        while self.rest.is_empty() {
            self.rest = self.lines.get(self.line)?.trim_start();
            self.line += 1;
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::Source;

    #[test]
    fn names_keep_their_spaces_and_end_at_a_brace() {
        let mut source = Source::new("JOINT Bip01 \t L  Thigh {");
        source.next_word();
        assert_eq!(source.next_name(), "Bip01 L Thigh");
        assert_eq!(source.next_word().map(|word| word.text), Some("{"));
    }

    #[test]
    fn lines_skip_blanks_and_begin_with_the_rest_of_the_current_one() {
        let mut source = Source::new("MOTION Frames: 2\n\n \t\n1 2\r\r\n");
        source.next_word();
        assert_eq!(source.next_line().map(|line| (line.line, line.text)), Some((1, "Frames: 2")));
        assert_eq!(source.next_line().map(|line| (line.line, line.text.trim())), Some((4, "1 2")));
        assert!(source.next_line().is_none());
    }
}
