//! Sweeps of the one-variable functions over the floats of `f32`, against `f64`.
//!
//! Every `DQ8_SWEEP_STRIDE`-th float is taken, by its bits, so small angles are met as often as
//! large ones. The default samples. In a release build a stride of 31 takes a minute or two of one
//! core. A stride of 1 takes every float there is: three quarters of an hour for the functions
//! (`functions`), and as long for the motions.

mod functions;
mod motions;
mod worst;

fn stride() -> u32 {
    match std::env::var("DQ8_SWEEP_STRIDE") {
        Err(_) => 65_537,
        Ok(text) => text.parse().expect("DQ8_SWEEP_STRIDE is a whole number"),
    }
}
