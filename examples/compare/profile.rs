//! What the measured code was compiled with.

/// Every contender is built in this workspace, with one profile. Users' own crates have other
/// settings.
pub(crate) const PROFILE: &str = if cfg!(debug_assertions) {
    "workspace dev: not optimised, times mean nothing"
} else {
    "workspace release: thin LTO, one codegen unit"
};

#[cfg(test)]
mod tests {
    /// LTO is nothing that a program can ask for, so the manifest is read.
    #[test]
    fn the_release_profile_is_what_the_output_says() {
        let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/../../Cargo.toml");
        let manifest = std::fs::read_to_string(manifest).unwrap();
        let (_, profile) = manifest.split_once("[profile.release]\n").unwrap();
        let profile = profile.split("\n[").next().unwrap();
        for setting in ["lto = \"thin\"", "codegen-units = 1"] {
            assert!(profile.lines().any(|line| line == setting), "no {setting} in {profile}");
        }
    }
}
