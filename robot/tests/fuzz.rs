//! Files with a few bytes changed: an error that says where, or a robot whose links have poses, and
//! never a panic. `DQ8_FUZZ_SECONDS` says how long (a fifth of one by default), `DQ8_FUZZ_SEED`
//! from where.

use dq8::DualQuat;
use dq8_fixtures::fuzz;
use dq8_fixtures::random::Random;
use dq8_robot::urdf::Robot;

/// A few pieces of the file are lost, doubled, moved to another place, or become another word.
fn changed(text: &str, random: &mut Random) -> String {
    let words =
        "<joint|/>|\"|nan|1e999|-0|<mimic joint=\"a\"/>|floating|<!--|&amp;|0 0 0|\u{2212}1";
    let words: Vec<_> = words.split('|').collect();
    let mut letters: Vec<char> = text.chars().collect();
    for _ in 0..1 + random.below(4) {
        let start = random.below(letters.len());
        let end = (start + random.below(40)).min(letters.len());
        let piece: Vec<char> = match random.below(3) {
            0 => letters.drain(start..end).collect(),
            1 => letters[start..end].to_vec(),
            _ => random.one_of(&words).chars().collect(),
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
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/robots");
    let files = std::fs::read_dir(folder).unwrap();
    let files = files.map(|file| std::fs::read_to_string(file.unwrap().path()).unwrap());
    let files: Vec<String> = files.collect();
    assert!(files.len() >= 3);
    let mut robots = 0;
    fuzz::rounds(|seed| {
        let mut random = fuzz::random(seed);
        let text = changed(&files[random.below(files.len())], &mut random);
        match Robot::from_urdf(&text) {
            Err(error) => assert!(!error.to_string().is_empty()),
            Ok(robot) => {
                let values = vec![0.5; robot.value_names().len()];
                let mut poses = vec![DualQuat::IDENTITY; robot.link_names().len()];
                robot.mechanism().link_poses(&values, &mut poses).unwrap();
                assert!(poses.iter().all(|pose| pose.is_finite()));
                robots += 1;
            }
        }
        1
    });
    assert!(robots > 0, "nothing but errors");
}
