//! [`Representation`]: one rigid motion as peers hold it.

mod glam;
mod nalgebra;

use dq8::DualQuat;

/// Three rows of [R | t], in which every representation can be compared.
pub(crate) type Rows = [[f64; 4]; 3];

/// Motions that can be multiplied, one or as many as lanes.
pub(crate) trait Product: Copy {
    /// `self` · `first`: `first` acts first.
    fn product(&self, first: &Self) -> Self;
}

pub(crate) trait Representation: Product + 'static {
    fn from_motion(motion: &DualQuat<f32>) -> Self;
    fn rows(&self) -> Rows;
}
