//! For matrices near rotations.

use super::{each, sine, three};
use crate::case::length;
use crate::vectors::Vector;
use nalgebra::Matrix3;

/// The largest singular value, and it over the sum of the two others: how much farther than the
/// matrix its nearest rotation moves; no less than 1, because the rotation rounds.
pub(super) fn sizes(rows: &[f64]) -> (f64, f64) {
    let largest = rows.iter().fold(0.0, |largest: f64, c| largest.max(c.abs()));
    let scaled = Matrix3::from_row_iterator(rows.iter().map(|c| c / largest));
    let values = scaled.singular_values();
    (largest * values[0], (values[0] / (values[1] + values[2])).max(1.0))
}

pub(crate) fn polar(vector: &Vector) -> Vec<f64> {
    let (size, moves) = sizes(vector.input("rows"));
    [each(4, moves), each(9, size * moves), each(1, 1.0)].concat()
}

/// The first column is exact but for a rounding; the others are known as well as it, over the sine
/// between the first two.
pub(crate) fn orthonormal(vector: &Vector) -> Vec<f64> {
    let rows = vector.input("rows");
    let column = |c: usize| [rows[c], rows[3 + c], rows[6 + c]];
    let turn = 1.0 / sine(column(0), column(1));
    [1.0, turn, turn].repeat(3)
}

/// The dual part is half of the translation.
pub(crate) fn rigid(vector: &Vector) -> Vec<f64> {
    let rows = vector.input("rows");
    let translation = length(&three(&[rows[3], rows[7], rows[11]]));
    [each(4, 1.0), each(4, translation.max(1.0))].concat()
}
