//! `bounds.toml` says what the tapes of today's code say. A body whose error grows, or whose order of operations changes,
//! fails here, with no tool installed.

use dq8_proofs::table;

#[test]
fn every_bound_is_what_the_code_has() {
    let (written, computed) = (include_str!("../bounds.toml"), table::text());
    for (written, computed) in written.lines().zip(computed.lines()) {
        assert_eq!(
            written, computed,
            "bounds.toml; `cargo run -- bounds` writes the bounds of the code as it is"
        );
    }
    assert_eq!(written.lines().count(), computed.lines().count());
}
