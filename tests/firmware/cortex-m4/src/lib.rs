//! The board with a Cortex-M4F: `qemu-system-arm -M mps2-an386`.
#![no_std]

use dq8_firmware_jobs::Board;

/// Console and clock of the board.
#[derive(Debug)]
pub struct Mps2(());

/// A timer that counts down at 25 MHz: control, value, reload.
const TIMER: *mut [u32; 3] = 0x4000_0000 as *mut [u32; 3];

impl Mps2 {
    /// Starts the clock.
    pub fn power_on() -> Self {
        // SAFETY: the registers of timer 0 (CMSDK), which nothing else uses.
        unsafe {
            (&raw mut (*TIMER)[2]).write_volatile(u32::MAX);
            (&raw mut (*TIMER)[1]).write_volatile(u32::MAX);
            (&raw mut (*TIMER)[0]).write_volatile(1);
        }
        Self(())
    }
}

impl Board for Mps2 {
    const NAME: &'static str = "Cortex-M4F, FPU in single precision (QEMU mps2-an386)";

    fn print(&mut self, text: &str) {
        console::print(text);
    }

    /// With `-icount shift=10` an instruction is 1024 ns: 25.6 ticks. The 167 million that the
    /// timer can count are more than all jobs take.
    fn instructions(&mut self) -> u32 {
        // SAFETY: as above; reading has no effect.
        let ticks = u32::MAX - unsafe { (&raw const (*TIMER)[1]).read_volatile() };
        (u64::from(ticks) * 5 / 128) as u32
    }
}
