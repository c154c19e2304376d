//! Numbers that Coq computes with: fractions, and the weights of inequalities.

use crate::polynomial::{Matrix, Monomial, norm};
use std::collections::BTreeMap;

/// For each cell of a matrix M ≥ 0 a weight w with 2xy ≤ wx² + y²/w, so that the sums over a
/// row and over a column are the norm of M: ratios of the entries of its singular vectors (Perron
/// and Frobenius).
pub(crate) fn weights(matrix: &Matrix) -> Vec<((Monomial, Monomial), String)> {
    let mut columns: BTreeMap<&Monomial, f64> =
        matrix.keys().map(|(_, column)| (column, 1.0)).collect();
    let mut rows = BTreeMap::new();
    let norm = norm(matrix);
    for _ in 0..60 {
        rows = BTreeMap::<&Monomial, f64>::new();
        for ((row, column), c) in matrix {
            *rows.entry(row).or_default() += c * columns[column] / norm;
        }
        columns = BTreeMap::new();
        for ((row, column), c) in matrix {
            *columns.entry(column).or_default() += c * rows[row] / norm;
        }
    }
    let weight = |(row, column): &(Monomial, Monomial)| columns[column] / rows[row];
    matrix
        .keys()
        .map(|cell| (cell.clone(), rational((weight(cell) * 1e6).round().max(1.0) / 1e6)))
        .collect()
}

/// A number as a fraction, exactly: of few decimals, or of a power of two.
pub(crate) fn rational(c: f64) -> String {
    if c.fract() == 0.0 {
        return format!("({c:.0})");
    }
    let decimal = (c * 1e6).round();
    if decimal / 1e6 == c {
        return format!("({decimal:.0} / 1000000)");
    }
    let mut denominator = 1.0;
    while (c * denominator).fract() != 0.0 {
        denominator *= 2.0;
    }
    format!("({:.0} / {denominator:.0})", c * denominator)
}
