use super::symmetric;
use super::{all_finite, quat_without, without};
use crate::batch::Quat;
use dq8_simd::Lanes;

/// The polar decomposition of 3×3 matrices, A = R S: [`Polar`](crate::representation::Polar) on lanes.
#[derive(Clone, Copy, Debug)]
pub struct Polar<L: Lanes> {
    /// R, unit, w ≥ 0.
    pub rotation: Quat<L>,
    /// S = RᵀA, symmetric. Its eigenvalues are the singular values of A, all of them negated if A
    /// mirrors.
    pub stretch: [[L; 3]; 3],
    /// The determinant of A is negative.
    pub mirrors: L::Mask,
}

impl<L: Lanes> Polar<L> {
    /// The decomposition of the rows, by the eigenvector of the largest eigenvalue of a symmetric 4×4 matrix
    /// (Horn 1987), and the lanes without one: an element is not finite, of A or of S, or A squeezes space
    /// into a line or a point within rounding. Those are NaN.
    ///
    /// ```
    /// use dq8::{batch::Polar, simd::{Mask, f64x2}};
    /// let [zero, one] = [0.0, 1.0].map(f64x2::splat);
    /// let other = f64x2::new([2.0, 0.0]);
    /// let rows = [[zero, -other, zero], [one, zero, zero], [zero, zero, other]];
    /// let (polar, failed) = Polar::from_matrix3_checked(rows);
    /// assert_eq!(failed.to_bitmask(), 0b10);
    /// assert!((polar.stretch[1][1].to_array()[0] - 2.0).abs() < 1e-15);
    /// ```
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn from_matrix3_checked(rows: [[L; 3]; 3]) -> (Self, L::Mask) {
        let (zero, one) = (rows[0][0].constant(0.0), rows[0][0].constant(1.0));
        let mut largest = zero;
        for element in rows.as_flattened() {
            let size = element.abs();
            largest = L::select(largest.lt(size), size, largest);
        }
        let finite = all_finite(rows);
        // What is not finite would only keep the others waiting.
        let sane = finite & zero.lt(largest);
        let divisor = L::select(sane, largest, one);
        let mut scaled = rows;
        for element in scaled.as_flattened_mut() {
            *element = L::select(sane, *element / divisor, zero);
        }
        let (values, vectors) = symmetric::eigen(horn(scaled));

        let (mut most, mut least) = (values[0], values[0]);
        for value in values {
            most = L::select(most.lt(value), value, most);
            least = L::select(value.lt(least), value, least);
        }
        let rounding = one.constant(32.0 * super::vector::epsilon::<L>());
        let mirrors = (most * (one + rounding)).lt(-least);
        let sign = L::select(mirrors, -one, one);
        // The largest of the signed values with its vector, and the next one.
        let column = |index: usize| {
            let [x, y, z, w] = vectors;
            [x[index], y[index], z[index], w[index]]
        };
        let (mut best, mut next, mut vector) = (sign * values[0], -one / zero, column(0));
        for (index, value) in values.into_iter().enumerate().skip(1) {
            let value = sign * value;
            let better = best.lt(value);
            let beaten = L::select(better, best, value);
            next = L::select(next.lt(beaten), beaten, next);
            best = L::select(better, value, best);
            vector = super::vector::select(better, column(index), vector);
        }
        // The others are not further below than −λ.
        next = L::select(next.lt(-best), -best, next);
        let gap = (best - next) / (best + best);

        let rotation = Quat::from_array(vector).normalize();
        let rotation = rotation.scale(L::select(rotation.w().lt(zero), -one, one));
        // Near the top of the range the sums on the way may overflow where S does not.
        let small = one.constant(0.25);
        let scale = L::select(one.constant(1e30).lt(largest), small, one);
        let stretch = stretch(rotation, rows, scale);
        let failed = !(sane & rounding.lt(gap) & all_finite(stretch));
        let rotation = quat_without(failed, rotation);
        (Self { rotation, stretch: without(failed, stretch), mirrors }, failed)
    }
}

/// K with q·Kq = Σ aᵢⱼ rᵢⱼ, the sum over the elements of A and of the rotation matrix of a unit q.
#[cfg_attr(not(opt_level_0), inline(always))]
fn horn<L: Lanes>([[a, b, c], [d, e, f], [g, h, i]]: [[L; 3]; 3]) -> [[L; 4]; 4] {
    [
        [a - e - i, b + d, c + g, h - f],
        [b + d, e - a - i, f + h, c - g],
        [c + g, f + h, i - a - e, d - b],
        [h - f, c - g, d - b, a + e + i],
    ]
}

/// The symmetric part of RᵀA; the other part is rounding. Summed up `scale` times as large.
#[cfg_attr(not(opt_level_0), inline(always))]
fn stretch<L: Lanes>(rotation: Quat<L>, rows: [[L; 3]; 3], scale: L) -> [[L; 3]; 3] {
    let axes = rotation.to_matrix3();
    let mut stretch = rows;
    for i in 0..3 {
        for j in i..3 {
            let (mut above, mut below) = (scale.constant(0.0), scale.constant(0.0));
            for (axis, row) in axes.iter().zip(rows) {
                above = axis[i].mul_add(row[j] * scale, above);
                below = axis[j].mul_add(row[i] * scale, below);
            }
            // Half of the difference: half of the sum may overflow, a sum of halves vanish.
            let middle = (below - above).mul_add(scale.constant(0.5), above) / scale;
            stretch[i][j] = middle;
            stretch[j][i] = middle;
        }
    }
    stretch
}
