//! Hyper-dual numbers and quaternions: Arends' chapter 5.

mod numbers;
mod quaternions;

use crate::inputs::reals;
use lab::{HyperDual, hyper_dual};
use proptest::prelude::{Strategy, any};

type Number = HyperDual<f64>;

/// With real parts whose size is from ¼ to 4, so that there is an inverse.
fn invertible() -> impl Strategy<Value = Number> {
    (0.25..4.0, any::<bool>(), reals(2.0)).prop_map(|(size, negative, [b, c, d]): (f64, _, _)| {
        hyper_dual(if negative { -size } else { size }, b, c, d)
    })
}
