//! aarch64 without an operating system: `qemu-system-aarch64 -M virt -cpu cortex-a53`.
#![no_std]
#![no_main]

use core::arch::{asm, global_asm};
use dq8_firmware_jobs::Board;
use never_panics as _;

// A stack, and NEON at EL1. The emulator has cleared the memory and loaded the image.
global_asm!(
    ".section .text.start, \"ax\"",
    ".global start",
    "start:",
    "ldr x0, =stack_top",
    "mov sp, x0",
    "mrs x0, cpacr_el1",
    "orr x0, x0, #(3 << 20)",
    "msr cpacr_el1, x0",
    "isb",
    "b main",
);

struct Virt;

impl Board for Virt {
    const NAME: &'static str = "aarch64, NEON (QEMU virt, Cortex-A53)";

    fn print(&mut self, text: &str) {
        console::print(text);
    }

    /// With `-icount shift=4` an instruction is 16 ns, which is one tick.
    fn instructions(&mut self) -> u32 {
        let ticks: u64;
        // SAFETY: reads the virtual counter, which every level may.
        unsafe { asm!("isb", "mrs {}, cntvct_el0", out(reg) ticks) };
        ticks as u32
    }
}

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    console::exit(dq8_firmware_jobs::run(&mut Virt))
}
