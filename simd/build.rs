//! Sets `cfg(opt_level_0)`, as the build script of dq8 does, which says why.
//!
//! The tests of this repository optimise the lanes a little and call them all the same: that is
//! twice as quick as to call what is not optimised, and compiles no longer. They say so by
//! `DQ8_CALLED_LANES`, because whoever else builds with `opt-level = 1` wants kernels inlined.

use std::env::var;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=DQ8_CALLED_LANES");
    println!("cargo:rustc-check-cfg=cfg(opt_level_0)");
    let is_called = match var("OPT_LEVEL").as_deref() {
        Ok("0") => true,
        Ok("1") => var("DQ8_CALLED_LANES").is_ok_and(|called| called == "1"),
        _ => false,
    };
    if is_called {
        println!("cargo:rustc-cfg=opt_level_0");
    }
}
