//! Which side of the body a joint belongs to, as far as its name tells.

use dq8_bvh::Clip;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Left,
    Right,
    Middle,
}

/// One for each joint. A joint whose name names no side is on that of its parent: the toes of a
/// left foot.
pub fn sides(clip: &Clip) -> Vec<Side> {
    let mut sides: Vec<Side> = Vec::with_capacity(clip.joints.len());
    for joint in &clip.joints {
        let parents = joint.parent.map_or(Side::Middle, |parent| sides[parent]);
        sides.push(named(&joint.name).unwrap_or(parents));
    }
    sides
}

/// `LeftArm`, `l_arm`, `Arm.L`, `Bip01 L UpperArm`, `LHipJoint`.
fn named(name: &str) -> Option<Side> {
    let lower = name.to_lowercase();
    let letter = |letter: char| {
        let mut words = lower.split(|c: char| !c.is_alphanumeric());
        let mut start = name.chars();
        words.any(|word| word.chars().eq([letter]))
            || (start.next() == Some(letter.to_ascii_uppercase())
                && start.next().is_some_and(char::is_uppercase))
    };
    if lower.contains("left") || letter('l') {
        Some(Side::Left)
    } else if lower.contains("right") || letter('r') {
        Some(Side::Right)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::{Side, named};

    #[test]
    fn the_usual_ways_to_name_a_side() {
        for name in
            ["LeftArm", "mixamorig:leftArm", "l_arm", "Arm.L", "Bip01 L UpperArm", "LHipJoint"]
        {
            assert_eq!(named(name), Some(Side::Left), "{name}");
        }
        for name in ["RightArm", "arm_R", "RThumb", "thigh.r"] {
            assert_eq!(named(name), Some(Side::Right), "{name}");
        }
        for name in ["LowerBack", "Root", "Hips", "Spine1", "L", ""] {
            assert_eq!(named(name).is_some(), name == "L", "{name}");
        }
    }
}
