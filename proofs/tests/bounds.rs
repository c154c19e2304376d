//! `bounds.toml` says what the tapes of today's code say: with no tool installed, a body fails here
//! whose error grows, or whose operations are others than those that were proved.

use dq8_proofs::table;
use std::sync::LazyLock;

/// Computed once for both tests.
static COMPUTED: LazyLock<String> = LazyLock::new(table::text);

/// The lines of tapes, or all others, each after the name of its section.
fn compare(of_tapes: bool) {
    let lines = |text: &'static str| -> Vec<String> {
        let sections = text.split("\n[").flat_map(|section| {
            let (name, lines) = section.split_once('\n').unwrap_or_default();
            lines.lines().map(move |line| format!("[{name} {line}"))
        });
        sections.filter(|line| line.contains("] tapes") == of_tapes).collect()
    };
    let (written, computed) = (lines(include_str!("../bounds.toml")), lines(&COMPUTED));
    let differ: Vec<_> = computed.iter().filter(|line| !written.contains(line)).collect();
    assert!(
        written == computed,
        "of the code: {differ:#?}\n`cargo run -- bounds` writes bounds.toml anew; then run.sh proves it"
    );
}

#[test]
fn the_tapes_are_those_that_were_proved() {
    compare(true);
}

#[test]
fn every_bound_is_what_the_code_has() {
    compare(false);
}
