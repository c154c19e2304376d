//! The whole pipeline on the walk of the biped.

mod common;

use common::{HUMANOID, humanoid, person, with_shape, with_soles};
use dq8_retarget::{
    Clip, Humanoid, Person, Report, RetargetError, Settings, Speeds, Targets, retarget,
};
use mocap::biped;

#[test]
fn the_walk_of_the_biped_is_followed_within_limits() {
    let report = retarget(&person(&biped::clip()), &humanoid(), &Settings::plain()).unwrap().report;
    assert!(report.residual < 15.0 && report.feet < 3.0 && report.beyond <= 1e-6, "{report}");
}

#[test]
fn held_feet_stand_still_and_flat_on_the_ground() {
    let humanoid = Humanoid::from_urdf(&with_soles()).unwrap();
    let person = person(&biped::clip());
    let report = |settings: &Settings| retarget(&person, &humanoid, settings).unwrap().report;
    let free = report(&Settings::plain());
    let held = report(&Settings { feet: true, ..Settings::plain() });
    assert!(held.slide < 15.0 && held.slide < 0.5 * free.slide, "{free}{held}");
    assert!(held.sink < 5.0 && held.ground.abs() < 2.0 && held.unevenness < 1.0, "{free}{held}");
    assert!(held.residual < free.residual + 1.0, "{free}{held}");
}

/// The walk with shakes of half a degree in all joints, such as cameras see.
fn shaken() -> Clip {
    let mut clip = biped::clip();
    let channels = clip.channels();
    for (index, value) in clip.values.iter_mut().enumerate().filter(|(i, _)| i % channels > 5) {
        *value += 0.5 * ((index * index) as f64 * 0.7).sin();
    }
    clip
}

#[test]
fn passes_halve_the_jerk_and_keep_the_feet() {
    let person = person(&shaken());
    let report = |smooth: Option<f64>| {
        retarget(&person, &humanoid(), &Settings { smooth, ..Settings::default() }).unwrap().report
    };
    let (rough, smooth) = (report(None), report(Settings::default().smooth));
    assert!(smooth.jerk < 0.75 * rough.jerk, "{rough}{smooth}");
    assert!(smooth.feet < 1.5 && smooth.residual < rough.residual + 1.0, "{rough}{smooth}");
}

#[test]
fn speeds_are_bounded_exactly() {
    let person = person(&biped::clip());
    let free = retarget(&person, &humanoid(), &Settings::default()).unwrap().report;
    let bound = 0.6 * free.speed_most;
    let settings = Settings { speeds: Speeds::AtMost(bound), ..Settings::default() };
    let slow = retarget(&person, &humanoid(), &settings).unwrap().report;
    assert!(slow.speed_most <= bound, "{free}{slow}");
    assert!(slow.beyond <= 1e-6 && slow.residual < free.residual + 20.0, "{free}{slow}");
}

/// The walk with arms that cross the trunk for a second.
fn crossing() -> Clip {
    let mut clip = biped::clip();
    let (mut first, channels) = (0, clip.channels());
    for joint in clip.joints.clone() {
        let z = joint.channels.iter().position(|channel| format!("{channel:?}") == "Rotation(Z)");
        let side = ["RightUpperArm", "LeftUpperArm"].iter().position(|name| *name == joint.name);
        if let (Some(z), Some(side)) = (z, side) {
            for frame in 60..180 {
                let bump = (core::f64::consts::PI * (frame - 60) as f64 / 120.0).sin();
                let turn = if side == 0 { 40.0 } else { -40.0 };
                clip.values[frame * channels + first + z] += turn * bump;
            }
        }
        first += joint.channels.len();
    }
    clip
}

/// The humanoid with a thick trunk and thick hands.
fn thick() -> Humanoid {
    let cylinder =
        |length: f64, radius: f64| format!("<cylinder length='{length}' radius='{radius}'/>");
    let mut urdf = with_soles();
    for side in ["left", "right"] {
        urdf = with_shape(&urdf, &format!("{side}_thigh"), "0 0 -0.1", &cylinder(0.3, 0.1));
        urdf = with_shape(&urdf, &format!("{side}_hand"), "0 0 -0.03", "<sphere radius='0.06'/>");
    }
    urdf = with_shape(&urdf, "pelvis", "0 0 0", "<box size='0.2 0.3 0.15'/>");
    Humanoid::from_urdf(&urdf).unwrap()
}

#[test]
fn shapes_that_meet_are_pushed_apart() {
    let (person, thick) = (person(&crossing()), thick());
    let report = |collide: bool| {
        let settings = Settings { collide, ..Settings::default() };
        retarget(&person, &thick, &settings).unwrap().report
    };
    let (through, apart) = (report(false), report(true));
    assert!(through.self_hits > Some(5.0), "{through}");
    assert!(apart.self_hits < Some(2.0), "{through}{apart}");
    assert!(apart.residual < through.residual + 12.0 && apart.feet < 2.0, "{through}{apart}");
    assert_eq!(
        retarget(&person, &humanoid(), &Settings::default()).unwrap().report.self_hits,
        None
    );
}

/// The first frames of a clip.
fn first(clip: &Clip, frames: usize) -> Clip {
    Clip { values: clip.values[..frames * clip.channels()].to_vec(), ..clip.clone() }
}

#[test]
fn clips_of_few_frames_have_as_many_frames() {
    for frames in [1, 2, 3, 5] {
        let clip = Clip { frame_time: 1.0 / 30.0, ..first(&biped::clip(), frames) };
        let motion = retarget(&person(&clip), &humanoid(), &Settings::default()).unwrap();
        assert_eq!(motion.contacts.len(), frames);
        assert!(motion.values.iter().all(|value| value.is_finite()));
        assert!(motion.report.residual < 25.0, "{frames}: {}", motion.report);
    }
    let error = dq8_retarget::Person::from_clip(&first(&biped::clip(), 0)).unwrap_err();
    assert!(matches!(error, RetargetError::Lengths { length: 0, .. }), "{error}");
}

#[test]
fn a_frame_that_is_not_finite_is_named() {
    let mut clip = biped::clip();
    let channels = clip.channels();
    for wrong in [f64::NAN, f64::INFINITY, 1e300] {
        clip.values[17 * channels] = wrong;
        let error = dq8_retarget::Person::from_clip(&clip).unwrap_err();
        let RetargetError::NotFinite { frame: 17, joint } = &error else { panic!("{error}") };
        assert_eq!(joint, &clip.joints[0].name);
    }
}

#[test]
fn a_lying_person_lies_on_the_ground() {
    // The walk about the axis to the side, so that the person lies on the back, after one frame
    // in which the person stands.
    let mut clip = biped::clip();
    let (channels, root) = (clip.channels(), clip.joints[0].channels.clone());
    let x = root.iter().position(|channel| format!("{channel:?}") == "Rotation(X)").unwrap();
    for frame in clip.values.chunks_exact_mut(channels).skip(1) {
        frame[x] -= 90.0;
    }
    let motion = retarget(&person(&clip), &humanoid(), &Settings::default()).unwrap();
    assert!(motion.values.iter().all(|value| value.is_finite()));
    // Nothing is under the ground, and no joint jumps.
    assert!(motion.report.sink < 30.0 && motion.report.speed_most < 40.0, "{}", motion.report);
}

#[test]
fn parts_of_a_clip_meet_without_a_seam() {
    // Parts fill the lanes of a clip of 128 frames, and not those of a clip of 20 frames.
    let (humanoid, settings) = (humanoid(), Settings::plain());
    let whole = Targets::new(&person(&biped::clip()), &humanoid, &settings).unwrap();
    let values = whole.solve(&humanoid, &settings).unwrap();
    let report = Report::of(&whole, &humanoid, &values).unwrap();
    assert!(report.residual < 15.0 && report.speed_most < 6.0, "{report}");
    let short = Targets::new(&person(&first(&biped::clip(), 40)), &humanoid, &settings).unwrap();
    let few = short.solve(&humanoid, &settings).unwrap();
    // Where the first two parts meet, links are as near to their targets as without parts, and
    // joints as quick. Joints that targets hardly determine may be elsewhere.
    let [alone, met] = [&few[..], &values[..few.len()]]
        .map(|values| Report::of(&short, &humanoid, values).unwrap());
    assert!((alone.residual - met.residual).abs() < 0.3, "{alone}{met}");
    assert!(met.speed_most < alone.speed_most + 0.5 && met.jerk < 1.5 * alone.jerk, "{alone}{met}");
}

#[test]
fn settings_out_of_range_are_named() {
    let own = Settings::default();
    for (settings, name) in [
        (Settings { fps: 0.0, ..own }, "fps"),
        (Settings { fps: f64::NAN, ..own }, "fps"),
        (Settings { fps: 1e-310, ..own }, "fps"),
        (Settings { fps: 1e20, ..own }, "fps"),
        (Settings { smooth: Some(0.01), ..own }, "smooth"),
        (Settings { smooth: Some(-1.0), ..own }, "smooth"),
        (Settings { speeds: Speeds::AtMost(0.0), ..own }, "speeds"),
        (Settings { ankle: Some(f64::INFINITY), ..own }, "ankle"),
    ] {
        let error = retarget(&person(&biped::clip()), &humanoid(), &settings).unwrap_err();
        assert!(matches!(error, RetargetError::Setting { name: n, .. } if n == name), "{error}");
    }
}

#[test]
fn the_foot_that_alone_is_known_has_its_own_column_of_contacts() {
    let clip = biped::clip();
    let both = retarget(&person(&clip), &humanoid(), &Settings::default()).unwrap().contacts;
    let mut nameless = clip.clone();
    for joint in &mut nameless.joints {
        if joint.name.starts_with("LeftFoot") {
            joint.name = format!("x{}", joint.name.len());
        }
    }
    let one = dq8_retarget::Person::from_clip(&nameless).unwrap();
    assert_eq!(one.joint(dq8_retarget::Role::LeftFoot), None);
    let right = retarget(&one, &humanoid(), &Settings::default()).unwrap().contacts;
    assert!(both.iter().any(|stands| stands[1]) && both.iter().any(|stands| stands[0]));
    assert!(right.iter().any(|stands| stands[1]) && right.iter().all(|stands| !stands[0]));
}

#[test]
fn a_robot_without_legs_is_refused() {
    let arm = include_str!("../../robot/robots/arm7.urdf");
    let error = Humanoid::from_urdf(arm).unwrap_err();
    assert!(matches!(error, RetargetError::NoLegs { .. }), "{error}");
    assert!(HUMANOID.contains("left_foot") && error.to_string().contains("left_foot"));
}

#[test]
fn measures_of_a_single_frame_are_not_negative() {
    let mut clip = biped::clip();
    clip.values.truncate(clip.channels());
    let report = retarget(&person(&clip), &humanoid(), &Settings::default()).unwrap().report;
    for (name, measure) in Report::MEASURES.into_iter().zip(report.measures()) {
        let negative = measure.is_some_and(f64::is_sign_negative);
        assert!(!negative || name == "ground", "{name}: {measure:?}");
    }
}

#[test]
fn a_list_of_no_parts_says_that_there_are_none() {
    let joints = [("pelvis", None), ("spine", Some(0)), ("head", Some(1))];
    let person = Person::from_positions("still", &joints, &[[0.0; 3]; 3], 0.1).unwrap();
    let error = retarget(&person, &humanoid(), &Settings::default()).unwrap_err().to_string();
    assert!(
        error.contains("Not found on the robot: none. Not found on the person: left"),
        "{error}"
    );
}
