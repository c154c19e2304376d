//! Hands on what the compiler is told, for the page of times.

fn main() {
    let flags = std::env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
    println!("cargo:rustc-env=LAB_RUSTFLAGS={}", flags.replace('\u{1f}', " "));
    println!("cargo:rerun-if-changed=build.rs");
}
