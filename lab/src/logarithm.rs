//! The principal logarithm of a matrix, which nalgebra lacks.

use core::fmt;
use nalgebra::{Complex, Matrix4, Schur};

/// A matrix without a principal logarithm.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum LogarithmError {
    /// An element is infinite or NaN.
    NotFinite {
        /// The row of the element.
        row: usize,
        /// Its column.
        column: usize,
        /// The element.
        value: f64,
    },
    /// An eigenvalue is zero or negative, as that of a half turn is: the logarithm is cut there.
    Eigenvalue {
        /// Its real part.
        real: f64,
        /// Its imaginary part, rounding alone.
        imaginary: f64,
    },
    /// Eigenvalues or square roots did not settle within as many steps as are ever needed.
    NotConverged {
        /// How many steps were made.
        steps: usize,
    },
}

impl fmt::Display for LogarithmError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no principal logarithm: ")?;
        match self {
            Self::NotFinite { row, column, value } => {
                write!(f, "the element in row {row}, column {column} is {value}")
            }
            Self::Eigenvalue { real, imaginary } => {
                write!(f, "the eigenvalue {real} + {imaginary}i is zero or negative")
            }
            Self::NotConverged { steps } => write!(f, "no convergence in {steps} steps"),
        }
    }
}

impl core::error::Error for LogarithmError {}

/// How near to the negative real axis an eigenvalue counts as on it, relative to the largest: a few
/// roundings. Those of half turns were seen to come out on it exactly.
const ON_THE_AXIS: f64 = 1e-14;

/// More steps than any matrix with a principal logarithm needs: a square root halves the exponent
/// of an eigenvalue bit by bit.
const MAX_STEPS: usize = 1200;

/// Where the Padé approximant of order 7 is exact to rounding (Higham 2008, table 11.1, θ₇).
const NEAR_IDENTITY: f64 = 0.264;

/// Nodes and weights of Gauss and Legendre on [−1, 1], of order 7.
const NODES: [(f64, f64); 7] = [
    (0.0, 0.417_959_183_673_469_4),
    (0.405_845_151_377_397_2, 0.381_830_050_505_118_9),
    (-0.405_845_151_377_397_2, 0.381_830_050_505_118_9),
    (0.741_531_185_599_394_4, 0.279_705_391_489_276_64),
    (-0.741_531_185_599_394_4, 0.279_705_391_489_276_64),
    (0.949_107_912_342_758_5, 0.129_484_966_168_869_7),
    (-0.949_107_912_342_758_5, 0.129_484_966_168_869_7),
];

/// The principal logarithm: the X with eˣ = A whose eigenvalues have imaginary parts between −π
/// and π (Higham 2008, theorem 1.31), for any A, of a motion or not.
///
/// Inverse scaling and squaring: log A = 2ᵏ log A^(1/2ᵏ), by square roots until the root is
/// near the identity (Higham 2008, §11.5). The error is about 10⁻¹⁵ times the largest element
/// of A, and near a half turn, at an angle θ, that over π − θ.
///
/// # Errors
/// If A has an element that is not finite, or an eigenvalue on the closed negative real axis.
///
/// ```
/// use lab::logarithm;
/// use nalgebra::{Matrix4, Vector3};
/// let shift = Matrix4::new_translation(&Vector3::new(1.0, 2.0, 3.0));
/// assert!((logarithm(&shift)? - (shift - Matrix4::identity())).amax() < 1e-15);
/// let half_turn = Matrix4::new_rotation(Vector3::z() * core::f64::consts::PI);
/// assert!(logarithm(&half_turn).is_err());
/// # Ok::<(), lab::LogarithmError>(())
/// ```
pub fn logarithm(a: &Matrix4<f64>) -> Result<Matrix4<f64>, LogarithmError> {
    let identity = Matrix4::identity();
    check(a)?;
    let (mut root, mut power) = (*a, 1.0);
    while one_norm(&(root - identity)) > NEAR_IDENTITY {
        root = square_root(&root)?;
        power *= 2.0;
    }
    let x = root - identity;
    let mut sum = Matrix4::zeros();
    for (node, weight) in NODES {
        // ∫₀¹ x(1 + sx)⁻¹ ds = log(1 + x)
        let denominator = identity + x * (0.5 * (1.0 + node));
        sum += inverse(&denominator)? * x * (0.5 * weight);
    }
    Ok(sum * power)
}

/// The principal square root by the iteration of Denman and Beavers (Higham 2008, eq. 6.15): Xₖ
/// → √A, Yₖ → 1/√A. Not by its product form (eq. 6.29), which begins with A + 1/A: near a
/// half turn that keeps 1 + cos θ of the motion and loses sin θ, so the error grows as 1/(π −
/// θ)².
fn square_root(a: &Matrix4<f64>) -> Result<Matrix4<f64>, LogarithmError> {
    let (mut x, mut y) = (*a, Matrix4::identity());
    let mut before = f64::INFINITY;
    for _ in 0..MAX_STEPS {
        let distance = one_norm(&(x * y - Matrix4::identity()));
        // Convergence is quadratic in the end: what no longer shrinks there is rounding, which is
        // as large as the two factors are.
        let rounding = 1e3 * f64::EPSILON * one_norm(&x) * one_norm(&y);
        if distance < rounding.clamp(1e-8, 1e-2) && distance >= 0.5 * before {
            return Ok(x);
        }
        before = distance;
        let next = (x + inverse(&y)?) * 0.5;
        y = (y + inverse(&x)?) * 0.5;
        x = next;
    }
    Err(LogarithmError::NotConverged { steps: MAX_STEPS })
}

/// That a principal logarithm exists.
fn check(a: &Matrix4<f64>) -> Result<(), LogarithmError> {
    for column in 0..4 {
        for row in 0..4 {
            let value = a[(row, column)];
            if !value.is_finite() {
                return Err(LogarithmError::NotFinite { row, column, value });
            }
        }
    }
    let schur = Schur::try_new(*a, f64::EPSILON, MAX_STEPS)
        .ok_or(LogarithmError::NotConverged { steps: MAX_STEPS })?;
    let eigenvalues = schur.complex_eigenvalues();
    let largest = eigenvalues.iter().fold(0.0, |largest: f64, e| largest.max(e.norm()));
    let cut =
        |e: &&Complex<f64>| e.norm() == 0.0 || (e.re <= 0.0 && e.im.abs() <= ON_THE_AXIS * largest);
    match eigenvalues.iter().find(cut) {
        Some(e) => Err(LogarithmError::Eigenvalue { real: e.re, imaginary: e.im }),
        None => Ok(()),
    }
}

/// An inverse that exists where there is no eigenvalue zero.
fn inverse(a: &Matrix4<f64>) -> Result<Matrix4<f64>, LogarithmError> {
    // By its factors: the determinant of a small or large matrix leaves the range of numbers.
    a.lu().try_inverse().ok_or(LogarithmError::Eigenvalue { real: 0.0, imaginary: 0.0 })
}

fn one_norm(a: &Matrix4<f64>) -> f64 {
    a.column_iter().fold(0.0, |largest, column| column.lp_norm(1).max(largest))
}
