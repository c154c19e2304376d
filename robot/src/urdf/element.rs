//! An element of a URDF file. Its attributes and child elements are read by name. Any other part
//! gives an error if it describes where links are, or if its name looks like a misspelling of a
//! name that is read. Otherwise it is ignored, with a warning unless the format of URDF has such a
//! part.

use super::error::{UrdfError, UrdfWarning};
use super::number;
use roxmltree::Node;

/// The text of a file, and the positions at which its lines begin.
pub(crate) struct Lines<'f> {
    text: &'f str,
    starts: Vec<usize>,
}

impl<'f> Lines<'f> {
    pub(crate) fn of(text: &'f str) -> Self {
        Self { text, starts: text.match_indices('\n').map(|(at, _)| at + 1).collect() }
    }
}

/// An element of the XML document, with the lines of its file for messages.
#[derive(Clone, Copy)]
pub(crate) struct Element<'f> {
    pub(crate) node: Node<'f, 'f>,
    pub(crate) lines: &'f Lines<'f>,
}

impl<'f> Element<'f> {
    pub(crate) fn name(self) -> &'f str {
        self.node.tag_name().name()
    }

    /// Returns the line on which the element begins, counted from one.
    pub(crate) fn line(self) -> u32 {
        let start = self.node.range().start;
        self.lines.starts.partition_point(|&line| line <= start) as u32 + 1
    }

    /// Returns the namespace prefix of the element's name; empty if the name has no prefix.
    fn prefix(self) -> &'f str {
        let name = self.lines.text.get(self.node.range().start + 1..).unwrap_or_default();
        let end = name.find(|c: char| c.is_whitespace() || "/>".contains(c));
        let (prefix, _) = name[..end.unwrap_or(name.len())].rsplit_once(':').unwrap_or_default();
        prefix
    }

    /// Returns the name of the element for errors, such as `<joint name="hip">`. If the element has
    /// no attribute `name`, the name of the element that contains it follows.
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

    /// Checks all parts of the element. A part that is neither read in elements of the kind `place`
    /// nor may be ignored gives an error or a warning.
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
            // A name with a prefix belongs to another program, so it is no misspelling.
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
                return Err(self.unexpected(format!("the text {shown:?} is not expected here")));
            }
            warnings.push(self.warning(format!("the text {shown:?} is not read")));
        }
        let mut seen = Vec::new();
        for child in self.elements() {
            child.check_in(self, place, warnings)?;
            if place.once && place.has_element(child.name()) {
                if seen.contains(&child.name()) {
                    warnings.push(child.warning("only the first element of this name is read"));
                }
                seen.push(child.name());
            }
        }
        Ok(())
    }

    /// Checks that the reader knows this element as a child of `parent`: as one that it reads, or
    /// as one that it may ignore with a warning.
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
            // Even an expanded file has some elements of xacro left, so they only give a warning. A
            // file that was not expanded fails elsewhere, because it lacks links or has expressions
            // in place of numbers.
            warnings.push(
                self.warning("an element of xacro is not read; expand the file with xacro first"),
            );
            return Ok(());
        }
        let parts = if place.numbers { JOINT.elements } else { "" };
        let mut names = place.names().chain(parts.split_terminator(' '));
        // Only a name without a prefix of its own can be a misspelling. A name with a prefix is an
        // error only if, without the prefix, it is exactly the name of a part, in upper or lower
        // case.
        let meant = if own {
            meant(name, names)
        } else {
            names.find(|known| known.eq_ignore_ascii_case(name))
        };
        if let Some(meant) = meant {
            let what = format!("this element is not expected here{}", instead(name, meant));
            return Err(self.unexpected(what));
        }
        warnings.push(self.warning("this element is not read here"));
        Ok(())
    }

    /// Returns the child elements of this name.
    pub(crate) fn children(self, name: &str) -> impl Iterator<Item = Element<'f>> {
        self.elements().filter(move |child| child.name() == name)
    }

    /// Returns the first child element of this name, if there is one. Other readers of URDF also
    /// take the first element.
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

    /// Reads an attribute as one finite number; `None` if the element does not have the attribute.
    pub(crate) fn number(self, attribute: &'static str) -> Result<Option<f64>, UrdfError> {
        Ok(self.numbers::<1>(attribute)?.map(|[number]| number))
    }

    /// Reads an attribute as `N` finite numbers; `None` if the element does not have the attribute.
    pub(crate) fn numbers<const N: usize>(
        self,
        attribute: &'static str,
    ) -> Result<Option<[f64; N]>, UrdfError> {
        let Some(text) = self.node.attribute(attribute) else { return Ok(None) };
        let numbers: Option<Vec<f64>> =
            text.split_whitespace().take(N + 1).map(number::finite).collect();
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

/// Returns the end of an error text that asks whether another name was meant.
fn instead(name: &str, meant: &str) -> String {
    if name == meant { String::new() } else { format!("; did you mean {meant:?}?") }
}

/// A kind of element, with lists of the names of its attributes and child elements. A part whose
/// name is in none of these lists is an error if its name is close to one of theirs ([`meant`]),
/// because it is probably misspelt. Other parts do not say where links are, and are ignored with a
/// warning.
pub(crate) struct Place {
    /// The attributes that are read. In this field and the next three, names are separated by
    /// spaces.
    pub(crate) attributes: &'static str,
    /// The child elements that are read.
    pub(crate) elements: &'static str,
    /// Attributes and elements that would say where links are, but that the reader cannot use. They
    /// are an error.
    pub(crate) unread: &'static str,
    /// Attributes and elements of the format that do not say where links are. They are ignored
    /// without a warning.
    pub(crate) known: &'static str,
    /// `true` if there should be at most one child element of each name. If there are more, only
    /// the first is read.
    pub(crate) once: bool,
    /// `true` if the attributes of the element are numbers. Some authors write the numbers as text
    /// inside the element, which is an error.
    pub(crate) numbers: bool,
}

const NOTHING: Place =
    Place { attributes: "", elements: "", unread: "", known: "", once: false, numbers: false };
const NUMBERS: Place = Place { numbers: true, ..NOTHING };

/// The root element. It may hold a `<loop_joint>`, which would close a loop of joints and so
/// constrain their values. The links form a tree without it, so it is ignored with a warning.
pub(crate) const ROBOT: Place =
    Place { attributes: "version", elements: "link joint", known: "name material", ..NOTHING };

pub(crate) const LINK: Place = Place {
    attributes: "name",
    unread: "link joint",
    known: "visual collision inertial",
    ..NOTHING
};

const PARTS: &str = "origin parent child axis limit mimic";

pub(crate) const JOINT: Place =
    Place { attributes: "name type", elements: PARTS, known: "dynamics", once: true, ..NOTHING };

/// The elements `<parent>` and `<child>`, which name the links at the two ends of a joint.
pub(crate) const END: Place = Place { attributes: "link", unread: PARTS, ..NUMBERS };

pub(crate) const ORIGIN: Place = Place {
    attributes: "xyz rpy",
    unread: "x y z roll pitch yaw quat quat_xyzw quat_wxyz quaternion",
    ..NUMBERS
};

pub(crate) const AXIS: Place = Place { attributes: "xyz", unread: "x y z", ..NUMBERS };

/// The element `<limit>`. Its attributes other than `lower` and `upper` are about speeds and
/// forces.
pub(crate) const LIMIT: Place = Place {
    attributes: "lower upper",
    unread: "min max",
    known: "effort velocity acceleration deceleration jerk",
    ..NUMBERS
};

pub(crate) const MIMIC: Place = Place { attributes: "joint multiplier offset", ..NUMBERS };

impl Place {
    /// Returns the names that are read and the names that say where links are.
    pub(crate) fn names(&self) -> impl Iterator<Item = &'static str> + use<> {
        let all = [self.attributes, self.elements, self.unread].into_iter();
        all.flat_map(|all| all.split_terminator(' '))
    }

    /// Returns `true` for an attribute that is read in elements of this kind, or may be ignored in
    /// them.
    pub(crate) fn has_attribute(&self, name: &str) -> bool {
        [self.attributes, self.known].into_iter().any(|all| has(all, name))
    }

    /// Returns `true` for a child element that is read in elements of this kind, or may be ignored
    /// in them.
    pub(crate) fn has_element(&self, name: &str) -> bool {
        [self.elements, self.known].into_iter().any(|all| has(all, name))
    }
}

fn has(all: &str, name: &str) -> bool {
    all.split_terminator(' ').any(|word| word == name)
}

/// Words that are close to names of the format, but are not misspellings of them.
const OTHER_WORDS: [&str; 3] = ["line", "point", "power"];

/// Returns the name that is probably meant by the misspelling `found`, if there is one. It differs
/// from `found` in case, in the order of its letters, or in a few letters (lost, added, changed, or
/// exchanged with a neighbour). One letter may differ in names of three to five letters, two in
/// longer names, and none in shorter names.
pub(crate) fn meant(
    found: &str,
    names: impl IntoIterator<Item = &'static str>,
) -> Option<&'static str> {
    let found = found.to_ascii_lowercase();
    let letters: Vec<char> = found.chars().collect();
    let own_word = OTHER_WORDS.contains(&found.as_str());
    names.into_iter().find(|name| *name == found || !own_word && near(&letters, name))
}

fn near(found: &[char], name: &str) -> bool {
    let name: Vec<char> = name.chars().collect();
    let allowed = match name.len() {
        ..=2 => 0,
        3..=5 => 1,
        _ => 2,
    };
    let sorted = |letters: &[char]| {
        let mut letters = letters.to_vec();
        letters.sort_unstable();
        letters
    };
    found.len().abs_diff(name.len()) <= allowed
        && (distance(found, &name) <= allowed || sorted(found) == sorted(&name))
}

/// Returns the least count of letters that must be added, removed, changed, or exchanged with the
/// next letter to turn `a` into `b` (optimal string alignment).
fn distance(a: &[char], b: &[char]) -> usize {
    // Row i holds the distances of the first i letters of `a` from all prefixes of `b`.
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let changed = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = changed.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    fn meant(found: &str) -> Option<&'static str> {
        let names = "lower upper origin axis limit mimic multiplier xyz rpy x link";
        super::meant(found, names.split(' '))
    }

    #[test]
    fn other_words_are_not() {
        let all = "power effort velocity damping friction stiffness dont_collapse type line xx lower_limit_switch \
                   orientation dynamics physics joint_properties unit";
        for found in all.split_whitespace().chain([""]) {
            assert_eq!(meant(found), None, "{found}");
        }
    }
}
