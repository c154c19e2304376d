//! The functions on arrays, and the laws they compute.

pub mod actions;
pub mod algebra;
pub mod between;
pub mod chains;
pub mod conversions;
pub mod distances;
mod faults;
mod function;
pub mod matrices;
pub mod means;
pub mod screws;
pub mod squad;
pub mod windows;

use dq8::{Lanes, batch};

#[inline(always)]
fn motion<L: Lanes>(components: [L; 8]) -> batch::DualQuat<L> {
    batch::DualQuat::from_array(components)
}

/// Two vectors as one element.
#[inline(always)]
fn joined<L: Lanes>([a, b, c]: [L; 3], [d, e, f]: [L; 3]) -> [L; 6] {
    [a, b, c, d, e, f]
}

/// One element as two vectors.
#[inline(always)]
fn halves<L: Lanes>([a, b, c, d, e, f]: [L; 6]) -> ([L; 3], [L; 3]) {
    ([a, b, c], [d, e, f])
}
