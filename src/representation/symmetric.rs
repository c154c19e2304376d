//! Eigenvalues of symmetric matrices.

use crate::number::Real;

/// No matrix in the tests takes more than six: from a sweep to the next, what is left off the
/// diagonal is squared.
const MAX_SWEEPS: usize = 10;

/// The eigenvalues of a symmetric 4×4 matrix with elements around 1, in no order, and the unit
/// eigenvectors, one a column: cyclic Jacobi (Golub & Van Loan 2013, algorithm 8.5.3), which always
/// converges and keeps the eigenvectors orthogonal.
pub(super) fn eigen<R: Real>(mut matrix: [[R; 4]; 4]) -> ([R; 4], [[R; 4]; 4]) {
    let mut vectors = [[R::ZERO; 4]; 4];
    for (index, row) in vectors.iter_mut().enumerate() {
        row[index] = R::ONE;
    }
    let negligible = R::EPSILON * R::EPSILON;
    for _ in 0..MAX_SWEEPS {
        let mut settled = true;
        for p in 0..3 {
            for q in p + 1..4 {
                let off = matrix[p][q];
                if off.abs() <= negligible {
                    continue;
                }
                settled = false;
                let tau = (matrix[q][q] - matrix[p][p]) / (R::TWO * off);
                let tangent = R::ONE / (tau.abs() + (R::ONE + tau * tau).sqrt());
                let tangent = if tau < R::ZERO { -tangent } else { tangent };
                let cosine = R::ONE / (R::ONE + tangent * tangent).sqrt();
                let turn = Turn { p, q, cosine, sine: tangent * cosine };
                // The matrix is symmetric: its rows turn as the columns of its transpose.
                turn.columns_of(&mut matrix);
                matrix = transpose(matrix);
                turn.columns_of(&mut matrix);
                turn.columns_of(&mut vectors);
            }
        }
        if settled {
            break;
        }
    }
    (core::array::from_fn(|index| matrix[index][index]), vectors)
}

/// A turn in the plane of two coordinates.
struct Turn<R> {
    p: usize,
    q: usize,
    cosine: R,
    sine: R,
}

impl<R: Real> Turn<R> {
    fn columns_of(&self, matrix: &mut [[R; 4]; 4]) {
        // Below four in any case; so no code for indices beyond is left where this is not inlined.
        let (p, q) = (self.p & 3, self.q & 3);
        for row in matrix {
            let (x, y) = (row[p], row[q]);
            row[p] = self.cosine * x - self.sine * y;
            row[q] = self.sine * x + self.cosine * y;
        }
    }
}

fn transpose<R: Real>(matrix: [[R; 4]; 4]) -> [[R; 4]; 4] {
    core::array::from_fn(|column| matrix.map(|row| row[column]))
}
