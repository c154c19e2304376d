use std::fmt;

/// Something in a file that is not read, because it says nothing about where links are; or limits
/// of a joint that mimics another, where they narrow the range of that one.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct UrdfWarning {
    /// The line on which the element begins, counted from one.
    pub line: u32,
    /// The element that is not read, or the one that holds the attribute or text.
    pub element: String,
    /// What is not read.
    pub text: String,
}

impl fmt::Display for UrdfWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, element, text } = self;
        write!(f, "line {line}: {element}: {text}")
    }
}
