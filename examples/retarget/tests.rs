//! The embedded biped on the repository's humanoid.

use crate::{Args, csv, goals, heading, parse, picture, track};
use dq8_fixtures::legible::illegible;
use dq8_retarget::{Humanoid, Person, Settings, Targets, retarget};
use mocap::biped;
use mocap::command::Request;

const HUMANOID: &str = include_str!("../../robot/robots/humanoid.urdf");

#[test]
fn lanes_follow_the_walk_of_the_biped_as_one_clip_does() {
    let humanoid = Humanoid::from_urdf(HUMANOID).unwrap();
    let person = Person::from_clip(&biped::clip()).unwrap();
    let targets = Targets::new(&person, &humanoid, &Settings::plain()).unwrap();
    let (motion, _) = track::one(&targets, &humanoid, &targets.tracking(), true, 1).unwrap();
    let (several, _) = track::many::<f32>(&targets, &humanoid, &targets.tracking(), true).unwrap();
    let apart = motion.iter().zip(&several).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart < 2e-3, "{apart}");
}

#[test]
fn texts_have_a_row_for_each_frame_and_pictures_are_legible() {
    let humanoid = Humanoid::from_urdf(HUMANOID).unwrap();
    let person = Person::from_clip(&biped::clip()).unwrap();
    let motion = retarget(&person, &humanoid, &Settings::default()).unwrap();
    let targets = Targets::new(&person, &humanoid, &Settings::default()).unwrap();
    let text = csv(&humanoid, &motion.values, motion.step).unwrap();
    assert_eq!(text.lines().count(), targets.frames() + 1);
    let picture = picture::draw(&person, &humanoid, &targets, &motion.values).unwrap();
    assert_eq!(illegible(&picture), [""; 0]);
    let text = goals::json(&person, &humanoid, &targets, &motion).unwrap();
    assert_eq!(text.lines().filter(|line| line.contains("\"role\"")).count(), targets.goals.len());
    assert_eq!(text.matches("[[").count(), 1 + targets.frames());
    let text = heading(&person, &humanoid, &motion.told);
    assert!(text.contains("left_foot       left_foot\n"), "{text}");
}

#[test]
fn the_command_line_is_two_files_and_options() {
    let words = |line: &str| parse(line.split_whitespace().map(Into::into));
    let line = "a.urdf --fps 60 b.bvh --svg c.svg --smooth 0";
    let Ok(Request::Run(Args { settings, svg, .. })) = words(line) else {
        panic!("not understood")
    };
    assert_eq!((settings.fps, settings.smooth, svg), (60.0, None, Some("c.svg".into())));
    for wrong in [
        "",
        "a",
        "a b c",
        "a b --fps 0",
        "a b --fps x",
        "a b --rest -1",
        "a b --ankle inf",
        "a b --smooth -1",
        "a b --speed 0",
        "a b --jpg c",
        "a b --csv",
    ] {
        assert!(words(wrong).is_err(), "{wrong}");
    }
}
