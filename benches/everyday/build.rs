//! Says how the crate is built, for the head of the table.

use std::env::var;

fn main() {
    let known = |name: &str| var(name).unwrap_or_default();
    let cargo_decides = ["LTO", "CODEGEN_UNITS"].map(|what| {
        let set = known(&format!("CARGO_PROFILE_RELEASE_{what}"));
        if set.is_empty() { format!("{what} default") } else { format!("{what} {set}") }
    });
    let features = known("CARGO_CFG_TARGET_FEATURE");
    let flags = known("CARGO_ENCODED_RUSTFLAGS").replace('\u{1f}', " ");
    println!(
        "cargo::rustc-env=BUILT={} profile, opt-level {}, {}; {} with {features}; RUSTFLAGS \"{flags}\"",
        known("PROFILE"),
        known("OPT_LEVEL"),
        cargo_decides.join(", "),
        known("CARGO_CFG_TARGET_ARCH"),
    );
}
