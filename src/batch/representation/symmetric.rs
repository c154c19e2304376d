//! Eigenvalues of symmetric matrices.

use dq8_simd::{Lanes, Mask};

/// No matrix in the tests takes more than six: from a sweep to the next, what is left off the
/// diagonal is squared.
const MAX_SWEEPS: usize = 10;

/// The eigenvalues of symmetric 4×4 matrices with elements around 1, in no order, and the unit
/// eigenvectors, one a column: cyclic Jacobi, until the last lane has settled. A lane that does not turn keeps
/// its numbers to the last bit, so they do not depend on the others.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn eigen<L: Lanes>(mut matrix: [[L; 4]; 4]) -> ([L; 4], [[L; 4]; 4]) {
    let (zero, one) = (matrix[0][0].constant(0.0), matrix[0][0].constant(1.0));
    let epsilon = super::vector::epsilon::<L>();
    let negligible = one.constant(epsilon * epsilon);
    let mut vectors = [[zero; 4]; 4];
    for (index, row) in vectors.iter_mut().enumerate() {
        row[index] = one;
    }
    for _ in 0..MAX_SWEEPS {
        let mut settled = true;
        for p in 0..3 {
            for q in p + 1..4 {
                let off = matrix[p][q];
                let turns = negligible.lt(off.abs());
                if !turns.any() {
                    continue;
                }
                settled = false;
                let tau = (matrix[q][q] - matrix[p][p]) / (off + off);
                let tangent = one / (tau.abs() + tau.mul_add(tau, one).sqrt());
                let tangent = L::select(tau.lt(zero), -tangent, tangent);
                let tangent = L::select(turns, tangent, zero);
                let cosine = one / tangent.mul_add(tangent, one).sqrt();
                let turn = Turn { p, q, cosine, sine: tangent * cosine };
                // The matrix is symmetric: its rows turn as the columns of its transpose.
                turn.columns_of(&mut matrix);
                matrix = transpose(matrix);
                turn.columns_of(&mut matrix);
                // And back: its two triangles differ by rounding, and other lanes do not turn.
                matrix = transpose(matrix);
                turn.columns_of(&mut vectors);
            }
        }
        if settled {
            break;
        }
    }
    let values = [matrix[0][0], matrix[1][1], matrix[2][2], matrix[3][3]];
    (values, vectors)
}

/// Turns in the plane of two coordinates.
struct Turn<L> {
    p: usize,
    q: usize,
    cosine: L,
    sine: L,
}

impl<L: Lanes> Turn<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn columns_of(&self, matrix: &mut [[L; 4]; 4]) {
        for row in matrix {
            let (x, y) = (row[self.p], row[self.q]);
            row[self.p] = self.sine.neg_mul_add(y, self.cosine * x);
            row[self.q] = self.sine.mul_add(x, self.cosine * y);
        }
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn transpose<L: Lanes>(matrix: [[L; 4]; 4]) -> [[L; 4]; 4] {
    let mut turned = matrix;
    for (row, elements) in matrix.into_iter().enumerate() {
        for (column, element) in elements.into_iter().enumerate() {
            turned[column][row] = element;
        }
    }
    turned
}
