//! `bounds.toml` says what the tapes of today's code say: with no tool installed, a body fails here whose error grows, or
//! whose operations are others than those that were proved.

use dq8_proofs::table;

/// Lines that differ, of those that `is` chooses.
fn differences(is: fn(&str) -> bool) -> Vec<String> {
    let (written, computed) = (include_str!("../bounds.toml"), table::text());
    assert_eq!(written.lines().count(), computed.lines().count(), "{}", WRITE);
    let (mut heading, mut differ) = ("", vec![]);
    for (written, computed) in written.lines().zip(computed.lines()) {
        if written.starts_with('[') {
            heading = written;
        }
        if is(written) && written != computed {
            differ.push(format!("{heading} written: {written}; of the code: {computed}"));
        }
    }
    differ
}

const WRITE: &str =
    "`cargo run -- bounds` writes those of the code as it is; then run.sh proves them";

#[test]
fn the_tapes_are_those_that_were_proved() {
    let differ = differences(|line| line.starts_with("tapes"));
    assert!(differ.is_empty(), "{differ:#?}\n{WRITE}");
}

#[test]
fn every_bound_is_what_the_code_has() {
    let differ = differences(|line| !line.starts_with("tapes"));
    assert!(differ.is_empty(), "{differ:#?}\n{WRITE}");
}
