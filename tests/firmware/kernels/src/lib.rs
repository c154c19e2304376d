//! The operations of dq8 as functions that a linker can be asked for, by name: `forward_…`,
//! `clip_…`, `core_…`, `more_…`, `robot_…`, `ik_…` and `arm_…`.
//! `scripts/check_firmware.py` links them in groups, without an allocator and without a panic
//! handler, and measures what comes out.
#![no_std]

mod clip;
mod forward;
mod ik;
mod more;
mod robot;
mod single;

use never_panics as _;
