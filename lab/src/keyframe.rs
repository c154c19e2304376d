//! Keyframes between matrices after Alexa (2002), as Arends tells it and as Alexa means it.

use crate::{LogarithmError, logarithm};
use dq8::{DualQuat, Real};
use nalgebra::{Matrix3, Matrix4};

/// The matrix of a unit σ.
pub fn matrix(sigma: DualQuat<f64>) -> Matrix4<f64> {
    let rows = sigma.to_matrix4();
    Matrix4::from_fn(|row, column| rows[row][column])
}

/// How far the rotation R of an affine matrix is from orthonormal: the largest element of RᵀR −
/// 1; NaN if one is.
pub fn orthonormality_error(a: &Matrix4<f64>) -> f64 {
    let r: Matrix3<f64> = a.fixed_view::<3, 3>(0, 0).into();
    (r.transpose() * r - Matrix3::identity()).fold(0.0, |most, c| most.max_or_nan(c.abs()))
}

/// s ⊙ A = exp(s log A) (Alexa 2002; Arends, chapter 2, §4): the part s of a transformation. For
/// a rigid motion it is the power of its screw, [`DualQuat::pow`].
///
/// # Errors
/// If A has no principal [`logarithm`].
///
/// ```
/// use nalgebra::{Matrix4, Vector3};
/// let grow = Matrix4::new_nonuniform_scaling(&Vector3::new(4.0, 9.0, 1.0));
/// let half = Matrix4::new_nonuniform_scaling(&Vector3::new(2.0, 3.0, 1.0));
/// assert!((lab::keyframe::scale(0.5, &grow)? - half).amax() < 1e-14);
/// # Ok::<(), lab::LogarithmError>(())
/// ```
pub fn scale(s: f64, a: &Matrix4<f64>) -> Result<Matrix4<f64>, LogarithmError> {
    Ok((logarithm(a)? * s).exp())
}

/// A ⊕ B = exp(log A + log B) (Alexa 2002; Arends, chapter 2, §4): neither first. AB where they
/// commute.
///
/// # Errors
/// If A or B has no principal [`logarithm`].
pub fn add(a: &Matrix4<f64>, b: &Matrix4<f64>) -> Result<Matrix4<f64>, LogarithmError> {
    Ok((logarithm(a)? + logarithm(b)?).exp())
}

/// C(t) = ((1 − t) ⊙ A) ⊕ (t ⊙ B) = exp((1 − t) log A + t log B) (Alexa 2002; Arends,
/// chapter 2, §4), from A at t = 0 to B at t = 1. In one exponential: taking logarithms of the two
/// parts again would be the same, but for rounding and, outside [0, 1], for parts beyond half a
/// turn.
///
/// # Errors
/// If A or B has no principal [`logarithm`].
///
/// ```
/// use nalgebra::{Matrix4, Vector3};
/// let [a, b, middle] = [0.5, 1.5, 1.0].map(|angle| Matrix4::new_rotation(Vector3::z() * angle));
/// assert!((lab::keyframe::interpolate(&a, &b, 0.5)? - middle).amax() < 1e-15);
/// # Ok::<(), lab::LogarithmError>(())
/// ```
pub fn interpolate(
    a: &Matrix4<f64>,
    b: &Matrix4<f64>,
    t: f64,
) -> Result<Matrix4<f64>, LogarithmError> {
    Ok((logarithm(a)? * (1.0 - t) + logarithm(b)? * t).exp())
}

/// C(t) with e and ln of each element, as Arends reads it (chapter 2, §4): aᵢⱼ^(1−t)
/// bᵢⱼᵗ, shifted by `offset` before and back after, because elements must be positive. NaN
/// where one is not.
///
/// It ends where it should, but between the ends it turns nothing rigid into something rigid, and
/// what it gives depends on `offset`, for which he has no rule; [`smallest_offset`] is one.
pub fn interpolate_elements(
    a: &Matrix4<f64>,
    b: &Matrix4<f64>,
    t: f64,
    offset: f64,
) -> Matrix4<f64> {
    a.zip_map(b, |a, b| {
        let (a, b) = (a + offset, b + offset);
        if a > 0.0 && b > 0.0 { ((1.0 - t) * a.ln() + t * b.ln()).exp() - offset } else { f64::NAN }
    })
}

/// What makes every element of both at least 1 and the smallest just that; zero if they are.
pub fn smallest_offset(a: &Matrix4<f64>, b: &Matrix4<f64>) -> f64 {
    (1.0 - a.min().min(b.min())).max(0.0)
}
