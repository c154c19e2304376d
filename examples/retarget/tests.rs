//! The embedded biped on the repository's humanoid.

use crate::clips::Clips;
use crate::{Args, csv, goals, heading, page, parse, picture, run, track};
use dq8_fixtures::legible::illegible;
use dq8_retarget::{Humanoid, Motion, Person, Settings, Targets, retarget};
use mocap::biped;
use mocap::command::Request;
use mocap::svg::{self, Figure};
use std::ffi::OsString;
use std::fs;
use std::path::PathBuf;

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
    let figures = picture::figures(&person, &humanoid, &targets, &motion).unwrap();
    let picture = svg::rows(&figures).unwrap();
    assert_eq!(illegible(&picture), [""; 0]);
    let text = goals::json(&person, &humanoid, &targets, &motion).unwrap();
    assert_eq!(text.lines().filter(|line| line.contains("\"role\"")).count(), targets.goals.len());
    assert_eq!(text.matches("[[").count(), 1 + targets.frames());
    let text = heading(&person, &humanoid, &motion.told);
    assert!(text.contains("left_foot       left_foot\n"), "{text}");
}

/// The biped and the humanoid, with boxes at its feet, as figures.
fn walk() -> ([Figure; 2], Motion) {
    let mut urdf = HUMANOID.to_owned();
    for side in ["left", "right"] {
        let shape = "<origin xyz='0.04 0 -0.04'/><geometry><box size='0.2 0.08 0.02'/></geometry>";
        let foot = format!("<link name=\"{side}_foot\"");
        urdf = urdf.replace(
            &format!("{foot}/>"),
            &format!("{foot}><collision>{shape}</collision></link>"),
        );
    }
    let humanoid = Humanoid::from_urdf(&urdf).unwrap();
    let person = Person::from_clip(&biped::clip()).unwrap();
    let motion = retarget(&person, &humanoid, &Settings::default()).unwrap();
    let targets = Targets::new(&person, &humanoid, &Settings::default()).unwrap();
    (picture::figures(&person, &humanoid, &targets, &motion).unwrap(), motion)
}

#[test]
fn soles_that_stand_are_on_the_ground_and_in_the_picture() {
    let (figures, motion) = walk();
    for sole in figures.iter().flat_map(|figure| &figure.soles) {
        for frame in (0..sole.stands.len()).filter(|&frame| sole.stands[frame]) {
            let lowest = sole.corners_in(frame).iter().map(|corner| corner[1]).reduce(f64::min);
            assert!(lowest.unwrap().abs() < 0.01, "{lowest:?} in {frame}");
        }
    }
    for (foot, sole) in figures[1].soles.iter().enumerate() {
        assert_eq!(sole.corners_in(0).len(), 4, "the foot is a box");
        let mut standing = 0;
        for run in sole.runs() {
            for frame in run {
                assert!(motion.contacts[frame][foot]);
                let heights = sole.corners_in(frame).iter().map(|corner| corner[1].abs());
                assert!(heights.fold(0.0, f64::max) < 0.02, "{frame}");
                standing += 1;
            }
        }
        assert!(standing > 5);
        assert_eq!(standing, motion.contacts.iter().filter(|contact| contact[foot]).count());
    }
    let picture = svg::rows(&figures).unwrap();
    let drawn = |line: &&str| line.starts_with("<path") && line.contains(" sole");
    assert_eq!(picture.lines().filter(drawn).count(), 4 * 10, "two soles of two figures");
    let bars = |line: &&str| line.contains(" contact\"");
    let runs: Vec<_> = picture.lines().filter(bars).map(|l| l.matches('H').count()).collect();
    let [left, right] = figures[1].soles.each_ref().map(|sole| sole.runs().count());
    assert_eq!(runs, [left, right, left, right]);
}

/// The data of a page.
fn data(page: &str) -> serde_json::Value {
    let (_, rest) = page.split_once("id=\"motion\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

#[test]
fn a_page_has_every_frame_and_needs_nothing_else() {
    let (figures, motion) = walk();
    let page = page::html("walk on humanoid", &figures, &motion.report);
    for outside in ["http", "src=", "href", "url(", "import", "fetch"] {
        assert!(!page.contains(outside), "{outside}");
    }
    let data = data(&page);
    let frames = motion.contacts.len();
    assert_eq!(
        data["measures"].as_array().unwrap().len(),
        motion.report.to_string().lines().count()
    );
    for (index, figure) in figures.iter().enumerate() {
        let rows = data["figures"][index]["rows"].as_array().unwrap();
        assert_eq!(rows.len(), frames);
        // All rows together are the place in the last frame.
        let mut sum = [0; 3];
        for row in rows {
            for (axis, sum) in sum.iter_mut().enumerate() {
                *sum += row[axis].as_i64().unwrap();
            }
        }
        let root = figure.positions[(frames - 1) * figure.clip.joints.len()];
        assert_eq!(sum, root.map(|metres| (1e3 * metres).round() as i64));
    }
    for foot in [0, 1] {
        let digits = data["stands"][foot].as_str().unwrap().chars();
        assert!(digits.map(|digit| digit == '1').eq(motion.contacts.iter().map(|c| c[foot])));
    }
    // In the format of thirty frames a second; a tenth is what all frames have in common.
    let bytes = (page.len() as f64 - page.len().min(12_000) as f64) / frames as f64;
    assert!(bytes < 950.0, "{bytes} bytes a frame");
}

#[test]
fn names_of_files_do_not_break_a_page() {
    let (figures, motion) = walk();
    let plain = page::html("walk", &figures, &motion.report);
    for name in [
        "</script><script>alert(1)</script>",
        "\"'`<!--<script>",
        "a\\u003c/\u{2028}&amp;MOTION SCRIPT",
    ] {
        let page = page::html(name, &figures, &motion.report);
        assert_eq!(data(&page)["title"], name);
        for tag in ["<script", "</script", "<!--", "alert"] {
            let count = if tag == "alert" {
                usize::from(name.contains(tag))
            } else {
                plain.matches(tag).count()
            };
            assert_eq!(page.matches(tag).count(), count, "{name} {tag}");
        }
    }
}

#[test]
fn a_bad_clip_does_not_end_the_others_and_is_named() {
    let folder = std::env::temp_dir().join(format!("dq8-retarget-{}", std::process::id()));
    let (clips, out) = (folder.join("clips"), folder.join("results"));
    fs::create_dir_all(&clips).unwrap();
    let walk = include_str!("../mocap/walk.bvh");
    for (name, text) in
        [("a.bvh", walk), ("b,\"b.BVH", "HIERARCHY\n"), ("c.bvh", walk), ("d.txt", "")]
    {
        fs::write(clips.join(name), text).unwrap();
    }
    let humanoid = Humanoid::from_urdf(HUMANOID).unwrap();
    let settings = Settings::default();
    let work =
        Clips { humanoid: &humanoid, table: None, settings: &settings, out: &out, inputs: &[] };
    let mut before = None;
    for jobs in [1, 2, 9] {
        let error = work.run(std::slice::from_ref(&clips), jobs).unwrap_err().to_string();
        assert_eq!(error, "1 of 3 clips failed");
        let read = |name| fs::read_to_string(out.join(name)).unwrap();
        let table = read("measures.csv");
        let lines: Vec<_> = table.lines().collect();
        assert!(lines[1].starts_with("\"a\",32,") && lines[1].ends_with(",false,"), "{table}");
        assert!(lines[0].ends_with(",self_hits,edges,error"), "{table}");
        assert!(lines[2].starts_with("\"b,\"\"b\",,,") && lines[2].contains("line"), "{table}");
        assert_eq!(lines[1].replacen('a', "c", 1), lines[3]);
        assert_eq!(read("a.csv").lines().count(), 33);
        assert!(!out.join("b,\"b.csv").exists());
        let results = (table, read("a.csv"), read("c.csv"));
        assert!(before.replace(results.clone()).is_none_or(|before| before == results));
    }
    fs::remove_file(clips.join("b,\"b.BVH")).unwrap();
    work.run(&[clips.join("a.bvh"), clips.join("c.bvh")], 2).unwrap();
    // Two clips of one name, a folder without clips, and the name of the table.
    fs::write(clips.join("measures.bvh"), walk).unwrap();
    for (paths, said) in [
        (vec![clips.join("a.bvh"), clips.join("./a.bvh")], "one file"),
        (vec![out.clone()], "no BVH file"),
        (vec![clips.join("measures.bvh")], "table of measures"),
    ] {
        let error = work.run(&paths, 1).unwrap_err().to_string();
        assert!(error.contains(said), "{error}");
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_folder_gives_its_files_and_a_clip_that_fails_has_no_result() {
    let folder = std::env::temp_dir().join(format!("dq8-retarget-files-{}", std::process::id()));
    let (clips, out) = (folder.join("clips"), folder.join("results"));
    fs::create_dir_all(clips.join("folder.bvh")).unwrap();
    fs::create_dir_all(&out).unwrap();
    fs::write(clips.join("a.bvh"), "HIERARCHY\n").unwrap();
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(folder.join("gone"), clips.join("link.bvh")).unwrap();
        // A pipe would be waited for without end.
        let made = std::process::Command::new("mkfifo").arg(clips.join("pipe.bvh")).status();
        assert!(made.unwrap().success());
    }
    for name in ["a.csv", "other.csv"] {
        fs::write(out.join(name), "of an earlier run").unwrap();
    }
    let humanoid = Humanoid::from_urdf(HUMANOID).unwrap();
    let settings = Settings::default();
    let work =
        Clips { humanoid: &humanoid, table: None, settings: &settings, out: &out, inputs: &[] };
    let error = work.run(std::slice::from_ref(&clips), 1).unwrap_err().to_string();
    let failed = if cfg!(unix) { 2 } else { 1 };
    assert_eq!(error, format!("{failed} of {failed} clips failed"));
    assert_eq!(fs::read_to_string(out.join("measures.csv")).unwrap().lines().count(), 1 + failed);
    assert!(!out.join("a.csv").exists());
    assert!(out.join("other.csv").exists());
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn no_result_replaces_a_file_that_is_read() {
    let folder = std::env::temp_dir().join(format!("dq8-retarget-inputs-{}", std::process::id()));
    fs::create_dir_all(folder.join("clips")).unwrap();
    let [robot, map] = ["robot.urdf", "map.toml"].map(|name| folder.join(name));
    let [clip, same, table] = ["clips/w.bvh", "w.csv", "measures.csv"].map(|n| folder.join(n));
    let walk = include_str!("../mocap/walk.bvh");
    let inputs = [(&robot, HUMANOID), (&map, ""), (&clip, walk), (&same, walk), (&table, HUMANOID)];
    for (path, text) in inputs {
        fs::write(path, text).unwrap();
    }
    let word = |path: &PathBuf| path.clone().into_os_string();
    let refuses = |words: Vec<OsString>| {
        let Ok(Request::Run(args)) = parse(words) else { panic!("not understood") };
        let error = run(&args).unwrap_err().to_string();
        assert!(error.contains("is an input"), "{error}");
        for (path, text) in inputs {
            assert_eq!(fs::read_to_string(path).unwrap(), text, "{}", path.display());
        }
    };
    let many = |robot, clip| vec![word(robot), word(clip), "--out".into(), word(&folder)];
    refuses(many(&robot, &same));
    refuses(many(&table, &clip));
    for path in [&robot, &map, &clip] {
        let line = [word(&robot), word(&clip), "--map".into(), word(&map), "--html".into()];
        refuses(line.into_iter().chain([word(path)]).collect());
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn the_command_line_is_a_robot_clips_and_options() {
    let words = |line: &str| parse(line.split_whitespace().map(Into::into));
    let line = "a.urdf --fps 60 b.bvh --svg c.svg --smooth 0";
    let Ok(Request::Run(Args { settings, svg, .. })) = words(line) else {
        panic!("not understood")
    };
    assert_eq!((settings.fps, settings.smooth, svg), (60.0, None, Some("c.svg".into())));
    let Ok(Request::Run(args)) = words("a.urdf b.bvh folder --out c --jobs 3") else {
        panic!("not understood")
    };
    assert_eq!(args.clips, ["b.bvh", "folder"].map(PathBuf::from));
    assert_eq!(args.out, Some(("c".into(), 3)));
    for wrong in [
        "",
        "a",
        "a b c",
        "a --out c",
        "a b --jobs 2",
        "a b --out c --jobs 0",
        "a b --out c --svg d",
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
