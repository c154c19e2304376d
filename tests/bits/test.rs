//! The hashes are those of all other machines.

use std::collections::BTreeSet;

#[test]
fn every_function_and_job_has_the_bits_that_all_machines_have() {
    let mut others = Vec::new();
    let same = dq8_bits::compare(&mut |name, hash| others.push(format!("{name:?} {hash:016x}")));
    assert!(others.is_empty(), "{} the same, others:\n{}", same, others.join("\n"));
    let mut names = BTreeSet::new();
    dq8_bits::hashes(&mut |name, _| {
        names.insert(name.join("\t"));
    });
    let known = dq8_bits::KNOWN.lines().filter_map(|line| line.rsplit_once('\t'));
    assert_eq!(known.map(|(name, _)| name.to_owned()).collect::<BTreeSet<_>>(), names);
}
