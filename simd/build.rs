//! Sets `cfg(opt_level_0)` in builds without optimisation. The build script of dq8 says why.
//!
//! The tests of this repository build this crate with `opt-level = 1`, but call the operations on
//! lanes instead of inlining them. This runs twice as fast as calls of unoptimised operations, and
//! does not take longer to compile. The tests set `DQ8_CALLED_LANES=1` for this, because all other
//! builds with `opt-level = 1` want inlined kernels.

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
