//! The jobs on a Cortex-M4F.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use dq8_firmware_cortex_m4::Mps2;
use never_panics as _;

#[entry]
fn main() -> ! {
    console::exit(dq8_firmware_jobs::run(&mut Mps2::power_on()))
}
