//! Files with a few bytes changed: an error that says where, or a robot whose links have poses, and never a panic.
//! `DQ8_FUZZ_SECONDS` says how long (a fifth of one by default), `DQ8_FUZZ_SEED` from where.

use dq8::DualQuat;
use dq8_robot::urdf::Robot;
use std::time::{Duration, Instant};

/// SplitMix64 (Steele, Lea and Flood 2014).
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((bits ^ (bits >> 31)) % end.max(1) as u64) as usize
    }
}

/// A few pieces of the file are lost, doubled, moved to another place, or become another word.
fn changed(text: &str, random: &mut Random) -> String {
    const WORDS: [&str; 12] = [
        "<joint",
        "/>",
        "\"",
        "nan",
        "1e999",
        "-0",
        "<mimic joint=\"a\"/>",
        "floating",
        "<!--",
        "&amp;",
        "0 0 0",
        "\u{2212}1",
    ];
    let mut letters: Vec<char> = text.chars().collect();
    for _ in 0..1 + random.below(4) {
        let start = random.below(letters.len());
        let end = (start + random.below(40)).min(letters.len());
        let piece: Vec<char> = match random.below(3) {
            0 => letters.drain(start..end).collect(),
            1 => letters[start..end].to_vec(),
            _ => WORDS[random.below(WORDS.len())].chars().collect(),
        };
        let at = random.below(letters.len());
        if random.below(3) > 0 {
            letters.splice(at..at, piece);
        }
    }
    letters.into_iter().collect()
}

#[test]
fn a_broken_file_is_an_error_or_another_robot() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<u64>().ok());
    let seconds =
        number("DQ8_FUZZ_SECONDS").map_or(Duration::from_millis(200), Duration::from_secs);
    let (first, start) = (number("DQ8_FUZZ_SEED").unwrap_or(1), Instant::now());
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/robots");
    let files: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .map(|file| std::fs::read_to_string(file.unwrap().path()).unwrap())
        .collect();
    assert!(files.len() >= 3);
    let (mut seed, mut robots) = (first, 0);
    while start.elapsed() < seconds {
        let mut random = Random(seed);
        let text = changed(&files[random.below(files.len())], &mut random);
        match Robot::from_urdf(&text) {
            Err(error) => assert!(!error.to_string().is_empty(), "DQ8_FUZZ_SEED={seed}"),
            Ok(robot) => {
                let values = vec![0.5; robot.value_names().len()];
                let mut poses = vec![DualQuat::IDENTITY; robot.link_names().len()];
                let done = robot.mechanism().link_poses(&values, &mut poses);
                assert!(done.is_ok(), "DQ8_FUZZ_SEED={seed}: {done:?}");
                assert!(poses.iter().all(|pose| pose.is_finite()), "DQ8_FUZZ_SEED={seed}");
                robots += 1;
            }
        }
        seed += 1;
    }
    println!("{} files, {robots} robots, seeds {first} to {}", seed - first, seed - 1);
    assert!(robots > 0, "nothing but errors");
}
