//! The skeleton: 64 joints in twelve levels, numbered depth first as in a BVH file.
//!
//! The 31 joints of the CMU motion capture skeleton (its ASF files), five fingers of three joints
//! on each hand, where game skeletons have them, and jaw and eyes on the head.

use dq8::{DualQuat, Hierarchy, Quat};
use dq8_fixtures::random::Random;

const ROOT: &str = "";

/// A joint, its parent, and how far from it, in metres.
type Joint = (&'static str, &'static str, f64);

const LEG: [Joint; 5] = [
    ("hip joint", "root", 0.10),
    ("femur", "hip joint", 0.02),
    ("tibia", "femur", 0.44),
    ("foot", "tibia", 0.44),
    ("toes", "foot", 0.14),
];

const SPINE: [Joint; 9] = [
    ("lower back", "root", 0.05),
    ("upper back", "lower back", 0.12),
    ("thorax", "upper back", 0.12),
    ("lower neck", "thorax", 0.12),
    ("upper neck", "lower neck", 0.08),
    ("head", "upper neck", 0.08),
    ("jaw", "head", 0.04),
    ("left eye", "head", 0.08),
    ("right eye", "head", 0.08),
];

const ARM: [Joint; 22] = [
    ("clavicle", "thorax", 0.10),
    ("humerus", "clavicle", 0.17),
    ("radius", "humerus", 0.29),
    ("wrist", "radius", 0.18),
    ("hand", "wrist", 0.09),
    ("fingers", "hand", 0.08),
    ("index 1", "hand", 0.08),
    ("index 2", "index 1", 0.04),
    ("index 3", "index 2", 0.03),
    ("middle 1", "hand", 0.08),
    ("middle 2", "middle 1", 0.05),
    ("middle 3", "middle 2", 0.03),
    ("ring 1", "hand", 0.08),
    ("ring 2", "ring 1", 0.04),
    ("ring 3", "ring 2", 0.03),
    ("little 1", "hand", 0.07),
    ("little 2", "little 1", 0.03),
    ("little 3", "little 2", 0.02),
    ("thumb", "wrist", 0.03),
    ("thumb 1", "thumb", 0.03),
    ("thumb 2", "thumb 1", 0.04),
    ("thumb 3", "thumb 2", 0.03),
];

pub const JOINTS: usize = 1 + 2 * LEG.len() + SPINE.len() + 2 * ARM.len();
const _: () = assert!(JOINTS == 64);

fn joints() -> Vec<Joint> {
    // Of two joints of the same name a child finds the later one, which is that of its own side.
    [[("root", ROOT, 0.0)].as_slice(), &LEG, &LEG, &SPINE, &ARM, &ARM].concat()
}

pub fn parents() -> Vec<u32> {
    let joints = joints();
    let before =
        |joint: usize, name| joints[..joint].iter().rposition(|&(other, ..)| other == name);
    let parent = |(joint, &(_, parent, _))| match before(joint, parent) {
        Some(index) => u32::try_from(index).expect("few joints"),
        None => Hierarchy::ROOT,
    };
    joints.iter().enumerate().map(parent).collect()
}

/// How far every joint is from its parent; `None` for roots.
pub fn bones() -> Vec<Option<f64>> {
    joints().iter().map(|&(_, parent, length)| (parent != ROOT).then_some(length)).collect()
}

/// Local poses, `[instance][joint]`: any turn up to a radian at every joint, bones that are the
/// same in all instances, and the roots on a ground of ten metres. Computed in `f64` and rounded
/// once.
pub fn locals(bones: &[Option<f64>], instances: usize) -> Vec<DualQuat<f32>> {
    let mut random = Random(8);
    let bones: Vec<Option<[f64; 3]>> = bones
        .iter()
        .map(|bone| bone.map(|length| random.direction().map(|c| c * length)))
        .collect();
    let mut locals = Vec::with_capacity(instances * bones.len());
    for _ in 0..instances {
        for bone in &bones {
            let turn = Quat::from_axis_angle(random.direction(), random.between(-1.0, 1.0));
            let offset =
                bone.unwrap_or_else(|| [random.between(-5.0, 5.0), 1.0, random.between(-5.0, 5.0)]);
            locals.push(DualQuat::from_rotation_translation(turn, offset).cast());
        }
    }
    locals
}
