//! Which link follows which joint.

use dq8_robot::Joint;
use dq8_robot::urdf::Robot;
use mocap::clip::Clip;

/// A part of a body.
#[derive(Debug)]
pub(crate) struct Role {
    pub(crate) name: &'static str,
    /// The part that carries it.
    pub(crate) on: usize,
    /// Whether it hangs on that by a limb, whose direction is the same on every body.
    pub(crate) is_limb: bool,
    /// Weights of rotation and position.
    pub(crate) weights: [f64; 2],
    /// Common names of links, of links at the centre of the joint, and of joints of clips; `*` is
    /// the side.
    links: &'static [&'static str],
    centres: &'static [&'static str],
    joints: &'static [&'static str],
}

const fn role(
    (name, on, is_limb): (&'static str, usize, bool),
    weights: [f64; 2],
    links: &'static [&'static str],
    centres: &'static [&'static str],
    joints: &'static [&'static str],
) -> Role {
    Role { name, on, is_limb, weights, links, centres, joints }
}

macro_rules! limbs {
    ($($side:literal $first:literal)*) => {[
        role(("pelvis", 0, false), [1.0, 1.0], &["pelvis", "hips", "baselink", "base"], &[], &["hips", "pelvis", "root"]),
        role(("chest", 0, false), [0.0, 0.5], &["chest", "torso", "spine"], &[], &["spine3", "spine2", "chest", "spine1", "torso", "spine"]),
        role(("head", 1, false), [0.0, 0.5], &["head", "neck"], &[], &["head"]),
        $(
            role((concat!($side, "_shoulder"), 0, false), [0.0, 0.5], &["upperarm", "shoulderyaw"], &["shoulderroll", "shoulderpitch", "shoulder"], &["arm", "uparm", "upperarm"]),
            role((concat!($side, "_elbow"), $first, true), [0.1, 0.7], &["elbow", "elbowpitch", "forearm", "lowerarm"], &[], &["forearm", "lowarm", "lowerarm", "elbow"]),
            role((concat!($side, "_hand"), $first + 1, true), [0.0, 1.0], &["hand", "wristyaw", "rubberhand", "wrist"], &[], &["hand", "wrist"]),
            role((concat!($side, "_hip"), 0, false), [0.0, 0.5], &["thigh", "hipyaw", "upperleg"], &["hiproll", "hippitch", "hip"], &["upleg", "thigh", "upperleg", "hip"]),
            role((concat!($side, "_knee"), $first + 3, true), [0.0, 0.7], &["shin", "knee", "calf", "lowerleg"], &[], &["leg", "shin", "lowleg", "lowerleg", "calf", "knee"]),
            role((concat!($side, "_foot"), $first + 4, true), [0.5, 2.0], &["foot", "ankleroll", "ankle"], &[], &["foot", "ankle"]),
        )*
    ]};
}

pub(crate) const ROLES: [Role; 15] = limbs! { "left" 3 "right" 9 };

/// The fewest that tell where a body is.
const FEWEST: usize = 6;

/// A part that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    pub(crate) role: usize,
    pub(crate) link: usize,
    /// The link whose origin is its place.
    pub(crate) centre: usize,
    /// The joint of the clip.
    pub(crate) joint: usize,
}

/// By common names.
pub(crate) fn found(robot: &Robot, clip: &Clip) -> Result<Vec<Place>, String> {
    let links: Vec<_> = robot.link_names().iter().map(|name| plain(name)).collect();
    let joints: Vec<_> = clip.joints.iter().map(|joint| plain(&joint.name)).collect();
    let mut places = Vec::new();
    for (index, role) in ROLES.iter().enumerate() {
        let find = |names: &[String], common: &[&str]| find(names, side(role), common);
        if let (Some(link), Some(joint)) = (find(&links, role.links), find(&joints, role.joints)) {
            let centre = find(&links, role.centres).unwrap_or(link);
            let link =
                if role.name.ends_with("foot") { last_of_the_ankle(robot, link) } else { link };
            let centre = if role.centres.is_empty() { link } else { centre };
            places.push(Place { role: index, link, centre, joint });
        }
    }
    enough(places, robot, clip)
}

/// Returns the link that has the sole: the last one of a chain of hinges. Some ankles roll first
/// and pitch then, and their names tell nothing about the order. Toes are not of the chain.
fn last_of_the_ankle(robot: &Robot, mut link: usize) -> usize {
    loop {
        let carried = |(_, joint): &(usize, &Joint<f64>)| {
            joint.parent == Some(link) && joint.kind.values() > 0
        };
        let mut hinges = robot.joints().iter().enumerate().filter(carried);
        match (hinges.next(), hinges.next()) {
            (Some((next, _)), None) if !plain(&robot.link_names()[next]).contains("toe") => {
                link = next;
            }
            _ => return link,
        }
    }
}

/// From lines of `ROLE LINK[@CENTRE] JOINT`.
pub(crate) fn read(text: &str, robot: &Robot, clip: &Clip) -> Result<Vec<Place>, String> {
    let mut places: Vec<Place> = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let words: Vec<_> = line.split('#').next().unwrap_or_default().split_whitespace().collect();
        let [role, link, joint] = words[..] else {
            if words.is_empty() {
                continue;
            }
            return Err(format!("line {}: not ROLE LINK[@CENTRE] JOINT: {line}", number + 1));
        };
        let unknown = |what: &str, name: &str, names: Vec<&str>| {
            format!("line {}: no {what} {name:?}; there are {}", number + 1, names.join(", "))
        };
        let roles = ROLES.iter().position(|known| known.name == role);
        let all = || ROLES.iter().map(|role| role.name).collect();
        let role = roles.ok_or_else(|| unknown("role", role, all()))?;
        let find =
            |name: &str| robot.link(name).ok_or_else(|| unknown("link", name, link_names(robot)));
        let (link, centre) = link.split_once('@').unwrap_or((link, link));
        let (link, centre) = (find(link)?, find(centre)?);
        let joints = clip.joints.iter().position(|known| known.name == joint);
        let joint = joints.ok_or_else(|| unknown("joint", joint, joint_names(clip)))?;
        if places.iter().any(|place| place.role == role) {
            return Err(format!("line {}: a second {}", number + 1, ROLES[role].name));
        }
        places.push(Place { role, link, centre, joint });
    }
    places.sort_by_key(|place| place.role);
    enough(places, robot, clip)
}

fn enough(places: Vec<Place>, robot: &Robot, clip: &Clip) -> Result<Vec<Place>, String> {
    let has = |role: usize| places.iter().any(|place| place.role == role);
    let missing: Vec<_> = ROLES
        .iter()
        .enumerate()
        .filter(|(role, _)| !has(*role))
        .map(|(_, role)| role.name)
        .collect();
    // Which way it faces is told by what is left and what is right.
    let faces = (3..9).any(|left| has(left) && has(left + 6));
    if places.len() >= FEWEST && has(0) && (has(1) || has(2)) && faces {
        return Ok(places);
    }
    Err(format!(
        "too little is known of where the body is: pelvis, chest or head, a pair of limbs, {FEWEST} in all. Not found: {}.\n\
         Name them in a file (--map). Links: {}.\nJoints: {}.",
        missing.join(", "),
        link_names(robot).join(", "),
        joint_names(clip).join(", "),
    ))
}

fn link_names(robot: &Robot) -> Vec<&str> {
    robot.link_names().iter().map(String::as_str).collect()
}

fn joint_names(clip: &Clip) -> Vec<&str> {
    clip.joints.iter().filter(|joint| !joint.end_site).map(|joint| joint.name.as_str()).collect()
}

fn side(role: &Role) -> Option<&'static str> {
    role.name.split_once('_').map(|(side, _)| side)
}

/// Letters and digits, without the word link, and without the name of the biped that 3ds Max writes
/// before each joint (`Bip01 L UpperArm`).
fn plain(name: &str) -> String {
    let plain: String = name.chars().filter(char::is_ascii_alphanumeric).collect();
    let plain = plain.to_lowercase();
    let biped =
        plain.strip_prefix("bip").map(|rest| rest.trim_start_matches(|c: char| c.is_ascii_digit()));
    let plain =
        biped.filter(|rest| rest.len() + 3 < plain.len() && !rest.is_empty()).unwrap_or(&plain);
    plain.strip_suffix("link").unwrap_or(plain).to_owned()
}

/// The first common name that there is; of those in words with a prefix, `mixamorig:LeftArm`, what
/// they end in.
fn find(names: &[String], side: Option<&str>, common: &[&str]) -> Option<usize> {
    common.iter().find_map(|common| {
        let forms = match side {
            None => vec![(*common).to_owned()],
            Some(side) => vec![
                format!("{side}{common}"),
                format!("{}{common}", &side[..1]),
                format!("{common}{side}"),
                format!("{common}{}", &side[..1]),
            ],
        };
        let is = |form: &String| names.iter().position(|name| name == form);
        let ends = |form: &String| names.iter().position(|name| name.ends_with(form.as_str()));
        forms.iter().find_map(is).or_else(|| forms.first().and_then(ends))
    })
}
