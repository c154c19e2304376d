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

#[test]
fn the_experiment_finds_two_statements_of_the_thesis_wrong() {
    let found = lab::hyper_dual_claims::section().unwrap().found;
    assert_eq!(found[0], "8 of the 10 lines of the table hold up to rounding.");
    assert!(found[1].starts_with("(xy)† = y†x†, all four used (§5.2): off by"), "{found:?}");
    assert!(
        found[2].starts_with("rotation and translation, the sum as printed (§5.4)"),
        "{found:?}"
    );
    assert_eq!(found.len(), 3);
}
