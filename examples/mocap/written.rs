//! The walk in this folder, which is written from the biped.

use crate::biped;
use dq8_bvh::{Channel, Clip, parse};
use std::fmt::Write;

/// The text of a clip with one root: metres with four decimals, degrees with three.
fn written(clip: &Clip) -> String {
    let mut text = String::from("HIERARCHY\n");
    write_joint(&mut text, clip, 0, 0);
    let (frames, time) = (clip.frames(), clip.frame_time);
    write!(text, "MOTION\nFrames: {frames}\nFrame Time: {time:.7}\n").unwrap();
    let channels: Vec<_> = clip.joints.iter().flat_map(|joint| &joint.channels).collect();
    for frame in clip.values.chunks_exact(channels.len()) {
        let words = frame.iter().zip(&channels).map(|(value, channel)| match channel {
            Channel::Position(_) => format!("{value:.4}"),
            Channel::Rotation(_) => format!("{value:.3}"),
        });
        writeln!(text, "{}", words.collect::<Vec<_>>().join(" ")).unwrap();
    }
    text
}

fn write_joint(text: &mut String, clip: &Clip, index: usize, depth: usize) {
    let joint = &clip.joints[index];
    let (indent, [x, y, z]) = ("  ".repeat(depth), joint.offset);
    let heading = match (joint.end_site, joint.parent) {
        (true, _) => "End Site".into(),
        (false, None) => format!("ROOT {}", joint.name),
        (false, Some(_)) => format!("JOINT {}", joint.name),
    };
    write!(text, "{indent}{heading}\n{indent}{{\n{indent}  OFFSET {x} {y} {z}\n").unwrap();
    if !joint.end_site {
        let names = joint.channels.iter().map(|channel| match channel {
            Channel::Position(axis) => format!(" {axis:?}position"),
            Channel::Rotation(axis) => format!(" {axis:?}rotation"),
        });
        let (count, names) = (joint.channels.len(), names.collect::<String>());
        writeln!(text, "{indent}  CHANNELS {count}{names}").unwrap();
    }
    for child in index + 1..clip.joints.len() {
        if clip.joints[child].parent == Some(index) {
            write_joint(text, clip, child, depth + 1);
        }
    }
    writeln!(text, "{indent}}}").unwrap();
}

#[test]
fn the_walk_in_this_folder_is_one_cycle_of_the_biped() {
    let biped = biped::clip();
    let values = biped.values[..64 * biped.channels()].to_vec();
    let cycle = Clip { values, ..biped };
    let text = written(&cycle);
    let path = std::env::temp_dir().join("walk.bvh");
    if text != include_str!("walk.bvh") {
        std::fs::write(&path, &text).unwrap();
        panic!("walk.bvh is another clip; the one that is expected is in {}", path.display());
    }
    let clip = parse("test".into(), text.as_bytes()).unwrap().0;
    assert_eq!(clip.joints, cycle.joints);
    let off = clip.values.iter().zip(&cycle.values).map(|(a, b)| (a - b).abs());
    assert!(off.fold(0.0, f64::max) < 0.0006);
}
