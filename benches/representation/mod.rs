//! [`Representation`]: one rigid motion as peers hold it.

mod glam;
mod nalgebra;

use dq8::DualQuat;

/// Three rows of [R | t], in which every representation can be compared.
pub(crate) type Rows = [[f64; 4]; 3];

pub(crate) trait Representation: Copy + 'static {
    fn from_motion(motion: &DualQuat<f32>) -> Self;
    /// `self` · `first`: `first` acts first.
    fn product(&self, first: &Self) -> Self;
    fn rows(&self) -> Rows;
}
