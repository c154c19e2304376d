//! Formulas and code of Arends, as printed: to be counted, and to show where they break. Not for use.

use crate::HyperDualQuat;
use dq8::{DualQuat, Quat, Real};

/// Degrees that `animate` of the appendix adds to `rotate_angle` in every frame, by which three of his four
/// vectors turn.
pub const ANGLE_STEP: f64 = 1.0;
/// What it adds to `t` of the fourth, the vector of SLERP.
pub const SLERP_STEP: f64 = 0.0175;
/// `q_rotate_angle`, the arc of that SLERP, degrees.
pub const SLERP_ARC: f64 = 90.0;

/// `SLERP` of the appendix, which is told the `angle` instead of finding it: radians between `begin`
/// and `end`.
///
/// It returns `begin` where the two agree in x, y and z within 10⁻⁵, and w is not asked. It divides by
/// sin Ω, which for Ω = π is not zero but the rounding of π.
#[must_use]
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
#[must_use]
pub fn slerp_formula<R: Real>(q1: Quat<R>, q2: Quat<R>, t: R, angle: R) -> Quat<R> {
    let first = q1.scale(((R::ONE - t) * angle).sin() / angle.sin());
    let second = q2.scale((t * angle).sin() / angle.sin());
    first + second
}

/// p′ = qpq* of §3.2 with whole quaternion products.
#[must_use]
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
#[must_use]
pub fn dual_transform<R: Real>(q: DualQuat<R>, p: DualQuat<R>) -> DualQuat<R> {
    q * p * conjugate(q)
}

/// p′ = qpq† of §5.4, the last lines of `hdqtransform`.
#[must_use]
pub fn hyper_transform<R: Real>(q: HyperDualQuat<R>, p: HyperDualQuat<R>) -> HyperDualQuat<R> {
    let turned = |part: Quat<R>| part.conjugate().scale(minus_one());
    let [first, second, mixed] = [q.first, q.second, q.mixed].map(turned);
    q * p * HyperDualQuat::new(q.real.conjugate(), first, second, mixed)
}

/// C(t) = ((1−t) ⊙ A) ⊕ (t ⊙ B) of §2.4 for vectors, element by element: r ⊙ A = e^(r ln A),
/// A ⊕ B = e^(ln A + ln B).
#[must_use]
pub fn keyframe<R: Real>(a: [R; 3], b: [R; 3], t: R) -> [R; 3] {
    let times = |r: R, a: [R; 3]| a.map(|x| (r * x.ln()).exp());
    let (a, b) = (times(R::ONE - t, a), times(t, b));
    core::array::from_fn(|i| (a[i].ln() + b[i].ln()).exp())
}
