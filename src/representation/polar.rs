//! Rotations of matrices that are not quite rotations: the nearest rotation by polar decomposition,
//! and the rotation of the Gram–Schmidt process.

use super::OrthonormalError;
use crate::number::Real;
use crate::scalar::{Quat, vector};

/// Returns the rotation matrix that the Gram–Schmidt process makes of a matrix (Gram 1883,
/// Schmidt 1907; Kenwright §3.5.2 recommends it against drift). Its first column has the direction
/// of the first column of the input, its second column is in the plane of the first two columns of
/// the input, and its third column is the cross product of the first two. Input and output are
/// rows.
///
/// The process is cheap, but it treats the axes differently: the first axis keeps its direction and
/// the other axes take the errors, so another order of axes gives another rotation.
/// [`Polar`](crate::representation::Polar) gives the nearest rotation. The first column is
/// projected out of the second column twice. If the two are nearly parallel, a single projection
/// would leave them at a right angle only up to an error of the rounding unit divided by the sine
/// of the angle between them.
///
/// # Errors
/// If an element is not finite, a column is within rounding of the span of the columns before it,
/// or the matrix mirrors.
///
/// ```
/// let drifted = [[2.0_f64, 0.5, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 3.0]];
/// let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// assert_eq!(dq8::representation::gram_schmidt(drifted)?, identity);
/// # Ok::<(), dq8::representation::OrthonormalError>(())
/// ```
pub fn gram_schmidt<R: Real>(rows: [[R; 3]; 3]) -> Result<[[R; 3]; 3], OrthonormalError> {
    all_finite(rows)?;
    let least = R::from(4.0) * R::EPSILON;
    let column = |index: usize| {
        let column = rows.map(|row| row[index]);
        let largest = vector::largest(column);
        if largest == R::ZERO {
            return Err(OrthonormalError::Dependent { column: index, sine: 0.0 });
        }
        // The column is divided by its largest element before its length is computed, because the
        // length may overflow.
        Ok(direction(column.map(|c| c / largest)))
    };
    let x = column(0)?;
    let across = vector::across(x, column(1)?);
    let sine = vector::norm(across);
    if sine <= least {
        return Err(OrthonormalError::Dependent { column: 1, sine: sine.into() });
    }
    let y = direction(vector::across(x, direction(across)));
    let z = vector::cross(x, y);
    let height = vector::dot(z, column(2)?);
    if height.abs() <= least {
        return Err(OrthonormalError::Dependent { column: 2, sine: height.abs().into() });
    }
    if height < R::ZERO {
        return Err(OrthonormalError::Mirrors { determinant: (sine * height).into() });
    }
    Ok(core::array::from_fn(|row| [x[row], y[row], z[row]]))
}

/// Checks that all elements of a matrix with these rows are finite.
///
/// # Errors
/// If an element is not finite.
#[inline]
pub(super) fn all_finite<R: Real>(rows: [[R; 3]; 3]) -> Result<(), OrthonormalError> {
    for (row, elements) in rows.into_iter().enumerate() {
        for (column, value) in elements.into_iter().enumerate() {
            if !value.is_finite() {
                return Err(OrthonormalError::NotFinite { row, column, value: value.into() });
            }
        }
    }
    Ok(())
}

fn direction<R: Real>(v: [R; 3]) -> [R; 3] {
    let norm = vector::norm(v);
    v.map(|c| c / norm)
}

/// The polar decomposition of a 3×3 matrix, A = R S: a stretch S along three orthogonal
/// directions, then a rotation R. R is the rotation nearest to A, measured by the sum of the
/// squares of the differences of the elements (Fan & Hoffman 1955), and does not depend on the
/// order of the axes.
///
/// ```
/// use dq8::{Quat, representation::Polar};
/// let stretched = [[0.0_f64, -3.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
/// let Polar { rotation, stretch, mirrors } = Polar::try_from_matrix3(stretched)?;
/// let quarter = Quat::from_axis_angle([0.0, 0.0, 1.0], core::f64::consts::FRAC_PI_2);
/// assert!((rotation - quarter).norm() < 1e-15 && !mirrors);
/// assert!((stretch[0][0] - 2.0).abs() + (stretch[1][1] - 3.0).abs() < 1e-14);
/// # Ok::<(), dq8::representation::OrthonormalError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polar<R> {
    /// The rotation R, unit, with w ≥ 0.
    pub rotation: Quat<R>,
    /// The stretch S = RᵀA, a symmetric matrix. Its eigenvalues are the singular values of A, all
    /// of them negated if A mirrors.
    pub stretch: [[R; 3]; 3],
    /// `true` if the determinant of A is negative. No rotation mirrors, so R is then the rotation
    /// nearest to −A, and S mirrors in the origin (Shoemake & Duff 1992 keep this sign as a
    /// factor of its own).
    pub mirrors: bool,
}

impl<R: Real> Polar<R> {
    /// Returns the decomposition of the matrix A with these rows.
    ///
    /// The sum of the products of the elements of A and of the rotation matrix of q is a quadratic
    /// form of q. The nearest rotation is therefore the eigenvector for the largest eigenvalue of a
    /// symmetric 4×4 matrix (Horn 1987; Higham & Noferini 2016). The four eigenvalues of −A are
    /// the negated eigenvalues of A. With the singular values σ₁ ≥ σ₂ ≥ σ₃ the largest
    /// is σ₁ + σ₂ + σ₃ for whichever of A and −A does not mirror, and it is smaller for
    /// the other matrix. This comparison decides `mirrors`. Newton's iteration (Higham 1986)
    /// inverts A in each step. The method here inverts nothing, so it also works for a flat A
    /// (σ₃ = 0 within rounding); `mirrors` is then `false`.
    ///
    /// # Errors
    /// If an element of A or of S is not finite (S overflows where singular values do), or if A
    /// squeezes space into a line or a point within rounding (σ₂ = σ₃ = 0), because many
    /// rotations are then equally near.
    pub fn try_from_matrix3(rows: [[R; 3]; 3]) -> Result<Self, OrthonormalError> {
        let Spectrum { largest, values, vectors } = Spectrum::of(rows)?;
        let rounding = rounding::<R>();
        let [most, least] =
            [place_of_the_largest(values), place_of_the_largest(values.map(|v| -v))];
        let mirrors = -values[least] > values[most] * (R::ONE + rounding);
        let (best, sign) = if mirrors { (least, -R::ONE) } else { (most, R::ONE) };
        let (rotation, _) = rotation(values.map(|value| sign * value), vectors, best)?;
        // If elements are near the largest float, intermediate sums may overflow although S does
        // not.
        let scale = if largest > R::from(1e30) { R::from(0.25) } else { R::ONE };
        let stretch = stretch(rotation, rows.map(|row| row.map(|c| c * scale)));
        let stretch = stretch.map(|row| row.map(|c| c / scale));
        all_finite(stretch)?;
        Ok(Self { rotation, stretch, mirrors })
    }
}

/// The eigenvalues and eigenvectors of Horn's 4×4 matrix ([`horn`]) of a 3×3 matrix A, which is
/// first divided by its largest element, `largest`.
pub(crate) struct Spectrum<R> {
    largest: R,
    values: [R; 4],
    vectors: [[R; 4]; 4],
}

impl<R: Real> Spectrum<R> {
    pub(crate) fn of(rows: [[R; 3]; 3]) -> Result<Self, OrthonormalError> {
        all_finite(rows)?;
        let largest = vector::largest(rows.map(vector::largest));
        if largest == R::ZERO {
            return Err(OrthonormalError::Ambiguous { gap: 0.0 });
        }
        let (values, vectors) = eigen(horn(rows.map(|row| row.map(|c| c / largest))));
        Ok(Self { largest, values, vectors })
    }

    /// Makes the spectrum from the largest element of A, and from eigenvalues and eigenvectors that
    /// were computed elsewhere.
    pub(crate) fn new(largest: R, values: [R; 4], vectors: [[R; 4]; 4]) -> Self {
        Self { largest, values, vectors }
    }

    /// Returns the rotation R, with w ≥ 0, for which the sum of the products of its elements and
    /// the elements of A is largest. It is the rotation nearest to A, also if A mirrors: the
    /// smallest axis of A is then reversed (Horn 1987; Umeyama 1991), whereas [`Polar`] reverses
    /// all three. Also returns this sum, which is σ₁ + σ₂ ± σ₃ with the singular values
    /// and a minus if A mirrors, and the gap σ₂ ± σ₃, which is the larger, the more clearly
    /// R is the best rotation.
    ///
    /// # Errors
    /// If many rotations are equally good: A squeezes space into a line or a point within rounding,
    /// or it mirrors and its two smaller singular values are equal.
    pub(crate) fn best_rotation(&self) -> Result<(Quat<R>, [R; 2]), OrthonormalError> {
        let Self { largest, values, vectors } = *self;
        let best = place_of_the_largest(values);
        let (rotation, gap) = rotation(values, vectors, best)?;
        Ok((rotation, [R::ONE, gap].map(|share| share * values[best] * largest)))
    }

    /// Returns the singular values σ₁ ≥ σ₂ ≥ σ₃ of A, with σ₃ negated if A mirrors.
    /// The eigenvalues of [`horn`] are σ₁ + σ₂ + σ₃, σ₁ − σ₂ − σ₃, σ₂ −
    /// σ₁ − σ₃ and σ₃ − σ₁ − σ₂. Half the sum of the first and the second is
    /// σ₁; the third gives σ₂ and the fourth σ₃ in the same way.
    pub(crate) fn singular_values(&self) -> [R; 3] {
        let Self { largest, values: [a, b, c, d], .. } = *self;
        // A network of five comparisons sorts the eigenvalues. The method `sort` is not called,
        // because it contains a panic for inconsistent orders.
        let order = |a: R, b: R| if a < b { [b, a] } else { [a, b] };
        let ([a, b], [c, d]) = (order(a, b), order(c, d));
        let ([first, c], [b, fourth]) = (order(a, c), order(b, d));
        let [second, third] = order(b, c);
        [second, third, fourth].map(|other| (first + other) * R::HALF * largest)
    }
}

/// Returns the largest difference between two values of about 1 that is taken for rounding error.
fn rounding<R: Real>() -> R {
    R::from(32.0) * R::EPSILON
}

fn place_of_the_largest<R: Real>(values: [R; 4]) -> usize {
    (1..4).fold(0, |most, index| if values[index] > values[most] { index } else { most })
}

/// Returns the rotation whose quaternion is the eigenvector of `values[best]`, the largest
/// eigenvalue, if it is clearly larger than all others. Also returns the gap: half of the
/// difference between the largest and the next eigenvalue, divided by the largest.
fn rotation<R: Real>(
    values: [R; 4],
    vectors: [[R; 4]; 4],
    best: usize,
) -> Result<(Quat<R>, R), OrthonormalError> {
    let others = values.into_iter().enumerate().filter(|(index, _)| *index != best);
    // No other eigenvalue is below −λ, where λ is the largest, so the search starts from −λ.
    let next =
        others.fold(-values[best], |next, (_, other)| if other > next { other } else { next });
    let gap = (values[best] - next) / (R::TWO * values[best]);
    if gap <= rounding() {
        return Err(OrthonormalError::Ambiguous { gap: gap.into() });
    }
    let rotation = Quat::from_array(vectors.map(|row| row[best])).normalize();
    Ok((if rotation.w() < R::ZERO { -rotation } else { rotation }, gap))
}

/// Returns the symmetric 4×4 matrix K with q·Kq = Σ aᵢⱼ rᵢⱼ, where aᵢⱼ are the
/// elements of a 3×3 matrix A and rᵢⱼ those of the rotation matrix of a unit quaternion q
/// (Horn 1987).
fn horn<R: Real>([[a, b, c], [d, e, f], [g, h, i]]: [[R; 3]; 3]) -> [[R; 4]; 4] {
    [
        [a - e - i, b + d, c + g, h - f],
        [b + d, e - a - i, f + h, c - g],
        [c + g, f + h, i - a - e, d - b],
        [h - f, c - g, d - b, a + e + i],
    ]
}

/// Returns the symmetric part of RᵀA, with R = `rotation` and A = `rows`. The antisymmetric part
/// consists of rounding errors only.
fn stretch<R: Real>(rotation: Quat<R>, rows: [[R; 3]; 3]) -> [[R; 3]; 3] {
    let axes = rotation.to_matrix3();
    let product = |i: usize, j: usize| (0..3).fold(R::ZERO, |sum, k| sum + axes[k][i] * rows[k][j]);
    core::array::from_fn(|row| {
        core::array::from_fn(|column| {
            let (i, j) = (row.min(column), row.max(column));
            // The mean of two elements is computed as the first plus half of the difference,
            // because their sum may overflow, and half of a small element may become zero.
            let above = product(i, j);
            above + (product(j, i) - above) * R::HALF
        })
    })
}

/// The largest number of sweeps over the matrix. No matrix in the tests takes more than six sweeps,
/// because each sweep about squares the elements off the diagonal, so they vanish quickly.
const MAX_SWEEPS: usize = 10;

/// Returns the eigenvalues of a symmetric 4×4 matrix with elements around 1, in no particular
/// order, and the unit eigenvectors as columns. The method is cyclic Jacobi (Golub & Van Loan 2013,
/// algorithm 8.5.3), which always converges and keeps the eigenvectors orthogonal.
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
                // The turn acts on both sides of the matrix: on its columns, then on the columns of
                // its transpose. The result is symmetric, so it need not be transposed back.
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

/// A turn in the plane of the coordinates `p` and `q`, which is one step of the Jacobi method.
struct Turn<R> {
    p: usize,
    q: usize,
    cosine: R,
    sine: R,
}

impl<R: Real> Turn<R> {
    fn columns_of(&self, matrix: &mut [[R; 4]; 4]) {
        // Both indices are below four. The masks show this to the compiler: without them it would
        // compile bounds checks where this function is not inlined.
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
