//! Matrices as the sources write them, generic over the number: for operations that are counted,
//! and for rounding in single precision that must be that of the textbook's sums.

use dq8::Real;

/// Rows, acting on columns.
pub type Matrix<R, const ROWS: usize, const COLUMNS: usize> = [[R; COLUMNS]; ROWS];

/// The sum of products of the elements, without a product or a sum with zero.
fn sum_of_products<R: Real, const N: usize>(a: [R; N], b: [R; N]) -> R {
    let mut products = a.into_iter().zip(b).map(|(a, b)| a * b);
    let first = products.next().unwrap_or(R::ZERO);
    products.fold(first, |sum, product| sum + product)
}

fn column<R: Real, const N: usize, const M: usize>(matrix: Matrix<R, N, M>, j: usize) -> [R; N] {
    matrix.map(|row| row[j])
}

/// AB by the schoolbook: an element is the product of a row and a column.
///
/// ```
/// let a = [[1.0, 2.0], [3.0, 4.0]];
/// assert_eq!(lab::matrix::product(a, [[0.0, 1.0], [1.0, 0.0]]), [[2.0, 1.0], [4.0, 3.0]]);
/// ```
pub fn product<R: Real, const L: usize, const M: usize, const N: usize>(
    a: Matrix<R, L, M>,
    b: Matrix<R, M, N>,
) -> Matrix<R, L, N> {
    a.map(|row| core::array::from_fn(|j| sum_of_products(row, column(b, j))))
}

/// Av
pub fn apply<R: Real, const L: usize, const M: usize>(a: Matrix<R, L, M>, v: [R; M]) -> [R; L] {
    a.map(|row| sum_of_products(row, v))
}

/// `[A | s][B | t] = [AB | At + s]`: the last rows 0 0 0 1 are neither stored nor multiplied.
pub fn affine_product<R: Real>(a: Matrix<R, 3, 4>, b: Matrix<R, 3, 4>) -> Matrix<R, 3, 4> {
    let linear = product(left(a), left(b));
    let shift = affine_apply(a, column(b, 3));
    core::array::from_fn(|i| [linear[i][0], linear[i][1], linear[i][2], shift[i]])
}

/// Av + s
pub fn affine_apply<R: Real>(a: Matrix<R, 3, 4>, v: [R; 3]) -> [R; 3] {
    a.map(|[x, y, z, s]| sum_of_products([x, y, z], v) + s)
}

/// `[A | s]⁻¹ = [Aᵀ | −Aᵀs]` of a rotation A.
pub fn rigid_inverse<R: Real>(a: Matrix<R, 3, 4>) -> Matrix<R, 3, 4> {
    let transposed: Matrix<R, 3, 3> = core::array::from_fn(|i| column(left(a), i));
    let shift = apply(transposed, column(a, 3));
    core::array::from_fn(|i| {
        let [x, y, z] = transposed[i];
        [x, y, z, -shift[i]]
    })
}

/// The 3×3 part.
pub fn left<R: Real>(a: Matrix<R, 3, 4>) -> Matrix<R, 3, 3> {
    a.map(|[x, y, z, _]| [x, y, z])
}

/// With the row 0 0 0 1 below.
pub fn homogeneous<R: Real>([a, b, c]: Matrix<R, 3, 4>) -> Matrix<R, 4, 4> {
    [a, b, c, [R::ZERO, R::ZERO, R::ZERO, R::ONE]]
}

/// The rotations by `angles` about the axes x, y and z (Kenwright §3.3, Arends §2.2), radians.
pub fn about_axes<R: Real>(angles: [R; 3]) -> [Matrix<R, 3, 3>; 3] {
    let (zero, one) = (R::ZERO, R::ONE);
    let [(sx, cx), (sy, cy), (sz, cz)] = angles.map(|angle| (angle.sin(), angle.cos()));
    [
        [[one, zero, zero], [zero, cx, -sx], [zero, sx, cx]],
        [[cy, zero, sy], [zero, one, zero], [-sy, zero, cy]],
        [[cz, -sz, zero], [sz, cz, zero], [zero, zero, one]],
    ]
}

/// The rotation by `angle` radians about the unit `axis` n: cos θ 1 + (1 − cos θ) nnᵀ + sin
/// θ N, Nv = n × v (Rodrigues 1840).
pub fn about<R: Real>([x, y, z]: [R; 3], angle: R) -> Matrix<R, 3, 3> {
    let (sin, cos) = (angle.sin(), angle.cos());
    let rest = R::ONE - cos;
    [
        [cos + rest * x * x, rest * x * y - sin * z, rest * x * z + sin * y],
        [rest * x * y + sin * z, cos + rest * y * y, rest * y * z - sin * x],
        [rest * x * z - sin * y, rest * y * z + sin * x, cos + rest * z * z],
    ]
}

/// The rows made orthonormal by Gram and Schmidt: the first keeps its direction, the second what is
/// orthogonal to it, and the third is their cross product (Kenwright §3.5.2). Of a singular
/// matrix, NaN.
pub fn gram_schmidt<R: Real>([x, y, _]: Matrix<R, 3, 3>) -> Matrix<R, 3, 3> {
    let unit = |v: [R; 3]| {
        let reciprocal = R::ONE / sum_of_products(v, v).sqrt();
        v.map(|c| c * reciprocal)
    };
    let x = unit(x);
    let along = sum_of_products(x, y);
    let y = unit(core::array::from_fn(|i| y[i] - along * x[i]));
    let z = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
    [x, y, z]
}

/// AᵀA − 1, by which columns fail to be orthonormal: off the diagonal the skew, on it the
/// scale.
pub fn distortion(a: Matrix<f64, 3, 3>) -> Matrix<f64, 3, 3> {
    core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let wanted = if i == j { 1.0 } else { 0.0 };
            sum_of_products(column(a, i), column(a, j)) - wanted
        })
    })
}

/// The largest element of [`distortion`] off the diagonal: the sine of how far two axes are from a
/// right angle.
pub fn skew(a: Matrix<f64, 3, 3>) -> f64 {
    let d = distortion(a);
    d[0][1].abs().max(d[0][2].abs()).max(d[1][2].abs())
}

/// The largest element of [`distortion`] on the diagonal: twice the relative change of a length
/// along an axis.
pub fn stretch(a: Matrix<f64, 3, 3>) -> f64 {
    let d = distortion(a);
    d[0][0].abs().max(d[1][1].abs()).max(d[2][2].abs())
}

/// ‖v‖
pub(crate) fn length([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}

/// How far apart the origins of two frames are.
pub(crate) fn distance(a: Matrix<f64, 3, 4>, b: Matrix<f64, 3, 4>) -> f64 {
    length([0, 1, 2].map(|i| a[i][3] - b[i][3]))
}
