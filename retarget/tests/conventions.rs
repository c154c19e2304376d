//! The same walk in the conventions of several programs.

mod common;

use common::{HUMANOID, humanoid, person, with_soles};
use dq8::Quat;
use dq8::scalar::vector::{norm, sub};
use dq8_retarget::{
    Clip, Humanoid, Person, Report, RetargetError, Role, Settings, Targets, retarget,
};
use mocap::biped;
use mocap::clip::{Axis, Channel, Joint};

fn plain(person: &Person) -> Report {
    retarget(person, &humanoid(), &Settings::plain()).unwrap().report
}

fn values(clip: &Clip) -> Vec<f64> {
    retarget(&person(clip), &humanoid(), &Settings::plain()).unwrap().values
}

/// The walk of the biped, in whose file these joints have position channels that repeat their
/// offsets.
fn with_positions(of: impl Fn(&Joint) -> bool) -> Clip {
    let clip = biped::clip();
    let mut moved = Clip { joints: clip.joints.clone(), values: vec![], ..clip.clone() };
    let has = |joint: &Joint| {
        let positions =
            joint.channels.iter().any(|channel| matches!(channel, Channel::Position(_)));
        !joint.end_site && !positions && of(joint)
    };
    for joint in moved.joints.iter_mut().filter(|joint| has(joint)) {
        let positions = [Axis::X, Axis::Y, Axis::Z].map(Channel::Position);
        joint.channels.splice(..0, positions);
    }
    for frame in clip.values.chunks_exact(clip.channels()) {
        let mut values = frame.iter();
        for joint in &clip.joints {
            if has(joint) {
                moved.values.extend(joint.offset);
            }
            moved.values.extend(values.by_ref().take(joint.channels.len()));
        }
    }
    moved
}

/// The same motion with axes along the bones, as in LAFAN1: with all channels zero, the skeleton is
/// a straight line along x.
fn along_bones(clip: &Clip) -> Clip {
    let first_child = |joint: usize| {
        clip.joints.iter().find(|child| child.parent == Some(joint)).map(|child| child.offset)
    };
    let frames: Vec<Quat<f64>> = (0..clip.joints.len())
        .map(|joint| match first_child(joint) {
            Some(bone) if norm(bone) > 0.0 => {
                let length = norm(bone);
                Quat::from_rotation_arc([1.0, 0.0, 0.0], bone.map(|number| number / length))
            }
            _ => Quat::IDENTITY,
        })
        .collect();
    let above = |joint: &Joint| joint.parent.map_or(Quat::IDENTITY, |parent| frames[parent]);
    let mut joints = clip.joints.clone();
    for joint in &mut joints {
        joint.offset = above(joint).conjugate().rotate(joint.offset);
        if !joint.end_site {
            let turns = [Axis::Z, Axis::Y, Axis::X].map(Channel::Rotation);
            let ways = [Axis::X, Axis::Y, Axis::Z].map(Channel::Position);
            let ways = if joint.parent.is_none() { &ways[..] } else { &[] };
            joint.channels = ways.iter().chain(&turns).copied().collect();
        }
    }
    let mut values = Vec::new();
    for poses in clip.locals().chunks_exact(joints.len()) {
        for ((pose, joint), &frame) in poses.iter().zip(&clip.joints).zip(&frames) {
            if joint.end_site {
                continue;
            }
            if joint.parent.is_none() {
                values.extend(pose.translation());
            }
            let turn = above(joint).conjugate() * pose.rotation() * frame;
            let [roll, pitch, yaw] = turn.normalize().to_rpy();
            values.extend([yaw, pitch, roll].map(f64::to_degrees));
        }
    }
    Clip { joints, values, ..clip.clone() }
}

/// Every other frame, as a file of half the rate has them.
fn halved(clip: &Clip) -> Clip {
    let frames = clip.values.chunks_exact(clip.channels()).step_by(2);
    let values = frames.flatten().copied().collect();
    Clip { values, frame_time: 2.0 * clip.frame_time, ..clip.clone() }
}

#[test]
fn position_channels_that_repeat_offsets_change_nothing() {
    let plain = values(&biped::clip());
    assert_eq!(values(&with_positions(|joint| joint.name == "Chest")), plain);
    assert_eq!(values(&with_positions(|_| true)), plain);
}

#[test]
fn a_motion_is_followed_as_well_in_every_convention_of_files() {
    let biped = biped::clip();
    let own = plain(&person(&biped)).residual;
    for (name, clip) in [
        ("axes along bones", along_bones(&biped)),
        ("six channels for each joint", with_positions(|_| true)),
        ("half the rate", halved(&biped)),
    ] {
        // Other frames than the zero pose make other rests, by fractions of a millimetre.
        let other = plain(&person(&clip)).residual;
        assert!((other - own).abs() < 0.5, "{name}: {other} mm, {own} mm");
    }
}

/// The residuals of the clip from this frame on, with held feet: as it is, and with axes along
/// bones.
fn residuals_from(first: usize) -> (f64, f64) {
    let biped = biped::clip();
    let values = biped.values[first * biped.channels()..].to_vec();
    let clip = Clip { values, ..biped };
    let residual = |clip: &Clip| {
        let motion = retarget(&person(clip), &humanoid(), &Settings::default()).unwrap();
        motion.report.residual
    };
    (residual(&clip), residual(&along_bones(&clip)))
}

#[test]
fn held_feet_are_followed_as_well_where_the_rest_pose_is_a_step() {
    for first in [0, 80] {
        let (own, other) = residuals_from(first);
        // Feet of the step are not flat: without their level the robot stands 30 mm too high.
        assert!((other - own).abs() < 1.5, "{first}: {other} mm, {own} mm");
    }
}

#[test]
fn a_clip_that_begins_with_a_step_is_followed_as_well_as_one_whose_rest_pose_is_known() {
    for first in [0, 80] {
        let (own, other) = residuals_from(first);
        assert!(other < 1.05 * own, "{first}: {other} mm, {own} mm");
    }
}

/// The same motion, turned by half a turn about up from this frame on.
fn turned_from(clip: &Clip, frame: usize) -> Clip {
    let mut turned = clip.clone();
    for values in turned.values.chunks_exact_mut(clip.channels()).skip(frame) {
        // The position of the root (x, y and z, of which y is up), and its turns about z, y and x.
        let [across, _, along, yaw, pitch, roll] = &mut values[..6] else { unreachable!() };
        (*across, *along) = (-*across, -*along);
        let [x, y, z] = [*roll, *pitch, *yaw].map(f64::to_radians);
        let own = Quat::from_rpy(x, y, z);
        let turn = Quat::from_array([0.0, 1.0, 0.0, 0.0]) * own;
        [*roll, *pitch, *yaw] = turn.to_rpy().map(f64::to_degrees);
    }
    turned
}

#[test]
fn the_rest_pose_of_a_person_who_turns_around_is_that_of_one_who_does_not() {
    let clip = along_bones(&biped::clip());
    let own = plain(&person(&clip)).residual;
    for frame in [1, 128, 255] {
        let other = plain(&person(&turned_from(&clip, frame))).residual;
        // Of a frame that is interpolated while the person turns, a little is another.
        assert!((other - own).abs() < 0.01, "{frame}: {other} mm, {own} mm");
    }
}

#[test]
fn names_of_other_programs_are_found() {
    let mut clip = biped::clip();
    for joint in &mut clip.joints {
        let other =
            joint.name.replace("Thigh", "UpLeg").replace("Shin", "Leg").replace("Pelvis", "Hips");
        joint.name = format!("mixamorig:{other}");
    }
    let person = person(&clip);
    assert!(Role::ALL.into_iter().all(|role| person.joint(role).is_some()));
}

#[test]
fn names_of_3ds_max_are_found() {
    let mut clip = biped::clip();
    let names = [
        ("Pelvis", "Bip01 Pelvis", Role::Pelvis),
        ("Chest", "Bip01 Spine2", Role::Chest),
        ("Head", "Bip01 Head", Role::Head),
        ("LeftThigh", "Bip01 L Thigh", Role::LeftHip),
        ("RightThigh", "Bip01 R Thigh", Role::RightHip),
        ("LeftShin", "Bip01 L Calf", Role::LeftKnee),
        ("RightShin", "Bip01 R Calf", Role::RightKnee),
        ("LeftFoot", "Bip01 L Foot", Role::LeftFoot),
        ("RightFoot", "Bip01 R Foot", Role::RightFoot),
        ("LeftHand", "Bip01 L Hand", Role::LeftHand),
        ("RightHand", "Bip01 R Hand", Role::RightHand),
    ];
    for (index, joint) in clip.joints.iter_mut().enumerate() {
        match names.iter().find(|(name, ..)| *name == joint.name) {
            Some((_, other, _)) => joint.name = (*other).to_owned(),
            None => joint.name = format!("Bip01 x{index}"),
        }
    }
    let person = person(&clip);
    for (_, name, role) in names {
        let joint = person.joint(role).unwrap();
        assert_eq!(person.joint_names()[joint], name);
    }
    assert_eq!(person.joint(Role::LeftElbow), None);
}

#[test]
fn where_no_rest_pose_is_the_error_names_the_option_that_gives_one() {
    // A walk on the hands, in which no joint turns: the skeleton is the straight line in every
    // frame.
    let mut upside_down = along_bones(&biped::clip());
    let legs = ["LeftThigh", "RightThigh"];
    for joint in upside_down.joints.iter_mut().filter(|joint| legs.contains(&&*joint.name)) {
        joint.offset = joint.offset.map(|number| -number);
    }
    let channels = upside_down.channels();
    for frame in upside_down.values.chunks_exact_mut(channels) {
        frame[3..].fill(0.0);
    }
    let targets = |clip: &Clip, rest: Option<usize>| {
        Targets::new(&person(clip), &humanoid(), &Settings { rest, ..Settings::plain() })
    };
    let error = targets(&upside_down, None).unwrap_err();
    assert!(matches!(error, RetargetError::NoRest), "{error}");
    assert!(error.to_string().contains("rest pose"));
    let error = targets(&biped::clip(), Some(100_000)).unwrap_err();
    assert!(matches!(error, RetargetError::RestFrame { asked: 100_000, frames: 256 }), "{error}");
    assert!(!targets(&biped::clip(), Some(7)).unwrap().told.is_empty());
}

#[test]
fn soles_stand_at_height_zero() {
    let humanoid = Humanoid::from_urdf(&with_soles()).unwrap();
    let person = person(&biped::clip());
    let report = retarget(&person, &humanoid, &Settings::plain()).unwrap().report;
    assert!(report.ground.abs() < 2.0, "{report}");
    // The height of an ankle that is given counts in place of the shapes.
    let settings = Settings { ankle: Some(0.17), ..Settings::plain() };
    let [low, high] = [Settings::plain(), settings]
        .map(|settings| Targets::new(&person, &humanoid, &settings).unwrap().poses[0]);
    let lift = high.translation()[2] - low.translation()[2];
    assert!((lift - 0.1).abs() < 0.005, "{lift}");
}

#[test]
fn edges_of_soles_are_not_known_where_soles_are_points() {
    // The robot has links that are called soles, and no shapes.
    for (urdf, known) in [(HUMANOID, false), (&with_soles(), true)] {
        let humanoid = Humanoid::from_urdf(urdf).unwrap();
        let person = person(&biped::clip());
        let report = retarget(&person, &humanoid, &Settings::default()).unwrap().report;
        assert_eq!(report.edges, known);
        assert_eq!(report.to_string().contains("edges are not known"), !known, "{report}");
    }
}

#[test]
fn a_robot_with_a_floating_joint_of_its_own_gets_no_second_one() {
    let body = HUMANOID.find("<link name=\"pelvis\"").unwrap();
    let floor = "<link name='world'/><joint name='free' type='floating'><parent link='world'/><child link='pelvis'/></joint>";
    let text = format!("{}{floor}{}", &HUMANOID[..body], &HUMANOID[body..]);
    let own = Humanoid::from_urdf(&text).unwrap();
    assert_eq!(own.robot().mechanism().values(), humanoid().robot().mechanism().values());
    let report = retarget(&person(&biped::clip()), &own, &Settings::plain()).unwrap().report;
    assert!(report.residual < 15.0, "{report}");
}

#[test]
fn a_table_names_joints_and_says_what_is_wrong_in_it() {
    let own = person(&biped::clip());
    let table = "[joints]\nleft_hand = \"LeftForearm\"\n";
    let joint = own.clone().with_table(table).unwrap().joint(Role::LeftHand).unwrap();
    assert_eq!(own.joint_names()[joint], "LeftForearm");
    for (bad, word) in [
        ("[joints]\nleft_hand = \"Hand\"", "Pelvis, "),
        ("[joints]\nhand = \"LeftHand\"", "left_hand"),
        ("[joint]\nleft_hand = \"LeftHand\"", "[joints]"),
        ("[joints]\nleft_hand = 3", "the name of a joint"),
        ("[joints", "line 1"),
    ] {
        let error = own.clone().with_table(bad).unwrap_err();
        assert!(matches!(error, RetargetError::Table { .. }), "{bad}: {error}");
        assert!(error.to_string().contains(word), "{bad}: {error}");
    }
}

#[test]
fn times_between_frames_keep_the_lengths_of_bones() {
    let clip = biped::clip();
    let settings = Settings { fps: 3.0 / clip.frame_time, ..Settings::plain() };
    let skeleton = Targets::new(&person(&clip), &humanoid(), &settings).unwrap().skeleton;
    let joints = clip.joints.len();
    assert_eq!(skeleton.len(), (3 * (clip.frames() - 1) + 1) * joints);
    let lengths = |frame: usize| -> Vec<f64> {
        let at = &skeleton[frame * joints..][..joints];
        let bones =
            clip.joints.iter().enumerate().filter_map(|(j, joint)| Some((j, joint.parent?)));
        bones.map(|(joint, parent)| norm(sub(at[joint], at[parent]))).collect()
    };
    for (between, own) in lengths(16).iter().zip(lengths(15)) {
        assert!((between - own).abs() < 1e-12);
    }
}
