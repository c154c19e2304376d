//! The embedded biped on the repository's humanoid.

use crate::map::{self, Place, ROLES};
use crate::measure::Quality;
use crate::rest::Rest;
use crate::scene::{Scene, Wishes};
use crate::{Args, parse, picture, table, track, with_floating_base};
use dq8::scalar::vector::{norm, sub};
use dq8::{DualQuat, Quat};
use dq8_fixtures::legible::illegible;
use dq8_robot::urdf::Robot;
use mocap::biped;
use mocap::clip::{Axis, Channel, Clip, Joint};
use mocap::command::Request;

const HUMANOID: &str = include_str!("../../robot/robots/humanoid.urdf");

const WISHES: Wishes<'_> = Wishes { fps: 30.0, rest: None, ankle: None, urdf: HUMANOID };

fn robot() -> Robot {
    Robot::from_urdf(HUMANOID).unwrap().floating().unwrap()
}

fn scene(clip: Clip, wishes: Wishes<'_>) -> Scene {
    let places = map::found(&robot(), &clip).unwrap();
    Scene::new(robot(), clip, places, wishes).unwrap()
}

#[test]
fn the_walk_of_the_biped_is_followed_within_limits() {
    let places = map::found(&robot(), &biped::clip()).unwrap();
    assert_eq!(places.len(), ROLES.len());
    let scene = Scene::new(robot(), biped::clip(), places, WISHES).unwrap();
    let (motion, _) = track::one(&scene, &track::tracking(&scene), true, 1).unwrap();
    let Quality { mean, feet, beyond, .. } = Quality::of(&scene, &motion).unwrap();
    assert!(mean < 15.0 && feet < 3.0, "{mean} mm, feet {feet} mm");
    assert!(beyond <= 0.0, "{beyond}");
    let (several, _) = track::many::<f32>(&scene, &track::tracking(&scene), true).unwrap();
    let apart = motion.iter().zip(&several).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart < 2e-3, "{apart}");

    assert_eq!(table(&scene, &motion).unwrap().lines().count(), scene.frames() + 1);
    assert_eq!(illegible(&picture::draw(&scene, &motion).unwrap()), [""; 0]);
}

#[test]
fn a_file_names_links_and_joints_and_what_is_wrong_in_it_is_said_with_the_names_there_are() {
    let (robot, clip) = (robot(), biped::clip());
    let lines = "pelvis pelvis Pelvis # the root\n\nchest chest Chest\nleft_hip left_thigh@left_hip_roll LeftThigh\n\
                 right_hip right_thigh RightThigh\nleft_foot left_foot LeftFoot\nright_foot right_foot RightFoot\n";
    let places = map::read(lines, &robot, &clip).unwrap();
    assert_eq!(places.len(), 6);
    assert_eq!(robot.link_names()[places[2].centre], "left_hip_roll");
    for (good, bad, words) in [
        ("left_hip ", "hip ", ["line 4", "right_knee"]),
        ("left_thigh@", "left_thihg@", ["line 4", "left_shin"]),
        ("LeftThigh", "LeftThihg", ["line 4", "LeftShin"]),
        ("chest chest Chest", "chest chest", ["line 3", "ROLE LINK"]),
        ("chest chest Chest", "pelvis chest Chest", ["line 3", "second pelvis"]),
        ("left_foot left_foot LeftFoot", "", ["left_foot", "Links: pelvis, "]),
    ] {
        let error = map::read(&lines.replace(good, bad), &robot, &clip).unwrap_err();
        assert!(words.iter().all(|word| error.contains(word)), "{bad}: {error}");
    }
    let arm = Robot::from_urdf(include_str!("../../robot/robots/arm6.urdf")).unwrap();
    let error = map::found(&arm, &clip).unwrap_err();
    assert!(error.contains("Joints: Pelvis, Abdomen") && error.contains("left_hand"), "{error}");
}

#[test]
fn names_of_other_programs_are_found() {
    let mut clip = biped::clip();
    for joint in &mut clip.joints {
        let other =
            joint.name.replace("Thigh", "UpLeg").replace("Shin", "Leg").replace("Pelvis", "Hips");
        joint.name = format!("mixamorig:{other}");
    }
    assert_eq!(map::found(&robot(), &clip).unwrap().len(), ROLES.len());
}

#[test]
fn the_command_line_is_two_files_and_options() {
    let words = |line: &str| parse(line.split_whitespace().map(Into::into));
    let Ok(Request::Run(Args { fps, svg, .. })) = words("a.urdf --fps 60 b.bvh --svg c.svg") else {
        panic!("not understood")
    };
    assert_eq!((fps, svg), (60.0, Some("c.svg".into())));
    for wrong in [
        "",
        "a",
        "a b c",
        "a b --fps 0",
        "a b --fps x",
        "a b --rest -1",
        "a b --ankle inf",
        "a b --jpg c",
        "a b --csv",
    ] {
        assert!(words(wrong).is_err(), "{wrong}");
    }
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

#[test]
fn position_channels_that_repeat_offsets_change_nothing() {
    let follow = |clip: Clip| {
        let places = map::found(&robot(), &clip).unwrap();
        let scene = Scene::new(robot(), clip, places, WISHES).unwrap();
        track::one(&scene, &track::tracking(&scene), true, 1).unwrap().0
    };
    let plain = follow(biped::clip());
    assert_eq!(follow(with_positions(|joint| joint.name == "Chest")), plain);
    assert_eq!(follow(with_positions(|_| true)), plain);
}

#[test]
fn names_of_3ds_max_are_found_and_what_is_not_found_is_listed() {
    let mut clip = biped::clip();
    let names = [
        ("Pelvis", "Bip01 Pelvis"),
        ("Chest", "Bip01 Spine2"),
        ("Head", "Bip01 Head"),
        ("LeftThigh", "Bip01 L Thigh"),
        ("RightThigh", "Bip01 R Thigh"),
        ("LeftShin", "Bip01 L Calf"),
        ("RightShin", "Bip01 R Calf"),
        ("LeftFoot", "Bip01 L Foot"),
        ("RightFoot", "Bip01 R Foot"),
        ("LeftHand", "Bip01 L Hand"),
        ("RightHand", "Bip01 R Hand"),
    ];
    for joint in &mut clip.joints {
        match names.iter().find(|(name, _)| *name == joint.name) {
            Some((_, other)) => joint.name = (*other).to_owned(),
            None => joint.name = format!("Bip01 x{}", joint.name.len()),
        }
    }
    let places = map::found(&robot(), &clip).unwrap();
    let found: Vec<_> = places.iter().map(|place| ROLES[place.role].name).collect();
    for name in
        ["pelvis", "chest", "head", "left_hip", "right_hip", "left_knee", "right_foot", "left_hand"]
    {
        assert!(found.contains(&name), "{name}: {found:?}");
    }
    let text = Scene::new(robot(), clip, places, WISHES).unwrap().text();
    for role in ROLES.iter().filter(|role| !found.contains(&role.name)) {
        assert!(text.contains(&format!("{:<15} not found", role.name)), "{text}");
    }
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
fn a_motion_is_followed_as_well_in_every_convention_of_files() {
    let biped = biped::clip();
    let mean = |clip: Clip| {
        let scene = scene(clip, WISHES);
        let (motion, _) = track::one(&scene, &track::tracking(&scene), true, 1).unwrap();
        Quality::of(&scene, &motion).unwrap().mean
    };
    let plain = mean(biped.clone());
    for (name, clip) in [
        ("axes along bones", along_bones(&biped)),
        ("six channels for each joint", with_positions(|_| true)),
        ("half the rate", halved(&biped)),
    ] {
        // Other frames than the zero pose make other rests, by fractions of a millimetre.
        let other = mean(clip);
        assert!((other - plain).abs() < 0.5, "{name}: {other} mm, {plain} mm");
    }
}

#[test]
fn where_no_rest_pose_is_the_error_names_the_option_that_gives_one() {
    let places = |clip: &Clip| -> Vec<Place> { map::found(&robot(), clip).unwrap() };
    // A walk on the hands: all roots turned about the axis that points to the left.
    let mut upside_down = along_bones(&biped::clip());
    let legs = ["LeftThigh", "RightThigh"];
    for joint in upside_down.joints.iter_mut().filter(|joint| legs.contains(&&*joint.name)) {
        joint.offset = joint.offset.map(|number| -number);
    }
    let channels = upside_down.channels();
    for frame in upside_down.values.chunks_exact_mut(channels) {
        // No joint turns: the skeleton is the straight line in every frame.
        frame[3..].fill(0.0);
    }
    let error = Rest::of(&upside_down, &places(&upside_down), None).unwrap_err().to_string();
    assert!(error.contains("--rest FRAME"), "{error}");
    let clip = biped::clip();
    let error = Rest::of(&clip, &places(&clip), Some(100_000)).unwrap_err().to_string();
    assert!(error.contains("--rest 100000") && error.contains("frames"), "{error}");
    assert!(Rest::of(&clip, &places(&clip), Some(7)).unwrap().told.is_some());
}

/// The humanoid with boxes of collision under its feet, whose lower sides are 0.07 m below the
/// ankles.
fn with_soles() -> String {
    let sole = "<collision><origin xyz='0.03 0 -0.05'/><geometry><box size='0.2 0.08 0.04'/></geometry></collision></link>";
    ["left_foot", "right_foot"].iter().fold(HUMANOID.to_owned(), |text, name| {
        let start = text.find(&format!("<link name=\"{name}\"")).unwrap();
        let end = start + text[start..].find('>').unwrap();
        let open = text[..end].trim_end_matches('/').to_owned();
        let rest = match text[..end].ends_with('/') {
            true => text[end + 1..].to_owned(),
            false => text[end + 1..].replacen("</link>", "", 1),
        };
        format!("{open}>{sole}{rest}")
    })
}

#[test]
fn soles_stand_at_height_zero() {
    let urdf = with_soles();
    let robot = || Robot::from_urdf(&urdf).unwrap().floating().unwrap();
    let clip = biped::clip();
    let places = map::found(&robot(), &clip).unwrap();
    let scene = Scene::new(robot(), clip, places, Wishes { urdf: &urdf, ..WISHES }).unwrap();
    let feet = scene.places.iter().enumerate().filter(|(_, place)| crate::ground::is_foot(place));
    for (foot, _) in feet {
        let course = scene.targets.iter().skip(foot).step_by(scene.goals.len());
        let places: Vec<_> = course.map(|target| target.translation()).collect();
        let still = places
            .windows(2)
            .filter(|pair| norm(sub(pair[1], pair[0])) / scene.step < 0.05)
            .map(|pair| pair[0][2] - 0.07);
        let still: Vec<_> = still.collect();
        assert!(!still.is_empty());
        for sole in still {
            assert!(sole.abs() < 0.01, "{sole}");
        }
    }
}

#[test]
fn a_robot_with_a_floating_joint_of_its_own_gets_no_second_one() {
    let body = HUMANOID.find("<link name=\"pelvis\"").unwrap();
    let floor = "<link name='world'/><joint name='free' type='floating'><parent link='world'/><child link='pelvis'/></joint>";
    let text = format!("{}{floor}{}", &HUMANOID[..body], &HUMANOID[body..]);
    let robot = with_floating_base(Robot::from_urdf(&text).unwrap()).unwrap();
    assert_eq!(robot.mechanism().values(), self::robot().mechanism().values());
    let clip = biped::clip();
    let places = map::found(&robot, &clip).unwrap();
    let scene = Scene::new(robot, clip, places, WISHES).unwrap();
    let (motion, _) = track::one(&scene, &track::tracking(&scene), true, 1).unwrap();
    let Quality { mean, .. } = Quality::of(&scene, &motion).unwrap();
    assert!(mean < 15.0, "{mean} mm");
}

#[test]
fn the_sole_hangs_on_the_last_link_of_an_ankle_whatever_its_hinges_are_called() {
    let hinge = |name: &str, parent: &str, child: &str| {
        format!(
            "<link name='{child}'/><joint name='{name}' type='revolute'><parent link='{parent}'/><child link='{child}'/>\
             <limit lower='-1' upper='1' velocity='1' effort='1'/></joint>"
        )
    };
    let joints: String = ["left", "right"]
        .iter()
        .map(|side| {
            hinge(&format!("{side}_a"), "pelvis", &format!("{side}_knee_link"))
                + &hinge(
                    &format!("{side}_b"),
                    &format!("{side}_knee_link"),
                    &format!("{side}_ankle_roll_link"),
                )
                + &hinge(
                    &format!("{side}_c"),
                    &format!("{side}_ankle_roll_link"),
                    &format!("{side}_ankle_pitch_link"),
                )
                + &hinge(
                    &format!("{side}_d"),
                    &format!("{side}_ankle_pitch_link"),
                    &format!("{side}_toe_link"),
                )
        })
        .collect();
    let torso = hinge("waist", "pelvis", "torso");
    let text = format!("<robot name='h2'><link name='pelvis'/>{torso}{joints}</robot>");
    let robot = Robot::from_urdf(&text).unwrap();
    let places = map::found(&robot, &biped::clip()).unwrap();
    let feet = places.iter().filter(|place| crate::ground::is_foot(place));
    let names: Vec<_> = feet.map(|place| robot.link_names()[place.link].as_str()).collect();
    assert_eq!(names, ["left_ankle_pitch_link", "right_ankle_pitch_link"]);
}

#[test]
fn times_between_frames_keep_the_lengths_of_bones() {
    let clip = biped::clip();
    let joints = clip.joints.len();
    let models = clip.models_every(0.0, clip.frame_time / 3.0).unwrap();
    let own = clip.models().unwrap();
    let poses = |all: &[DualQuat<f64>], frame: usize| all[frame * joints..][..joints].to_vec();
    assert_eq!(poses(&models, 3 * 5), poses(&own, 5));
    let between = poses(&models, 16);
    for (index, joint) in clip.joints.iter().enumerate() {
        let Some(parent) = joint.parent else { continue };
        let bone = norm(sub(between[index].translation(), between[parent].translation()));
        assert!((bone - norm(joint.offset)).abs() < 1e-12);
    }
}
