//! Sets `cfg(opt_level_0)` where nothing is optimised, which the source cannot ask for itself.
//!
//! Optimised kernels are inlined whole, or the compiler would keep what they call from the
//! instructions that they are for. Without optimisation that makes nothing faster, each value takes
//! a place of its own on the stack (up to 3.7 MiB), and a kernel tens of kilobytes: there the
//! operations on lanes are functions that are called.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rustc-check-cfg=cfg(opt_level_0)");
    if std::env::var("OPT_LEVEL").is_ok_and(|level| level == "0") {
        println!("cargo:rustc-cfg=opt_level_0");
    }
}
