//! [`parse`], which reads a file.

use crate::clip::Clip;
use crate::error::BvhError;
use crate::hierarchy;
use crate::motion::{self, Motion, Warning};
use crate::source::{Source, lines};

/// Reads a clip from the bytes of a file and gives it a title. Returns a warning as well if the
/// file has one frame more than it announces.
///
/// # Errors
/// If the bytes are not a BVH file; the error names the line.
pub fn parse(title: String, bytes: &[u8]) -> Result<(Clip, Option<Warning>), BvhError> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        // With what is no text: an end of a line before it counts.
        let before = String::from_utf8_lossy(&bytes[..=error.valid_up_to()]);
        BvhError::new(lines(&before).count(), "not UTF-8 text")
    })?;
    let mut source = Source::new(text);
    let joints = hierarchy::read(&mut source)?;
    let channels = joints.iter().map(|joint| joint.channels.len()).sum();
    let Motion { frame_time, values, warning } = motion::read(&mut source, channels)?;
    Ok((Clip { title, joints, frame_time, values }, warning))
}

#[cfg(test)]
mod tests {
    use super::parse;
    use crate::clip::Clip;
    use crate::error::BvhError;

    const TWO_JOINTS: &str = "\
HIERARCHY
ROOT Hips
{
	OFFSET 0 0 0
	CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation
	JOINT Chest
	{
		OFFSET 0 5 0
		CHANNELS 2 Yrotation Yposition
		End Site
		{
			OFFSET 0 2 0
		}
	}
}
MOTION
Frames: 2
Frame Time: .0083333
1 2 3 90 0 0 0 5
1 2 3 0 0 90 90 4
";

    fn read(text: &str) -> Result<Clip, BvhError> {
        parse("test".into(), text.as_bytes()).map(|(clip, _)| clip)
    }

    /// World positions of one frame, by hand: independent of `Hierarchy`.
    fn positions(clip: &Clip, frame: usize) -> Vec<[f64; 3]> {
        let joints = clip.joints.len();
        let mut models = clip.locals()[frame * joints..][..joints].to_vec();
        for (index, joint) in clip.joints.iter().enumerate() {
            if let Some(parent) = joint.parent {
                models[index] = models[parent] * models[index];
            }
        }
        models.iter().map(|model| model.translation()).collect()
    }

    fn close(a: &[[f64; 3]], b: &[[f64; 3]]) -> bool {
        a.len() == b.len()
            && a.iter().flatten().zip(b.iter().flatten()).all(|(a, b)| (a - b).abs() < 1e-12)
    }

    #[test]
    fn two_joints_and_an_end_site_stand_where_they_should() {
        let clip = read(TWO_JOINTS).unwrap();
        let names: Vec<_> = clip.joints.iter().map(|joint| joint.name.as_str()).collect();
        assert_eq!(names, ["Hips", "Chest", "Chest_End"]);
        assert_eq!((clip.frames(), clip.end_sites(), clip.frame_time), (2, 1, 0.0083333));
        // Frame 0: hips turned by 90° about z, so the spine along y points along −x.
        assert!(close(&positions(&clip, 0), &[[1., 2., 3.], [-4., 2., 3.], [-6., 2., 3.]]));
        // Frame 1: by 90° about x, the spine points along z; the chest's Yposition shortens it to
        // 4.
        assert!(close(&positions(&clip, 1), &[[1., 2., 3.], [1., 2., 7.], [1., 2., 9.]]));
    }

    #[test]
    fn line_endings_tabs_case_and_wrapped_frames_make_no_difference() {
        let plain = read(TWO_JOINTS).unwrap();
        let variants = [
            TWO_JOINTS.replace('\n', "\r\n"),
            TWO_JOINTS.replace('\n', "\r"),
            TWO_JOINTS.replace('\n', "\r\r\n"),
            TWO_JOINTS.replace("MOTION\n", "MOTION\r").replace("4\n", "4\r\r"),
            format!("{TWO_JOINTS}\u{1a}"),
            format!("{}\u{1a}", TWO_JOINTS.trim_end()),
            format!("{TWO_JOINTS}\r\n \u{1a}\u{1a}\0\r\n"),
            TWO_JOINTS.replace(' ', "\t"),
            TWO_JOINTS.replace("\n{", " {").replace("\n\t{", "{"),
            TWO_JOINTS.replace("1 2 3 0", "1 2\n3 0"),
            TWO_JOINTS.replace("Frames: ", "frames:").replace("Frame Time: ", "FRAME  TIME :\t"),
            TWO_JOINTS.to_lowercase().replace("hips", "Hips").replace("chest", "Chest"),
            format!("\u{feff}\n{TWO_JOINTS}\n\n"),
        ];
        for variant in variants {
            let clip = read(&variant).unwrap_or_else(|error| panic!("{error} in {variant}"));
            assert_eq!((clip.joints, clip.values), (plain.joints.clone(), plain.values.clone()));
        }
    }

    /// What is changed in the good file, into what, and the line and the words that the error must
    /// name; ⏎ ends a line.
    const WRONG: &str = "\
HIERARCHY⏎ |  | 1 | HIERARCHY
ROOT | JOINT | 2 | ROOT
Hips |  | 2 | without a name
OFFSET 0 0 0 |  | 6 | no OFFSET
\tOFFSET 0 2 0 |  | 13 | no OFFSET
OFFSET 0 0 0 | OFFSET 0 0 | 5 | `CHANNELS`
OFFSET 0 0 0 | OFFSET 0 0 0 7 | 4 | `7`
OFFSET 0 5 0 | OFFSET 0 nan 0 | 8 | `nan`
OFFSET 0 5 0 | OFFSET 0 1e999 0 | 8 | `1e999`
OFFSET 0 5 0 | OFFSET 0 5 0 OFFSET 1 1 1 | 8 | second OFFSET
CHANNELS 2 Yrotation Yposition |  | 10 | no CHANNELS
CHANNELS 2 | CHANNELS 3 | 9 | announces 3 channels and lists 2
CHANNELS 2 | CHANNELS -2 | 9 | `-2`
2 Yrotation | 2 Wrotation | 9 | `Wrotation`
2 Yrotation | 2 Yposition | 9 | twice
OFFSET 0 2 0 | OFFSET 0 2 0 CHANNELS 1 Xrotation | 12 | end site
OFFSET 0 2 0 | OFFSET 0 2 0 JOINT Tip { | 12 | `JOINT`
Chest | Hips | 6 | `Hips`, the first is on line 2
\t}⏎} | \t}⏎ | 16 | `Hips` is not closed: no `}` for the `{` of line 3
\t}⏎} | \t}⏎}} | 15 | `}`
End Site | End Sight | 10 | `Sight`
End Site | Sphere | 10 | `Sphere`
MOTION | NOTION | 16 | `NOTION`
Frames: 2⏎ |  | 17 | Frames:
Frames: 2 | Frames: two | 17 | `two`
Frames: 2 | Frames: 0 | 17 | no frames
Frames: 2 | Frames: -1 | 17 | `-1`
Frame Time: .0083333⏎ |  | 18 | Frame Time:
.0083333 | 0 | 18 | `0`
.0083333 | -0.01 | 18 | `-0.01`
.0083333 | NaN | 18 | `NaN`
3 90 | 3 9O | 19 | `9O`
3 90 | 3 -inf | 19 | `-inf`
90 0 0 0 5 | 90 0 0 0 | 19 | frame 1 has 7, its channels need 8
90 0 0 0 5 | 90 0 0 0 5 6 | 19 | frame 1 has 9, its channels need 8
90 4 | 90 | 20 | frame 2 has 7, its channels need 8
Frames: 2 | Frames: 3 | 20 | ends after 2
0 5⏎ | 0 5⏎\u{1a} | 20 | `\\u{1a}1`";

    #[test]
    fn wrong_files_are_refused_with_line_and_reason() {
        let row = |row: &str| {
            let [from, to, line, words] = row.split(" | ").collect::<Vec<_>>()[..] else {
                panic!("{row}")
            };
            let [from, to] = [from, to].map(|text| text.replace('⏎', "\n"));
            (TWO_JOINTS.replace(&from, &to), line.parse().unwrap(), words.to_owned())
        };
        let one = TWO_JOINTS.replace("Frames: 2", "Frames: 1");
        let more = (one.clone() + "1 2 3 4 5 6 7 8\n", 21, "more than one more follows".into());
        let short = (one.replace("90 4", "90"), 20, "frame 2 has 7, its channels need 8".into());
        let root = TWO_JOINTS.lines().nth(1).unwrap();
        let long = format!("ROOT {}", "a".repeat(1025));
        let long = (TWO_JOINTS.replace(root, &long), 2, "more than 1024 bytes".into());
        for (text, line, words) in WRONG.lines().map(row).chain([more, short, long]) {
            let Err(error) = read(&text) else {
                panic!("accepted, though {words} is wrong: {text}")
            };
            let named = error.line == line && error.to_string().contains(&words);
            assert!(named, "{line} {words}: {error}");
        }
    }

    #[test]
    fn a_file_cut_anywhere_is_refused_and_never_panics() {
        // The last value may lose its last digits and stay a number: cut before that one.
        for end in 0..TWO_JOINTS.len() - 2 {
            let error = read(&TWO_JOINTS[..end]).map(|_| end).unwrap_err();
            let lines = TWO_JOINTS[..end].lines().count().max(1);
            assert!((1..=lines).contains(&error.line), "{end}: {error}");
        }
        assert_eq!(read("").map(|_| ()).unwrap_err().reason, "the file is empty");
        assert_eq!(read(" \r\n\t").map(|_| ()).unwrap_err().reason, "the file is empty");
    }

    #[test]
    fn one_frame_more_than_announced_is_read_with_a_warning() {
        let parse = |text: &str| parse("test".into(), text.as_bytes()).unwrap();
        let (wanted, none) = parse(TWO_JOINTS);
        assert_eq!((wanted.frames(), none), (2, None));
        let one = TWO_JOINTS.replace("Frames: 2", "Frames: 1");
        let wrapped = one.replace("90 90 4", "90\n90 4");
        for (text, line) in
            [(one.clone(), 20), (wrapped, 20), (one.replace('\n', "\r") + "\r\u{1a}", 20)]
        {
            let (clip, warning) = parse(&text);
            assert_eq!(clip.values, wanted.values);
            let said = format!("line {line}: `Frames: 1` is announced, and one more is read");
            assert_eq!(warning.map(|warning| warning.to_string()), Some(said));
        }
    }

    #[test]
    fn bytes_that_are_no_text_are_refused_on_their_line() {
        let starts =
            ["HIERARCHY\nROOT H", "HIERARCHY\rROOT H", "HIERARCHY\r\nROOT H", "HIERARCHY\r"];
        for start in starts {
            let bytes = [start.as_bytes(), b"\xffps"].concat();
            let error = parse(String::new(), &bytes).map(|_| ()).unwrap_err();
            assert_eq!(error, BvhError::new(2, "not UTF-8 text"));
        }
    }

    #[test]
    fn nesting_of_any_depth_is_read() {
        let depth = 100_000;
        let mut text = "HIERARCHY ROOT j {OFFSET 0 0 0 CHANNELS 1 Zrotation".to_owned();
        for index in 0..depth {
            text += &format!("\nJOINT {index} {{OFFSET 1 0 0 CHANNELS 0");
        }
        text += &"}".repeat(depth + 1);
        let unclosed = read(&text[..text.len() - 1]).map(|_| ()).unwrap_err();
        assert!(unclosed.reason.ends_with("for the `{` of line 1"), "{unclosed}");
        text += "MOTION\nFrames: 1\nFrame Time: 1\n90\n";
        let clip = read(&text).unwrap();
        let tip = positions(&clip, 0)[depth];
        assert!(tip[0].abs() < 1e-6 && (tip[1] - depth as f64).abs() < 1e-6, "{tip:?}");
    }

    #[test]
    fn an_absurd_frame_count_costs_no_memory() {
        let error = read(&TWO_JOINTS.replace("Frames: 2", &format!("Frames: {}", usize::MAX)));
        let reason = error.map(|_| ()).unwrap_err().reason;
        assert!(
            reason.ends_with(&format!("{}` is announced, but the file ends after 2", usize::MAX))
        );
    }
}
