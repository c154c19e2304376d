//! Numbers of the scalar reference, [`Real`], whose functions have the same bits everywhere.

mod real;
#[cfg(any(feature = "std", feature = "libm"))]
mod sine;

pub use real::{Real, Scalar};
