//! The hashes are those of all other machines.

mod list;

use std::collections::BTreeSet;

/// What `hashes` tells are the lines of `bits.tsv` whose entry is, or is not, the example.
fn compare(hashes: fn(&mut dq8_bits::Sink<'_>), of_the_example: bool) {
    let (mut found, mut others) = (BTreeSet::new(), Vec::new());
    hashes(&mut |name, hash| {
        let line = format!("{}\t{hash:016x}", name.join("\t"));
        if !dq8_bits::KNOWN.lines().any(|known| known == line) {
            others.push(line.clone());
        }
        found.insert(line);
    });
    assert!(others.is_empty(), "other bits:\n{}", others.join("\n"));
    let known = |line: &&str| line.contains("\texample\t") == of_the_example;
    let known = dq8_bits::KNOWN.lines().filter(known).count();
    assert_eq!(found.len(), known, "what is known is no longer computed");
}

#[test]
fn every_function_and_job_has_the_bits_that_all_machines_have() {
    compare(dq8_bits::parts, false);
}

#[test]
fn ten_thousand_steps_of_the_example_have_the_bits_that_all_machines_have() {
    compare(dq8_bits::example, true);
}

/// The guide lists what is hashed, number by number and entry by entry the same.
#[test]
fn the_guide_lists_what_is_hashed() {
    let guide = include_str!("../../src/guide/reproducible.md");
    assert!(guide.contains(list::list().trim_end()), "the list should be:\n{}", list::list());
}

#[test]
fn the_readme_names_the_hash_of_the_example() {
    let known =
        dq8_bits::KNOWN.lines().find_map(|line| line.strip_prefix("f32\texample\tlockstep\t"));
    let hash = known.expect("the example is hashed");
    assert!(include_str!("../../README.md").contains(hash), "README.md should name {hash}");
}
