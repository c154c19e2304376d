//! Build facts for tests, benches and diagnostics: what the target offers, as environment variables
//! that `env!` reads. No code is generated.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let fact = |name: &str| std::env::var(name).unwrap_or_default();
    println!("cargo:rustc-env=DQ8_TARGET={}", fact("TARGET"));
    println!("cargo:rustc-env=DQ8_TARGET_FEATURES={}", fact("CARGO_CFG_TARGET_FEATURE"));
    println!("cargo:rustc-env=DQ8_OPT_LEVEL={}", fact("OPT_LEVEL"));
}
