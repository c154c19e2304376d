//! The biped of Kenwright §10.2: 16 links with 36 degrees of freedom. He names the two numbers and
//! shows a figure; lengths, axes and the walk (`walk`) are invented here, after a person of
//! 1.75 m. Metres, y is up, z is forward.

mod walk;

use Axis::{X, Y, Z};
use Channel::{Position, Rotation};
use dq8_bvh::{Axis, Channel, Clip, Joint};
use walk::Walk;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Left,
    Right,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Pelvis,
    Abdomen,
    Chest,
    Head,
    UpperArm(Side),
    Forearm(Side),
    Hand(Side),
    Thigh(Side),
    Shin(Side),
    Foot(Side),
}

/// A rigid link and the joint that hangs it on its parent.
struct Link {
    name: &'static str,
    part: Part,
    parent: Option<Part>,
    offset: [f64; 3],
    /// The degrees of freedom of that joint.
    freedom: &'static [Channel],
    /// The far end, where no other link begins.
    tip: Option<[f64; 3]>,
}

const FREE: &[Channel] =
    &[Position(X), Position(Y), Position(Z), Rotation(Y), Rotation(Z), Rotation(X)];
/// Turn, lean sideways, bend.
const BALL: &[Channel] = &[Rotation(Y), Rotation(Z), Rotation(X)];
/// Turn and nod.
const NECK: &[Channel] = &[Rotation(Y), Rotation(X)];
const HINGE: &[Channel] = &[Rotation(X)];
/// Up and down, and sole inward.
const ANKLE: &[Channel] = &[Rotation(X), Rotation(Z)];

const THIGH: f64 = 0.44;
const SHIN: f64 = 0.44;
/// The ankle above the sole.
const ANKLE_HEIGHT: f64 = 0.08;

// Where joints and tips lie in the axes of their links. Paired ones are the left ones.
const WAIST: [f64; 3] = [0.0, 0.10, 0.0];
const RIBS: [f64; 3] = [0.0, 0.17, 0.0];
const NAPE: [f64; 3] = [0.0, 0.30, 0.0];
const CROWN: [f64; 3] = [0.0, 0.24, 0.0];
const SHOULDER: [f64; 3] = [0.19, 0.23, 0.0];
const ELBOW: [f64; 3] = [0.0, -0.30, 0.0];
const WRIST: [f64; 3] = [0.0, -0.26, 0.0];
const FINGERS: [f64; 3] = [0.0, -0.17, 0.0];
const HIP: [f64; 3] = [0.09, -0.02, 0.0];
const KNEE: [f64; 3] = [0.0, -THIGH, 0.0];
const TALUS: [f64; 3] = [0.0, -SHIN, 0.0];
const TOE: [f64; 3] = [0.0, -ANKLE_HEIGHT, 0.19];
/// No tip of a link, but what the foot is set down on.
const HEEL: [f64; 3] = [0.0, -ANKLE_HEIGHT, -0.05];

use Part::{Abdomen, Chest, Foot, Forearm, Hand, Head, Pelvis, Shin, Thigh, UpperArm};
use Side::{Left, Right};

#[rustfmt::skip]
const LINKS: [Link; 16] = [
    link("Pelvis",        Pelvis,          None,                  [0.0; 3],        FREE,  None),
    link("Abdomen",       Abdomen,         Some(Pelvis),          WAIST,           BALL,  None),
    link("Chest",         Chest,           Some(Abdomen),         RIBS,            BALL,  None),
    link("Head",          Head,            Some(Chest),           NAPE,            NECK,  Some(CROWN)),
    link("LeftUpperArm",  UpperArm(Left),  Some(Chest),           SHOULDER,        BALL,  None),
    link("LeftForearm",   Forearm(Left),   Some(UpperArm(Left)),  ELBOW,           HINGE, None),
    link("LeftHand",      Hand(Left),      Some(Forearm(Left)),   WRIST,           HINGE, Some(FINGERS)),
    link("RightUpperArm", UpperArm(Right), Some(Chest),           right(SHOULDER), BALL,  None),
    link("RightForearm",  Forearm(Right),  Some(UpperArm(Right)), right(ELBOW),    HINGE, None),
    link("RightHand",     Hand(Right),     Some(Forearm(Right)),  right(WRIST),    HINGE, Some(FINGERS)),
    link("LeftThigh",     Thigh(Left),     Some(Pelvis),          HIP,             BALL,  None),
    link("LeftShin",      Shin(Left),      Some(Thigh(Left)),     KNEE,            HINGE, None),
    link("LeftFoot",      Foot(Left),      Some(Shin(Left)),      TALUS,           ANKLE, Some(TOE)),
    link("RightThigh",    Thigh(Right),    Some(Pelvis),          right(HIP),      BALL,  None),
    link("RightShin",     Shin(Right),     Some(Thigh(Right)),    right(KNEE),     HINGE, None),
    link("RightFoot",     Foot(Right),     Some(Shin(Right)),     right(TALUS),    ANKLE, Some(TOE)),
];

const fn link(
    name: &'static str,
    part: Part,
    parent: Option<Part>,
    offset: [f64; 3],
    freedom: &'static [Channel],
    tip: Option<[f64; 3]>,
) -> Link {
    Link { name, part, parent, offset, freedom, tip }
}

/// The right one of a pair.
const fn right([x, y, z]: [f64; 3]) -> [f64; 3] {
    [-x, y, z]
}

/// Four whole cycles of the walk at 60 Hz.
pub fn clip() -> Clip {
    const FRAMES: usize = 256;
    let walk = Walk { period: 64.0 / 60.0 };
    let frame_time = 1.0 / 60.0;
    let mut values = Vec::new();
    for frame in 0..FRAMES {
        let pose = walk.pose(frame as f64 * frame_time);
        for link in &LINKS {
            values.extend(link.freedom.iter().map(|&channel| pose.value(link.part, channel)));
        }
    }
    Clip {
        title: "Biped, 16 links, 36 degrees of freedom".into(),
        joints: joints(),
        frame_time,
        values,
    }
}

fn joints() -> Vec<Joint> {
    let mut joints: Vec<Joint> = Vec::new();
    // Where each link's joint stands in the list, among the end sites.
    let mut index_of: Vec<(Part, usize)> = Vec::new();
    for link in &LINKS {
        let parent = link.parent.and_then(|parent| {
            index_of.iter().find(|(part, _)| *part == parent).map(|&(_, index)| index)
        });
        let index = joints.len();
        index_of.push((link.part, index));
        joints.push(Joint::new(link.name, parent, link.offset, link.freedom.to_vec()));
        if let Some(offset) = link.tip {
            let tip = Joint::new(format!("{}_End", link.name), Some(index), offset, vec![]);
            joints.push(Joint { end_site: true, ..tip });
        }
    }
    joints
}

#[cfg(test)]
mod tests {
    use super::{HEEL, LINKS, clip};
    use dq8_bvh::{Axis, Channel, Clip};

    fn joint(clip: &Clip, name: &str) -> usize {
        clip.joints.iter().position(|joint| joint.name == name).unwrap()
    }

    /// The values of one channel of one link, frame by frame.
    fn values(clip: &Clip, name: &str, channel: Channel) -> Vec<f64> {
        let before: usize =
            clip.joints[..joint(clip, name)].iter().map(|joint| joint.channels.len()).sum();
        let place =
            clip.joints[joint(clip, name)].channels.iter().position(|c| *c == channel).unwrap();
        clip.values.iter().skip(before + place).step_by(clip.channels()).copied().collect()
    }

    #[test]
    fn sixteen_links_with_36_degrees_of_freedom() {
        let clip = clip();
        assert_eq!(clip.joints.len() - clip.end_sites(), 16);
        assert_eq!((clip.channels(), clip.end_sites(), clip.frames()), (36, 5, 256));
        for (link, joint) in LINKS.iter().zip(clip.joints.iter().filter(|joint| !joint.end_site)) {
            assert_eq!(
                (link.name, link.parent.is_none()),
                (joint.name.as_str(), joint.parent.is_none())
            );
        }
    }

    #[test]
    fn the_feet_stand_on_the_ground_without_sliding() {
        let clip = clip();
        let models = clip.models().unwrap();
        let joints = clip.joints.len();
        for foot in ["LeftFoot", "RightFoot"] {
            let [foot, toe] = [joint(&clip, foot), joint(&clip, &format!("{foot}_End"))];
            let frames = models.chunks_exact(joints).map(|frame| {
                let soles = [frame[foot].transform_point(HEEL), frame[toe].translation()];
                assert!(soles.iter().all(|sole| sole[1] > -0.002), "{soles:?}");
                soles
            });
            let frames: Vec<_> = frames.collect();
            let mut standing = 0;
            for pair in frames.windows(2) {
                for (before, after) in pair[0].iter().zip(&pair[1]) {
                    if before[1] < 0.002 && after[1] < 0.002 {
                        standing += 1;
                        let slide = (after[0] - before[0]).hypot(after[2] - before[2]);
                        assert!(slide < 0.002, "{before:?} {after:?}");
                    }
                }
            }
            // Heel and toes: each stands for about half of the time.
            assert!((200..300).contains(&standing), "{standing}");
        }
    }

    #[test]
    fn joints_stay_within_what_a_person_can_do() {
        let clip = clip();
        let x = Channel::Rotation(Axis::X);
        for side in ["Left", "Right"] {
            for (name, range) in
                [("Thigh", -50.0..25.0), ("Shin", 5.0..75.0), ("Foot", -30.0..20.0)]
            {
                let values = values(&clip, &format!("{side}{name}"), x);
                assert!(
                    values.iter().all(|value| range.contains(value)),
                    "{side}{name}: {values:?}"
                );
            }
        }
    }

    #[test]
    fn nothing_jumps_also_where_the_walk_begins_again() {
        let clip = clip();
        let models = clip.models().unwrap();
        let joints = clip.joints.len();
        let frame = |index: usize| {
            models[index * joints..][..joints].iter().map(|model| model.translation())
        };
        for index in 1..clip.frames() {
            for (a, b) in frame(index - 1).zip(frame(index)) {
                let step = (0..3).map(|axis| (b[axis] - a[axis]).powi(2)).sum::<f64>().sqrt();
                assert!(step < 0.09, "{index}: {step}");
            }
        }
        // The last frame is followed by the first, four strides on: every angle returns.
        let turns = values(&clip, "Pelvis", Channel::Rotation(Axis::Y));
        assert!((turns[0] - turns[64]).abs() < 1e-9);
    }
}
