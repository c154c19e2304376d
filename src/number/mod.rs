//! The element types of the scalar reference, [`Real`]. The results of their functions have the
//! same bits on every machine.

mod real;
#[cfg(any(feature = "std", feature = "libm"))]
mod sine;

pub use real::{Real, Scalar};
