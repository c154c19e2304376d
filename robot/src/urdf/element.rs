//! An element of the file: what it holds is read by name. Everything else in it is an error if it
//! matters or is meant to be something that does, and a warning if not.

use super::error::UrdfError;
use super::place::{JOINT, Place};
use super::spelling::meant;
use super::warning::UrdfWarning;
use roxmltree::Node;

/// The text of a file, and where its lines begin.
pub(crate) struct Lines<'f> {
    text: &'f str,
    starts: Vec<usize>,
}

impl<'f> Lines<'f> {
    pub(crate) fn of(text: &'f str) -> Self {
        Self { text, starts: text.match_indices('\n').map(|(at, _)| at + 1).collect() }
    }
}

/// An element, with its place in the file.
#[derive(Clone, Copy)]
pub(crate) struct Element<'f> {
    pub(crate) node: Node<'f, 'f>,
    pub(crate) lines: &'f Lines<'f>,
}

impl<'f> Element<'f> {
    pub(crate) fn name(self) -> &'f str {
        self.node.tag_name().name()
    }

    /// The line on which it begins, counted from one.
    pub(crate) fn line(self) -> u32 {
        let start = self.node.range().start;
        self.lines.starts.partition_point(|&line| line <= start) as u32 + 1
    }

    /// The prefix of its name, empty if it has none.
    fn prefix(self) -> &'f str {
        let name = self.lines.text.get(self.node.range().start + 1..).unwrap_or_default();
        let end = name.find(|c: char| c.is_whitespace() || "/>".contains(c));
        let (prefix, _) = name[..end.unwrap_or(name.len())].rsplit_once(':').unwrap_or_default();
        prefix
    }

    /// As errors name it: by its own name, or by that of what it is in.
    pub(crate) fn title(self) -> String {
        let (prefix, name) = (self.prefix(), self.name());
        let colon = if prefix.is_empty() { "" } else { ":" };
        match (self.node.attribute("name"), self.node.parent_element()) {
            (Some(own), _) => format!("<{prefix}{colon}{name} name={own:?}>"),
            (None, Some(parent)) if parent.parent_element().is_some() => {
                format!("<{prefix}{colon}{name}> of {}", Element { node: parent, ..self }.title())
            }
            (None, _) => format!("<{prefix}{colon}{name}>"),
        }
    }

    pub(crate) fn unexpected(self, what: impl Into<String>) -> UrdfError {
        UrdfError::Unexpected { line: self.line(), element: self.title(), what: what.into() }
    }

    fn missing(self, what: impl Into<String>) -> UrdfError {
        UrdfError::Missing { line: self.line(), element: self.title(), what: what.into() }
    }

    pub(crate) fn warning(self, text: impl Into<String>) -> UrdfWarning {
        UrdfWarning { line: self.line(), element: self.title(), text: text.into() }
    }

    fn elements(self) -> impl Iterator<Item = Element<'f>> {
        let elements = self.node.children().filter(Node::is_element);
        elements.map(move |node| Element { node, ..self })
    }

    /// Looks at all that is in it and not read at such a place.
    pub(crate) fn check(
        self,
        place: &Place,
        warnings: &mut Vec<UrdfWarning>,
    ) -> Result<(), UrdfError> {
        for attribute in self.node.attributes() {
            let name = &self.lines.text[attribute.range_qname()];
            if place.has_attribute(name) {
                continue;
            }
            // A name with a prefix is another program's.
            let meant = if name.contains(':') { None } else { meant(name, place.names()) };
            if let Some(meant) = meant {
                let what = format!("the attribute {name:?} is unknown{}", instead(name, meant));
                return Err(self.unexpected(what));
            }
            warnings.push(self.warning(format!("the attribute {name:?} is not read")));
        }
        let texts = self.node.children().filter(Node::is_text).filter_map(|node| node.text());
        for text in texts.map(str::trim).filter(|text| !text.is_empty()) {
            let shown: String = text.chars().take(40).collect();
            if place.numbers && text.contains(|c: char| c.is_ascii_digit()) {
                return Err(self.unexpected(format!("the text {shown:?} has no place here")));
            }
            warnings.push(self.warning(format!("the text {shown:?} is not read")));
        }
        let mut seen = Vec::new();
        for child in self.elements() {
            child.check_in(self, place, warnings)?;
            if place.once && place.has_element(child.name()) {
                if seen.contains(&child.name()) {
                    warnings.push(child.warning("there is one before it, which is read instead"));
                }
                seen.push(child.name());
            }
        }
        Ok(())
    }

    /// Whether this element of `parent` is read, or need not be.
    fn check_in(
        self,
        parent: Element<'f>,
        place: &Place,
        warnings: &mut Vec<UrdfWarning>,
    ) -> Result<(), UrdfError> {
        let (name, own) = (self.name(), self.prefix() == parent.prefix());
        if own && place.has_element(name) {
            return Ok(());
        }
        let namespace = self.node.tag_name().namespace().filter(|_| !own);
        if namespace.is_some_and(|namespace| namespace.contains("xacro")) {
            // What is left of expanding a file; a file that was not expanded lacks links or has
            // words for numbers.
            warnings.push(self.warning("an element of xacro is not read: expand the file first"));
            return Ok(());
        }
        let parts = if place.numbers { JOINT.elements } else { "" };
        let mut names = place.names().chain(parts.split_terminator(' '));
        // Nobody misspells another program's name of what matters here.
        let meant = if own {
            meant(name, names)
        } else {
            names.find(|known| known.eq_ignore_ascii_case(name))
        };
        if let Some(meant) = meant {
            let what = format!("such an element is unknown here{}", instead(name, meant));
            return Err(self.unexpected(what));
        }
        warnings.push(self.warning("such an element is not read here"));
        Ok(())
    }

    /// All elements of this name.
    pub(crate) fn children(self, name: &str) -> impl Iterator<Item = Element<'f>> {
        self.elements().filter(move |child| child.name() == name)
    }

    /// The first element of this name, as other readers take it, if there is one.
    pub(crate) fn child(self, name: &str) -> Option<Element<'f>> {
        self.children(name).next()
    }

    pub(crate) fn needed_child(self, name: &str) -> Result<Element<'f>, UrdfError> {
        self.child(name).ok_or_else(|| self.missing(format!("<{name}>")))
    }

    pub(crate) fn text(self, attribute: &str) -> Result<&'f str, UrdfError> {
        self.node
            .attribute(attribute)
            .ok_or_else(|| self.missing(format!("the attribute {attribute:?}")))
    }

    /// The number of an attribute, if it is there.
    pub(crate) fn number(self, attribute: &'static str) -> Result<Option<f64>, UrdfError> {
        Ok(self.numbers::<1>(attribute)?.map(|[number]| number))
    }

    /// The `N` numbers of an attribute, if it is there. All are finite.
    pub(crate) fn numbers<const N: usize>(
        self,
        attribute: &'static str,
    ) -> Result<Option<[f64; N]>, UrdfError> {
        let Some(text) = self.node.attribute(attribute) else { return Ok(None) };
        let number = |word: &str| word.parse::<f64>().ok().filter(|number| number.is_finite());
        let numbers: Option<Vec<f64>> = text.split_whitespace().map(number).collect();
        let numbers = numbers.and_then(|numbers| <[f64; N]>::try_from(numbers).ok());
        let error = || UrdfError::Numbers {
            line: self.line(),
            element: self.title(),
            attribute,
            wanted: N,
            text: text.to_owned(),
        };
        numbers.map(Some).ok_or_else(error)
    }
}

/// What is said of a name that is probably meant to be another.
fn instead(name: &str, meant: &str) -> String {
    if name == meant { String::new() } else { format!("; is {meant:?} meant?") }
}
