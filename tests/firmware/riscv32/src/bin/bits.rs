//! What everything computes without an FPU has the bits of all other machines.
#![no_std]
#![no_main]

use core::arch::global_asm;

// As in the other image.
global_asm!(
    ".section .text.start, \"ax\"",
    ".global start",
    "start:",
    "la sp, stack_top",
    "j main",
);

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    console::exit(dq8_bits::report(&mut console::print))
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    console::exit(false)
}
