//! Hyper-dual numbers and quaternions: Arends' chapter 5, and dq8's nested dual numbers as the
//! second opinion.

#[path = "hyper_dual/numbers.rs"]
mod numbers;
#[path = "hyper_dual/quaternions.rs"]
mod quaternions;
#[path = "hyper_dual/twins.rs"]
mod twins;

use lab::HyperDual;
use proptest::prelude::{Strategy, any};

type Number = HyperDual<f64>;

/// Numbers from −`limit` to `limit`.
fn reals<const N: usize>(limit: f64) -> impl Strategy<Value = [f64; N]> {
    proptest::array::uniform::<_, N>(-limit..limit)
}

/// With real parts whose size is from ¼ to 4, so that there is an inverse.
fn invertible() -> impl Strategy<Value = Number> {
    (0.25..4.0, any::<bool>(), reals(2.0)).prop_map(|(size, negative, [b, c, d]): (f64, _, _)| {
        HyperDual::new(if negative { -size } else { size }, b, c, d)
    })
}

fn parts(x: Number) -> [f64; 4] {
    [x.real, x.first, x.second, x.mixed]
}

/// Every component within `tolerance` of the wanted one.
#[track_caller]
fn assert_close<const N: usize>(found: [f64; N], wanted: [f64; N], tolerance: f64) {
    for (i, (a, b)) in found.into_iter().zip(wanted).enumerate() {
        assert!((a - b).abs() <= tolerance, "{i}: {a} for {b}, off by {:e}", (a - b).abs());
    }
}
