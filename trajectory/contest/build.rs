//! Compiles the peers in C++ as their projects do, for the CPU of this machine.

include!("src/sizes.rs");

fn main() {
    println!("cargo:rerun-if-changed=src/peers.cpp");
    println!("cargo:rerun-if-changed=src/sizes.rs");
    let mut build = cc::Build::new();
    for (name, size) in [("POINTS", POINTS), ("POSES", POSES), ("CONTROL", CONTROL)] {
        build.define(name, size.to_string().as_str());
    }
    build.cpp(true).std("c++17").opt_level(3).flag("-march=native").define("NDEBUG", None);
    build.include("/usr/include/eigen3").file("src/peers.cpp").compile("peers");
}
