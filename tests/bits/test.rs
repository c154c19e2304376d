//! The hashes are those of all other machines.

mod list;

use std::collections::BTreeSet;

#[test]
fn every_function_and_job_has_the_bits_that_all_machines_have() {
    let (mut found, mut others) = (BTreeSet::new(), Vec::new());
    dq8_bits::hashes(&mut |name, hash| {
        let line = format!("{}\t{hash:016x}", name.join("\t"));
        if !dq8_bits::KNOWN.lines().any(|known| known == line) {
            others.push(line.clone());
        }
        found.insert(line);
    });
    assert!(others.is_empty(), "other bits:\n{}", others.join("\n"));
    assert_eq!(found.len(), dq8_bits::KNOWN.lines().count(), "what is known is no longer computed");
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
