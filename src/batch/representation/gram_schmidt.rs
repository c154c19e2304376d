use crate::batch::length::Length;
use crate::batch::vector;
use dq8_simd::Lanes;

/// [`gram_schmidt`](crate::representation::gram_schmidt) on lanes: rotation matrices with the first column in the direction of
/// the matrix's first and the second in the plane of its first two; and the lanes without one. There an
/// element is not finite, a column is within rounding of the span of those before it, or the matrix mirrors,
/// and all elements are NaN.
///
/// ```
/// use dq8::{batch::gram_schmidt_checked, simd::{Mask, f32x4}};
/// let [zero, one] = [0.0, 1.0].map(f32x4::splat);
/// let height = f32x4::new([3.0, 0.5, 0.0, -1.0]);
/// let (turn, failed) = gram_schmidt_checked([[one, one, zero], [zero, one, zero], [zero, zero, height]]);
/// assert_eq!(failed.to_bitmask(), 0b1100);
/// assert_eq!(turn[0][1].to_array()[..2], [0.0, 0.0]);
/// ```
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn gram_schmidt_checked<L: Lanes>(rows: [[L; 3]; 3]) -> ([[L; 3]; 3], L::Mask) {
    let one = rows[0][0].constant(1.0);
    let least = one.constant(4.0 * vector::epsilon::<L>());
    let column = |index: usize| [rows[0][index], rows[1][index], rows[2][index]];
    let x = Length::of(column(0), one);
    let x = x.divide_all(column(0));
    let y = Length::of(column(1), one);
    let across = vector::across(x, y.divide_all(column(1)));
    let sine = Length::of(across, one);
    let y = vector::across(x, sine.divide_all(across));
    let y = Length::of(y, one).divide_all(y);
    let z = vector::cross(x, y);
    let height = Length::of(column(2), one).divide_all(column(2));
    let height = vector::dot(z, height);
    // A zero column is NaN by now, and so no more than anything.
    let stands = least.lt(sine.value()) & least.lt(height);
    let finite = rows.map(vector::are_finite).into_iter().fold(stands, |all, row| all & row);
    let nan = [one.constant(f64::NAN); 3];
    let row = |i: usize| vector::select(!finite, nan, [x[i], y[i], z[i]]);
    ([row(0), row(1), row(2)], !finite)
}
