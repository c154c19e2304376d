//! What the figures draw.

use lab::figures::{Canvas, LIMITS, Side, View, colour, limit_of};
use mocap::biped;
use mocap::clip::{Axis, Channel};

#[test]
fn every_joint_of_the_biped_but_the_free_one_has_limits_about_the_stance() {
    let clip = biped::clip();
    let mut limited = 0;
    for joint in clip.joints.iter().filter(|joint| joint.parent.is_some()) {
        for channel in &joint.channels {
            let Channel::Rotation(axis) = *channel else { panic!("{} moves along", joint.name) };
            let [low, high] = limit_of(&joint.name, axis).expect("a limit for each");
            assert!(low <= 0.0 && high >= 0.0 && low < high, "{}: {low} {high}", joint.name);
            limited += 1;
        }
    }
    assert_eq!(limited, 36 - 6);
    // Three about the middle, two of the neck, and eleven of a pair of limbs.
    assert_eq!(LIMITS.len(), 3 + 3 + 2 + 3 + 1 + 1 + 3 + 1 + 2);
}

#[test]
fn the_walk_of_the_example_stays_within_the_limits() {
    let clip = biped::clip();
    for frame in clip.values.chunks_exact(clip.channels()) {
        let mut values = frame.iter();
        for joint in &clip.joints {
            for channel in &joint.channels {
                let value = *values.next().expect("a value for each channel");
                if let (Some(_), Channel::Rotation(axis)) = (joint.parent, *channel) {
                    let [low, high] = limit_of(&joint.name, axis).expect("a limit for each");
                    assert!((low..=high).contains(&value), "{} {axis:?}: {value}", joint.name);
                }
            }
        }
    }
}

#[test]
fn limits_of_a_pair_are_mirror_images() {
    for axis in [Axis::Y, Axis::Z] {
        let [left, right] =
            ["LeftThigh", "RightThigh"].map(|name| limit_of(name, axis).expect("both"));
        assert_eq!(left, [-right[1], -right[0]]);
    }
    assert_eq!(limit_of("LeftShin", Axis::X), limit_of("RightShin", Axis::X));
    assert_eq!(limit_of("LeftShin", Axis::Z), None);
}

#[test]
fn space_is_seen_by_parallel_rays_from_the_right_and_above() {
    let view = View { origin: [100.0, 100.0], scale: 10.0, turn: 0.4, height: 0.5 };
    let [right, back, up] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|p| view.of(p));
    assert!(right[0] > 100.0 && right[1] < 100.0, "{right:?}");
    assert!(back[0] < 100.0 && back[1] < 100.0, "{back:?}");
    assert_eq!(up[0], 100.0);
    let far = view.of([1.0, 1.0, 1.0]);
    for i in 0..2 {
        let sum = right[i] + back[i] + up[i] - 200.0;
        assert!((far[i] - sum).abs() < 1e-12);
    }
    let place = [37.0, 61.0];
    let seen = view.of(view.back(place));
    assert!((seen[0] - place[0]).hypot(seen[1] - place[1]) < 1e-12);
}

#[test]
fn what_is_written_on_a_canvas_is_escaped() {
    let mut canvas = Canvas::new([100.0, 50.0], "a < b");
    canvas.text([5.0, 5.0], Side::Left, 12.0, colour::INK, "c & d");
    let svg = canvas.to_svg();
    assert!(svg.contains("a &lt; b") && svg.contains("c &amp; d"), "{svg}");
}
