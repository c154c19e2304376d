//! Formulas and code of Arends, as printed: to be counted, and to show where they break. Not for
//! use.

use crate::HyperDualQuat;
use crate::matrix;
use dq8::{DualQuat, Quat, Real};
use dq8_fixtures::vector::dot;

/// Degrees that `animate` of the appendix adds to `rotate_angle` in every frame, by which three of
/// his four vectors turn.
pub const ANGLE_STEP: f64 = 1.0;
/// What it adds to `t` of the fourth, the vector of SLERP.
pub const SLERP_STEP: f64 = 0.0175;
/// `q_rotate_angle`, the arc of that SLERP, degrees.
pub const SLERP_ARC: f64 = 90.0;

/// `SLERP` of the appendix, which is told the `angle` instead of finding it: radians between
/// `begin` and `end`.
///
/// It returns `begin` where the two agree in x, y and z within 10⁻⁵, and w is not asked. It
/// divides by sin Ω, which for Ω = π is not zero but the rounding of π.
pub fn slerp<R: Real>(begin: Quat<R>, end: Quat<R>, t: R, angle: R) -> Quat<R> {
    let margin = R::from_f64(0.00001);
    let close = |a: R, b: R| a <= b + margin && a >= b - margin;
    if close(begin.x(), end.x()) && close(begin.y(), end.y()) && close(begin.z(), end.z()) {
        return begin;
    }
    slerp_formula(begin, end, t, angle)
}

/// The formula of §3.3, which §6 finds to lengthen equal quaternions:
/// sin((1−t)Ω)/sin Ω q₁ + sin(Ωt)/sin Ω q₂.
pub fn slerp_formula<R: Real>(q1: Quat<R>, q2: Quat<R>, t: R, angle: R) -> Quat<R> {
    let first = q1.scale(((R::ONE - t) * angle).sin() / angle.sin());
    let second = q2.scale((t * angle).sin() / angle.sin());
    first + second
}

/// p′ = qpq* of §3.2 with whole quaternion products.
pub fn rotate<R: Real>(q: Quat<R>, p: Quat<R>) -> Quat<R> {
    q * p * q.conjugate()
}

/// `Dualquaternion::conjugate` of the appendix: q_r* − εq_d*, by a multiplication with −1.
fn conjugate<R: Real>(q: DualQuat<R>) -> DualQuat<R> {
    DualQuat::new(q.real().conjugate(), q.dual().conjugate().scale(minus_one()))
}

fn minus_one<R: Real>() -> R {
    R::from_f64(-1.0)
}

/// p′ = qpq† of §4.4, the last lines of `dqtransform`.
pub fn dual_transform<R: Real>(q: DualQuat<R>, p: DualQuat<R>) -> DualQuat<R> {
    q * p * conjugate(q)
}

/// p′ = qpq† of §5.4, the last lines of `hdqtransform`.
pub fn hyper_transform<R: Real>(q: HyperDualQuat<R>, p: HyperDualQuat<R>) -> HyperDualQuat<R> {
    let turned = |part: Quat<R>| part.conjugate().scale(minus_one());
    let [first, second, mixed] = [q.first, q.second, q.mixed].map(turned);
    q * p * HyperDualQuat::new(q.real.conjugate(), first, second, mixed)
}

/// C(t) = ((1−t) ⊙ A) ⊕ (t ⊙ B) of §2.4 for vectors, element by element: r ⊙ A = e^(r ln
/// A), A ⊕ B = e^(ln A + ln B).
pub fn keyframe<R: Real>(a: [R; 3], b: [R; 3], t: R) -> [R; 3] {
    let times = |r: R, a: [R; 3]| a.map(|x| (r * x.ln()).exp());
    let (a, b) = (times(R::ONE - t, a), times(t, b));
    core::array::from_fn(|i| (a[i].ln() + b[i].ln()).exp())
}

/// `DEG2RAD` of the appendix, 3.14159/180, times `degrees`.
pub fn radians(degrees: f64) -> f64 {
    degrees * (314_159.0 / 18e6)
}

/// Rx(φ) Ry(θ) Rz(ψ) v of §2.2.
pub fn turned(angles: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = matrix::about_axes(angles);
    matrix::apply(matrix::product(matrix::product(x, y), z), v)
}

/// Refl(v) = 2(v·l)/(l·l) l of §2.7.2.
pub fn reflection_in_a_line(v: [f64; 3], l: [f64; 3]) -> [f64; 3] {
    let along = 2.0 * dot(v, l) / dot(l, l);
    core::array::from_fn(|i| along * l[i])
}

/// (cos, n sin) + ε(0, T/2) of §4.4.
pub fn side_by_side(r: Quat<f64>, t: [f64; 3]) -> DualQuat<f64> {
    DualQuat::new(r, pure(t.map(|c| c / 2.0)))
}

/// (cos, n sin) + ε₁ε₂(0, T/2) of §5.4.
pub fn hyper_side_by_side(r: Quat<f64>, t: [f64; 3]) -> HyperDualQuat<f64> {
    HyperDualQuat { mixed: pure(t).scale(0.5), ..HyperDualQuat::from_rotation(r) }
}

/// ½(p − epe⁻¹) + β ½(p + epe⁻¹): the parts of eq. 8 across and along a unit vector e,
/// with a factor on the one.
pub fn scaled_along(e: [f64; 3], p: [f64; 3], beta: f64) -> [f64; 3] {
    let mirrored = sandwiched(e, p);
    let along = pure(p) + mirrored;
    let across = pure(p) - mirrored;
    (across + along.scale(beta)).scale(0.5).xyz()
}

/// p + (a/2)(p + jpj⁻¹)k, which shears x by y.
pub fn sheared(p: [f64; 3], a: f64) -> Quat<f64> {
    let along = pure(p) + sandwiched([0.0, 1.0, 0.0], p);
    pure(p) + along.scale(0.5 * a) * pure([0.0, 0.0, 1.0])
}

/// (p₀q₀, p₁q₁, p₂q₂) of §5.6.1.
pub fn by_components(p: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|i| p[i] * q[i])
}

/// a × b + c × d of §5.6.1.
pub fn two_cross_products([a, b]: [[f64; 3]; 2], [c, d]: [[f64; 3]; 2]) -> [f64; 3] {
    let cross = |a: [f64; 3], b: [f64; 3], i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    };
    core::array::from_fn(|i| cross(a, b, i) + cross(c, d, i))
}

/// epe⁻¹ of a unit vector e.
fn sandwiched(e: [f64; 3], p: [f64; 3]) -> Quat<f64> {
    pure(e) * pure(p) * pure(e).conjugate()
}

fn pure(v: [f64; 3]) -> Quat<f64> {
    Quat::from_parts(v, 0.0)
}
