//! The embedded biped on the repository's humanoid.

use crate::map::{self, ROLES};
use crate::measure::Quality;
use crate::scene::Scene;
use crate::{Args, parse, picture, table, track};
use dq8_fixtures::legible::illegible;
use dq8_robot::urdf::Robot;
use mocap::biped;
use mocap::clip::{Axis, Channel, Clip, Joint};
use mocap::command::Request;

fn robot() -> Robot {
    Robot::from_urdf(include_str!("../../robot/robots/humanoid.urdf")).unwrap().floating().unwrap()
}

#[test]
fn the_walk_of_the_biped_is_followed_within_limits() {
    let places = map::found(&robot(), &biped::clip()).unwrap();
    assert_eq!(places.len(), ROLES.len());
    let scene = Scene::new(robot(), biped::clip(), places, 30.0).unwrap();
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
    let Ok(Request::Run(Args { rate, svg, .. })) = words("a.urdf --rate 60 b.bvh --svg c.svg")
    else {
        panic!("not understood")
    };
    assert_eq!((rate, svg), (60.0, Some("c.svg".into())));
    for wrong in ["", "a", "a b c", "a b --rate 0", "a b --rate x", "a b --jpg c", "a b --csv"] {
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
        let scene = Scene::new(robot(), clip, places, 30.0).unwrap();
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
    let text = Scene::new(robot(), clip, places, 30.0).unwrap().text();
    for role in ROLES.iter().filter(|role| !found.contains(&role.name)) {
        assert!(text.contains(&format!("{:<15} not found", role.name)), "{text}");
    }
}
