//! An element of the file: what it holds is read by name, and everything else in it is an error.

use crate::error::UrdfError;
use roxmltree::Node;

/// What says nothing about where links are. It may stand anywhere, and nobody looks inside. The names are those of
/// the format and of programs that read it: the documentation of the crate says why soft limits are among them.
const IGNORED: [&str; 17] = [
    "visual",
    "collision",
    "inertial",
    "contact",
    "self_collision_checking",
    "collision_checking",
    "verbose",
    "material",
    "transmission",
    "gazebo",
    "ros2_control",
    "mujoco",
    "sensor",
    "model_state",
    "dynamics",
    "calibration",
    "safety_controller",
];

/// An element, with its place in the file.
#[derive(Clone, Copy)]
pub(crate) struct Element<'f>(pub(crate) Node<'f, 'f>);

impl<'f> Element<'f> {
    pub(crate) fn name(self) -> &'f str {
        self.0.tag_name().name()
    }

    /// The line on which it begins, counted from one.
    pub(crate) fn line(self) -> u32 {
        self.0.document().text_pos_at(self.0.range().start).row
    }

    /// As errors name it: by its own name, or by that of what it is in.
    pub(crate) fn title(self) -> String {
        let name = self.name();
        match (self.0.attribute("name"), self.0.parent_element()) {
            (Some(own), _) => format!("<{name} name={own:?}>"),
            (None, Some(parent)) if parent.parent_element().is_some() => {
                format!("<{name}> of {}", Element(parent).title())
            }
            (None, _) => format!("<{name}>"),
        }
    }

    pub(crate) fn unexpected(self, what: impl Into<String>) -> UrdfError {
        UrdfError::Unexpected { line: self.line(), element: self.title(), what: what.into() }
    }

    fn missing(self, what: impl Into<String>) -> UrdfError {
        UrdfError::Missing { line: self.line(), element: self.title(), what: what.into() }
    }

    /// The elements in it that are not ignored, each of a name that may stand here.
    pub(crate) fn children(
        self,
        known: &[&str],
    ) -> Result<impl Iterator<Item = Element<'f>> + use<'f>, UrdfError> {
        let elements = || self.0.children().filter(Node::is_element).map(Element);
        // A name of another program's is none of the format's.
        let foreign =
            |child: &Element<'_>| child.0.tag_name().namespace() != self.0.tag_name().namespace();
        for child in elements() {
            let name = child.name();
            if foreign(&child) || !(known.contains(&name) || IGNORED.contains(&name)) {
                return Err(child.unexpected("such an element is unknown here"));
            }
        }
        Ok(elements().filter(|child| !IGNORED.contains(&child.name())))
    }

    /// Refuses attributes of other names, elements of other names and text. An attribute with a prefix is another
    /// program's.
    pub(crate) fn only(self, attributes: &[&str], elements: &[&str]) -> Result<(), UrdfError> {
        let mut own = self.0.attributes().filter(|attribute| attribute.namespace().is_none());
        if let Some(attribute) = own.find(|attribute| !attributes.contains(&attribute.name())) {
            return Err(self.unexpected(format!("the attribute {:?} is unknown", attribute.name())));
        }
        let texts = self.0.children().filter(Node::is_text).filter_map(|node| node.text());
        if let Some(text) = texts.map(str::trim).find(|text| !text.is_empty()) {
            return Err(self.unexpected(format!("the text {text:?} has no place here")));
        }
        self.children(elements).map(drop)
    }

    /// The one element of this name, if there is one.
    pub(crate) fn child(self, name: &str) -> Result<Option<Element<'f>>, UrdfError> {
        let mut all = self.0.children().filter(|node| node.tag_name().name() == name).map(Element);
        let first = all.next();
        match all.next() {
            Some(second) => Err(second.unexpected("there is one before it")),
            None => Ok(first),
        }
    }

    pub(crate) fn needed_child(self, name: &str) -> Result<Element<'f>, UrdfError> {
        self.child(name)?.ok_or_else(|| self.missing(format!("<{name}>")))
    }

    pub(crate) fn text(self, attribute: &str) -> Result<&'f str, UrdfError> {
        self.0
            .attribute(attribute)
            .ok_or_else(|| self.missing(format!("the attribute {attribute:?}")))
    }

    /// The number of an attribute, if it is there.
    pub(crate) fn number(self, attribute: &'static str) -> Result<Option<f64>, UrdfError> {
        Ok(self.numbers::<1>(attribute)?.map(|[number]| number))
    }

    /// The `N` numbers of an attribute, if it is there. None is NaN.
    pub(crate) fn numbers<const N: usize>(
        self,
        attribute: &'static str,
    ) -> Result<Option<[f64; N]>, UrdfError> {
        let Some(text) = self.0.attribute(attribute) else { return Ok(None) };
        let number = |word: &str| word.parse::<f64>().ok().filter(|number| !number.is_nan());
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
