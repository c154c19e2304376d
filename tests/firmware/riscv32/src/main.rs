//! RISC-V of 32 bits without an FPU: `qemu-system-riscv32 -M virt -bios none`.
#![no_std]
#![no_main]

use core::arch::{asm, global_asm};
use dq8_firmware_jobs::Board;
use never_panics as _;

// A stack. The emulator has cleared the memory and loaded the image.
global_asm!(
    ".section .text.start, \"ax\"",
    ".global start",
    "start:",
    "la sp, stack_top",
    "j main",
);

struct Virt;

impl Board for Virt {
    const NAME: &'static str = "RISC-V rv32imac, floats in software (QEMU virt)";

    fn print(&mut self, text: &str) {
        console::print(text);
    }

    fn instructions(&mut self) -> u32 {
        let retired: u32;
        // SAFETY: reads the counter of retired instructions, which machine mode may. The number is
        // that of `minstret`, whose name the assembler knows only with an extension of the target.
        unsafe { asm!("csrr {}, 0xb02", out(reg) retired) };
        retired
    }
}

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    console::exit(dq8_firmware_jobs::run(&mut Virt))
}
