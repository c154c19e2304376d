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

/// The largest difference between two elements; NaN if there is any.
pub(crate) fn largest_difference(a: &Rows, b: &Rows) -> f64 {
    let pairs = a.as_flattened().iter().zip(b.as_flattened());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, |largest, difference| {
        if difference > largest || difference.is_nan() { difference } else { largest }
    })
}
