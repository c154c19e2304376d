//! The repository's humanoid and the walk of the biped.

#![allow(dead_code, reason = "each test takes what it needs")]

use dq8_retarget::{Clip, Humanoid, Person};

pub(crate) const HUMANOID: &str = include_str!("../../../robot/robots/humanoid.urdf");

pub(crate) fn humanoid() -> Humanoid {
    Humanoid::from_urdf(HUMANOID).unwrap()
}

pub(crate) fn person(clip: &Clip) -> Person {
    Person::from_clip(clip).unwrap()
}

/// The humanoid with a shape of collision on a link.
pub(crate) fn with_shape(urdf: &str, link: &str, origin: &str, shape: &str) -> String {
    let element = format!(
        "<collision><origin xyz='{origin}'/><geometry>{shape}</geometry></collision></link>"
    );
    let start = urdf.find(&format!("<link name=\"{link}\"")).unwrap();
    let end = start + urdf[start..].find('>').unwrap();
    if urdf[..end].ends_with('/') {
        return format!("{}>{element}{}", &urdf[..end - 1], &urdf[end + 1..]);
    }
    let close = end + urdf[end..].find("</link>").unwrap();
    format!("{}{element}{}", &urdf[..close], &urdf[close + "</link>".len()..])
}

/// The humanoid with boxes of collision under its feet, whose lower sides are 0.07 m below the
/// ankles.
pub(crate) fn with_soles() -> String {
    ["left_foot", "right_foot"].iter().fold(HUMANOID.to_owned(), |text, link| {
        with_shape(&text, link, "0.03 0 -0.05", "<box size='0.2 0.08 0.04'/>")
    })
}
