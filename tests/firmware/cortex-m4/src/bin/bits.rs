//! What everything computes on a Cortex-M4F has the bits of all other machines.
#![no_std]
#![no_main]

use cortex_m_rt::entry;

#[entry]
fn main() -> ! {
    console::exit(dq8_bits::report(&mut console::print))
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    console::exit(false)
}
