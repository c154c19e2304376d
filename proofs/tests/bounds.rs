//! `bounds.toml` says what the tapes of today's code say: with no tool installed, a body fails here whose error grows, or
//! whose operations are others than those that were proved.

use dq8_proofs::table;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

/// Lines by their section and name.
fn lines(text: &str) -> BTreeMap<String, &str> {
    let mut section = "";
    let entries = text.lines().filter_map(|line| {
        if line.starts_with('[') {
            section = line;
        }
        Some((format!("{section} {}", line.split_once(" = ")?.0), line))
    });
    entries.collect()
}

/// Computed once for both tests.
static COMPUTED: LazyLock<String> = LazyLock::new(table::text);

/// What differs, of the lines that `is` chooses.
fn differences(is: fn(&str) -> bool) -> Vec<String> {
    let (written, computed) = (lines(include_str!("../bounds.toml")), lines(&COMPUTED));
    let names: BTreeSet<&String> =
        written.keys().chain(computed.keys()).filter(|name| is(name)).collect();
    let differ = names.into_iter().filter(|name| written.get(*name) != computed.get(*name));
    differ
        .map(|name| {
            format!("{name}: {:?}, and {:?} of the code", written.get(name), computed.get(name))
        })
        .collect()
}

const WRITE: &str =
    "`cargo run -- bounds` writes those of the code as it is; then run.sh proves them";

#[test]
fn the_tapes_are_those_that_were_proved() {
    let differ = differences(|name| name.ends_with("tapes"));
    assert!(differ.is_empty(), "{differ:#?}\n{WRITE}");
}

#[test]
fn every_bound_is_what_the_code_has() {
    let differ = differences(|name| !name.ends_with("tapes"));
    assert!(differ.is_empty(), "{differ:#?}\n{WRITE}");
}
