//! What matters at each place of a file: what is read there, and what would say where links are if it were read.

/// A kind of element. A name that is not read there is an error if it is one of those that matter, or [close] to one;
/// anything else says nothing about places.
///
/// [close]: super::spelling::meant
pub(crate) struct Place {
    /// Attributes that are read.
    pub(crate) attributes: &'static [&'static str],
    /// Elements that are read.
    pub(crate) elements: &'static [&'static str],
    /// Attributes and elements that are not read, and that say something about places.
    pub(crate) unread: &'static [&'static str],
    /// Parts of the format that say nothing about places: nobody needs to be told that they are not read.
    pub(crate) known: &'static [&'static str],
    /// Whether it has numbers, which text in it may be meant to be.
    pub(crate) numbers: bool,
}

/// A loop would tie the values of joints to each other.
pub(crate) const ROBOT: Place = Place {
    attributes: &["version"],
    elements: &["link", "joint"],
    unread: &["loop_joint"],
    known: &["name", "material"],
    numbers: false,
};

pub(crate) const LINK: Place = Place {
    attributes: &["name"],
    elements: &[],
    unread: &["link", "joint"],
    known: &["visual", "collision", "inertial"],
    numbers: false,
};

pub(crate) const JOINT: Place = Place {
    attributes: &["name", "type"],
    elements: &PARTS,
    unread: &[],
    known: &["dynamics"],
    numbers: false,
};

const PARTS: [&str; 6] = ["origin", "parent", "child", "axis", "limit", "mimic"];

/// `<parent>` and `<child>`.
pub(crate) const END: Place =
    Place { attributes: &["link"], elements: &[], unread: &PARTS, known: &[], numbers: true };

pub(crate) const ORIGIN: Place = Place {
    attributes: &["xyz", "rpy"],
    elements: &[],
    unread: &[
        "x",
        "y",
        "z",
        "roll",
        "pitch",
        "yaw",
        "quat",
        "quat_xyzw",
        "quat_wxyz",
        "quaternion",
    ],
    known: &[],
    numbers: true,
};

pub(crate) const AXIS: Place = Place {
    attributes: &["xyz"],
    elements: &[],
    unread: &["x", "y", "z"],
    known: &[],
    numbers: true,
};

/// The other attributes of the format are about speeds and forces.
pub(crate) const LIMIT: Place = Place {
    attributes: &["lower", "upper"],
    elements: &[],
    unread: &["min", "max"],
    known: &["effort", "velocity", "acceleration", "deceleration", "jerk"],
    numbers: true,
};

pub(crate) const MIMIC: Place = Place {
    attributes: &["joint", "multiplier", "offset"],
    elements: &[],
    unread: &[],
    known: &[],
    numbers: true,
};

impl Place {
    /// All names that matter.
    pub(crate) fn names(&self) -> impl Iterator<Item = &'static str> + use<> {
        let names = self.attributes.iter().chain(self.elements).chain(self.unread);
        names.copied()
    }
}
