//! What matters at each place of a file: what is read there, and what would say where links are if
//! it were read.

/// A kind of element. A name that is not read there is an error if it is one of those that matter,
/// or [close] to one; anything else says nothing about places.
///
/// [close]: super::spelling::meant
pub(crate) struct Place {
    /// Attributes that are read, words between spaces, as in all of these.
    pub(crate) attributes: &'static str,
    /// Elements that are read.
    pub(crate) elements: &'static str,
    /// Attributes and elements that are not read, and that say something about places.
    pub(crate) unread: &'static str,
    /// Parts of the format that say nothing about places: nobody needs to be told that they are not
    /// read.
    pub(crate) known: &'static str,
    /// Whether there is one element of each name, of which others count the first.
    pub(crate) once: bool,
    /// Whether it has numbers, which text in it may be meant to be.
    pub(crate) numbers: bool,
}

const NOTHING: Place =
    Place { attributes: "", elements: "", unread: "", known: "", once: false, numbers: false };
const NUMBERS: Place = Place { numbers: true, ..NOTHING };

/// A `<loop_joint>` would tie the values of joints to each other; a tree of links stands without
/// it.
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

/// `<parent>` and `<child>`.
pub(crate) const END: Place = Place { attributes: "link", unread: PARTS, ..NUMBERS };

pub(crate) const ORIGIN: Place = Place {
    attributes: "xyz rpy",
    unread: "x y z roll pitch yaw quat quat_xyzw quat_wxyz quaternion",
    ..NUMBERS
};

pub(crate) const AXIS: Place = Place { attributes: "xyz", unread: "x y z", ..NUMBERS };

/// The other attributes of the format are about speeds and forces.
pub(crate) const LIMIT: Place = Place {
    attributes: "lower upper",
    unread: "min max",
    known: "effort velocity acceleration deceleration jerk",
    ..NUMBERS
};

pub(crate) const MIMIC: Place = Place { attributes: "joint multiplier offset", ..NUMBERS };

impl Place {
    /// All names that matter.
    pub(crate) fn names(&self) -> impl Iterator<Item = &'static str> + use<> {
        let all = [self.attributes, self.elements, self.unread].into_iter();
        all.flat_map(|all| all.split_terminator(' '))
    }

    /// Whether an attribute is read here, or need not be.
    pub(crate) fn has_attribute(&self, name: &str) -> bool {
        [self.attributes, self.known].into_iter().any(|all| has(all, name))
    }

    /// The same of an element.
    pub(crate) fn has_element(&self, name: &str) -> bool {
        [self.elements, self.known].into_iter().any(|all| has(all, name))
    }
}

fn has(all: &str, name: &str) -> bool {
    all.split_terminator(' ').any(|word| word == name)
}
