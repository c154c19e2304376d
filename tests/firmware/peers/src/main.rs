//! Instructions on a Cortex-M4F: dq8, nalgebra's isometries and micromath's quaternions, the same
//! work on the same numbers. A peer's answer is checked like ours, or it would not count.
#![no_std]
#![no_main]

mod between;
mod biped;
mod contender;
mod points;
mod product;

use core::panic::PanicInfo;
use cortex_m_rt::entry;
use dq8_firmware_cortex_m4::Mps2;
use dq8_firmware_jobs::Table;

#[entry]
fn main() -> ! {
    let mut board = Mps2::power_on();
    let mut table = Table::begin(&mut board);
    product::run(&mut table);
    biped::run(&mut table);
    points::run(&mut table);
    between::run(&mut table);
    console::exit(table.end())
}

/// Peers may panic.
#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    console::exit(false)
}
