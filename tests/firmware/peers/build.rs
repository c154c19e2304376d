//! The linker script of `cortex-m-rt`; the memory map comes with the board.

fn main() {
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
}
