//! Sets `cfg(opt_level_0)`, as the build script of dq8 does, which says why.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rustc-check-cfg=cfg(opt_level_0)");
    if std::env::var("OPT_LEVEL").is_ok_and(|level| level == "0") {
        println!("cargo:rustc-cfg=opt_level_0");
    }
}
