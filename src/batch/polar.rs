//! The eigenvectors that rotations of matrices are made of, on lanes, one matrix in each lane.

use super::vector::{epsilon, select};
use dq8_simd::{Lanes, Mask};

/// The largest number of sweeps, as for a single matrix. No matrix in the tests takes more than
/// six.
const MAX_SWEEPS: usize = 10;

/// Returns the matrix K with q·Kq = Σ aᵢⱼ rᵢⱼ, the sum over the elements of A and of the
/// rotation matrix of a unit q (Horn 1987).
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn horn<L: Lanes>([[a, b, c], [d, e, f], [g, h, i]]: [[L; 3]; 3]) -> [[L; 4]; 4] {
    [
        [a - e - i, b + d, c + g, h - f],
        [b + d, e - a - i, f + h, c - g],
        [c + g, f + h, i - a - e, d - b],
        [h - f, c - g, d - b, a + e + i],
    ]
}

/// Returns the eigenvalues of a symmetric 4×4 matrix with elements around 1, in no order, and the
/// unit eigenvectors as columns. The method is cyclic Jacobi (Golub & Van Loan 2013, algorithm
/// 8.5.3).
///
/// A lane whose element is negligible keeps its matrix while other lanes turn theirs, and no
/// product is fused with a sum. Each lane therefore has the bits of a single matrix.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn eigen<L: Lanes>(mut matrix: [[L; 4]; 4]) -> ([L; 4], [[L; 4]; 4]) {
    let zero = matrix[0][0].constant(0.0);
    let mut vectors = [[zero; 4]; 4];
    for (index, row) in vectors.iter_mut().enumerate() {
        row[index] = zero.constant(1.0);
    }
    for _ in 0..MAX_SWEEPS {
        let settled = turn::<L, 0, 1>(&mut matrix, &mut vectors);
        let settled = settled & turn::<L, 0, 2>(&mut matrix, &mut vectors);
        let settled = settled & turn::<L, 0, 3>(&mut matrix, &mut vectors);
        let settled = settled & turn::<L, 1, 2>(&mut matrix, &mut vectors);
        let settled = settled & turn::<L, 1, 3>(&mut matrix, &mut vectors);
        let settled = settled & turn::<L, 2, 3>(&mut matrix, &mut vectors);
        if settled.all() {
            break;
        }
    }
    let [[a, ..], [_, b, ..], [_, _, c, _], [.., d]] = matrix;
    ([a, b, c, d], vectors)
}

/// Turns in the plane of the coordinates P and Q, so that the element of both becomes zero. Returns
/// the lanes that keep their matrix, because that element is negligible.
#[cfg_attr(not(opt_level_0), inline(always))]
fn turn<L: Lanes, const P: usize, const Q: usize>(
    matrix: &mut [[L; 4]; 4],
    vectors: &mut [[L; 4]; 4],
) -> L::Mask {
    let off = matrix[P][Q];
    let [zero, one, two] = [off.constant(0.0), off.constant(1.0), off.constant(2.0)];
    let negligible = off.abs().le(off.constant(epsilon::<L>() * epsilon::<L>()));
    let tau = (matrix[Q][Q] - matrix[P][P]) / (two * off);
    let tangent = one / (tau.abs() + (one + tau * tau).sqrt());
    let tangent = L::select(tau.lt(zero), -tangent, tangent);
    let cosine = one / (one + tangent * tangent).sqrt();
    let sine = tangent * cosine;
    // The transpose of the matrix differs from the matrix by rounding, so a lane that keeps its
    // matrix must not be transposed either.
    let mut turned = *matrix;
    columns::<L, P, Q>(&mut turned, cosine, sine);
    turned = transpose(turned);
    columns::<L, P, Q>(&mut turned, cosine, sine);
    let mut turned_vectors = *vectors;
    columns::<L, P, Q>(&mut turned_vectors, cosine, sine);
    for row in 0..4 {
        matrix[row] = select(negligible, matrix[row], turned[row]);
        vectors[row] = select(negligible, vectors[row], turned_vectors[row]);
    }
    negligible
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn columns<L: Lanes, const P: usize, const Q: usize>(matrix: &mut [[L; 4]; 4], cosine: L, sine: L) {
    for row in matrix {
        let (x, y) = (row[P], row[Q]);
        row[P] = cosine * x - sine * y;
        row[Q] = sine * x + cosine * y;
    }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn transpose<L: Lanes>(matrix: [[L; 4]; 4]) -> [[L; 4]; 4] {
    let mut transposed = matrix;
    for (i, row) in matrix.into_iter().enumerate() {
        for (j, element) in row.into_iter().enumerate() {
            transposed[j][i] = element;
        }
    }
    transposed
}
