use crate::keyframe;
use crate::matrix::Matrix;
use core::array::from_fn;
use dq8::DualQuat;

/// A way from one pose to another.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// For tables and legends.
    pub name: &'static str,
    /// The rows of `[A | t]` on the way from the first, at 0, to the second, at 1.
    pub at: fn(DualQuat<f64>, DualQuat<f64>, f64) -> Matrix<f64, 3, 4>,
}

/// All that are compared.
pub const METHODS: [Method; 8] = [
    Method { name: "matrix LERP", at: matrix_lerp },
    Method { name: "LERP", at: lerp },
    Method { name: "NLERP", at: |a, b, t| a.nlerp(b, t).to_matrix3x4() },
    Method { name: "DLB", at: dlb },
    Method { name: "SLERP and LERP", at: |a, b, t| a.slerp_lerp(b, t).to_matrix3x4() },
    Method { name: "ScLERP", at: |a, b, t| a.sclerp(b, t).to_matrix3x4() },
    Method { name: "ScLERP, sign kept", at: |a, b, t| a.sclerp_long(b, t).to_matrix3x4() },
    Method { name: "keyframes after Alexa", at: alexa },
];

/// (1−t)A + tB, element by element.
fn matrix_lerp(a: DualQuat<f64>, b: DualQuat<f64>, t: f64) -> Matrix<f64, 3, 4> {
    let (a, b) = (a.to_matrix3x4(), b.to_matrix3x4());
    from_fn(|i| from_fn(|j| (1.0 - t) * a[i][j] + t * b[i][j]))
}

/// (1−t)a ± tb as it is, not normalized.
fn lerp(a: DualQuat<f64>, b: DualQuat<f64>, t: f64) -> Matrix<f64, 3, 4> {
    let near = if a.dot(b).real < 0.0 { -b } else { b };
    (a.scale(1.0 - t) + near.scale(t)).to_matrix3x4()
}

fn dlb(a: DualQuat<f64>, b: DualQuat<f64>, t: f64) -> Matrix<f64, 3, 4> {
    let blend = DualQuat::dlb(&[(a, 1.0 - t), (b, t)]);
    blend.expect("two influences are not none").to_matrix3x4()
}

/// exp((1−t) log A + t log B). Its logarithm ends before half a turn from the frame that A and B
/// are told in: NaN from there on.
fn alexa(a: DualQuat<f64>, b: DualQuat<f64>, t: f64) -> Matrix<f64, 3, 4> {
    let between = keyframe::interpolate(&keyframe::matrix(a), &keyframe::matrix(b), t);
    from_fn(|i| from_fn(|j| between.as_ref().map_or(f64::NAN, |between| between[(i, j)])))
}
