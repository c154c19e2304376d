//! Screws: parameters, logarithm, exponential, powers and screw interpolation.
//!
//! The logarithm, the powers and the interpolation of a motion depend on Θ, half its dual angle,
//! only through even functions of Θ. As functions of a *square* these are analytic at Θ = 0. The
//! square used here is the squared chord C = 4 sin²(Θ/2). With the ratio of the arc to the chord,
//! K(C) = arcsin(√C/2)/(√C/2) for C in [0, 2],
//!
//! ```text
//! Θ² = C K²      Θ / sin Θ = K / cos(Θ/2)
//! ```
//!
//! All are dual numbers with f(a + εb) = f(a) + ε b f′(a), where one polynomial gives both f
//! and f′ ([`even`](super::even)). So no axis, no branch on the angle and no division by a sine
//! is needed. The usual alternative is slerp with weights from the dual cosine X = ⟨a, b⟩ of
//! the poses a and b. The form here is better in two ways:
//!
//! - **C is not computed from 1 − X.** For poses that almost agree, 1 − X has lost the digits
//!   of the angle. This does no harm to interpolation between the poses, but it ruins extrapolation
//!   (t = 1000 along a tiny screw). `log` and `pow` take C from the vector part, and ScLERP takes C
//!   from the difference b − a, which is exact for such poses.
//! - **ScLERP is centred on the midpoint.** With m = (a+b)/2 and h = (b−a)/2, which are
//!   orthogonal, and τ = 2t − 1, σ(t) = cos(τΘ/2)/cos(Θ/2) m + sin(τΘ/2)/sin(Θ/2) h.
//!   Outside [0, 1] a weighted sum of a and b loses digits by cancellation. This sum of m and h
//!   does not, and its angles are half as large.
//!
//! If v in cos √v is beyond (π/2)², the angle is reduced, but only if some lane needs it; the
//! other lanes keep their bits. Half angles are reduced up to 2¹⁶ rad (`f32`) and 2⁴⁵ rad
//! (`f64`). For larger half angles every component is NaN, because their rounding error is 2⁻⁸
//! rad or more, and the motion would not be unit.

use super::even::{arc_over_chord, cos_sinc};
use super::length::Length;
use super::{Dual, DualQuat, Quat, vector};
use crate::geometry::{DualVector, Line, Screw};
use dq8_simd::Lanes;

impl<L: Lanes> DualQuat<L> {
    /// Returns the screw of unit σ, with an angle in [0, π]. A pure translation has angle 0, its
    /// own direction as axis and moment 0. The identity has the axis (1, 0, 0). The moment is not
    /// finite where |t| divided by the angle overflows.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn to_screw(self) -> Screw<L> {
        let sigma = self.canonical();
        let half = HalfAngle::of(sigma);
        let (w, t) = (sigma.real().w(), sigma.translation());
        let (zero, one) = (w.constant(0.0), w.constant(1.0));
        let sine = Length::of(sigma.real().xyz(), one);
        let angle = (sine.value() + sine.value()) * half.over_sine().real;

        let direction = sine.divide_all(sigma.real().xyz());
        let slide = vector::dot(t, direction);
        // The moment is m = ½ (t × l + (t − d l) cot(θ/2)) (Jia eq. 37).
        let across = vector::scale_onto(direction, -slide, t);
        let twice = vector::cross_onto(t, direction, vector::scale(across, sine.divide(w)));
        let moment = vector::scale(twice, w.constant(0.5));

        let distance = Length::of(t, one);
        let turns = zero.lt(sine.value());
        let moves = zero.lt(distance.value());
        let along = vector::select(moves, distance.divide_all(t), [one, zero, zero]);
        Screw {
            axis: Line {
                direction: vector::select(turns, direction, along),
                moment: vector::select(turns, moment, [zero; 3]),
            },
            angle,
            slide: L::select(turns, slide, distance.value()),
        }
    }

    /// Returns the motion cos(θ̂/2) + sin(θ̂/2)(l + εm) of a screw with the dual angle θ̂,
    /// the direction l and the moment m of its axis. The direction must have length 1.
    ///
    /// The result is NaN where half the angle is beyond 2¹⁶ = 65,536 radians (`f32`; `f64`:
    /// 2⁴⁵), because the rounding error of a larger angle is 2⁻⁸ of a radian or more. The
    /// same limit holds for [`exp`](Self::exp), [`pow`](Self::pow), [`sclerp`](Self::sclerp) and
    /// all operations that call them.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn from_screw(screw: Screw<L>) -> Self {
        let half = screw.angle.constant(0.5);
        let half_angle = Dual::new(screw.angle * half, screw.slide * half);
        let (cos, sinc) = cos_sinc(half_angle * half_angle);
        let axis = DualVector { real: screw.axis.direction, dual: screw.axis.moment };
        Self::from_dual_parts(cos, times_dual(axis, half_angle * sinc))
    }

    /// Returns the logarithm (θ̂/2)(l + εm) of the [canonical](Self::canonical) choice of ±σ,
    /// with the dual angle θ̂ and the axis l + εm of its screw. It is the vector part of σ
    /// times Θ/sin Θ with Θ = θ̂/2.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn log(self) -> DualVector<L> {
        let sigma = self.canonical();
        times_dual(sigma.dual_vector(), HalfAngle::of(sigma).over_sine())
    }

    /// Returns cos ĥ + sin ĥ (l + εm) for the logarithm a + εb = ĥ(l + εm), with ĥ² =
    /// a·a + 2ε a·b. The result is NaN where |a| is beyond 2¹⁶ (`f32`) or 2⁴⁵ (`f64`).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn exp(log: DualVector<L>) -> Self {
        let across = vector::dot(log.real, log.dual);
        let square = Dual::new(vector::dot(log.real, log.real), across + across);
        let (cos, sinc) = cos_sinc(square);
        Self::from_dual_parts(cos, times_dual(log, sinc))
    }

    /// Returns σᵗ of the [canonical](Self::canonical) choice of ±σ; `t` may differ from lane
    /// to lane. The result is NaN where t times half the angle is beyond 2¹⁶ (`f32`) or 2⁴⁵
    /// (`f64`), and where t is beyond 10¹⁹ (`f32`) or 10¹⁵⁴ (`f64`), because t² overflows.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn pow(self, t: L) -> Self {
        let sigma = self.canonical();
        let half = HalfAngle::of(sigma);
        let (cos, sinc) = cos_sinc(half.square().scale(t * t));
        let factor = (half.over_sine() * sinc).scale(t);
        Self::from_dual_parts(cos, times_dual(sigma.dual_vector(), factor))
    }

    /// Returns √σ of the [canonical](Self::canonical) choice of ±σ. Its scalar part is
    /// cos(Θ/2), where Θ is half the dual angle, and its vector part is that of σ divided by 2
    /// cos(Θ/2).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn sqrt(self) -> Self {
        let sigma = self.canonical();
        let cos = HalfAngle::of(sigma).half_cosine;
        let factor = (cos + cos).recip();
        Self::from_dual_parts(cos, times_dual(sigma.dual_vector(), factor))
    }

    /// Returns a(a*b)ᵗ with a = `self` and b = `other`, by the shorter way; `t` may differ from
    /// lane to lane. The result is NaN where t times half the angle is beyond 2¹⁶ (`f32`) or
    /// 2⁴⁵ (`f64`), and where t is beyond 10¹⁹ (`f32`) or 10¹⁵⁴ (`f64`), because t²
    /// overflows. Outside [0, 1] an error of the norm of a or b is multiplied by |2t − 1|, as
    /// long as the turn is less than a radian.
    ///
    /// The formula is slerp written as an angle from the middle of the arc. With m = (a+b)/2 and
    /// h = (b−a)/2, which are orthogonal for unit a and b, and τ = 2t − 1:
    ///
    /// ```text
    /// σ(t) = cos(τΘ/2)/cos(Θ/2) m + sin(τΘ/2)/sin(Θ/2) h
    /// ```
    ///
    /// For poses that almost agree the difference b − a is exact, whereas their cosine has lost
    /// the digits of the difference.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn sclerp(self, other: Self, t: L) -> Self {
        let opposite = self.real().dot(other.real()).lt(t.constant(0.0));
        Arc::between(self, other, opposite).at(t)
    }

    /// Interpolates like [`sclerp`](Self::sclerp), but always from `self` to `other` and never to
    /// −`other`, so the way may be the longer one. The way from σ to −σ has no axis and gives
    /// NaN.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn sclerp_long(self, other: Self, t: L) -> Self {
        let zero = t.constant(0.0);
        let opposite = self.real().dot(other.real()).lt(zero);
        let arc = Arc::between(self, other, opposite);
        let short = arc.at(t);

        // The longer way has half the dual angle π − Θ, if Θ is that of the shorter way. Its m
        // is −h of the shorter way, its h is −m, and its cos(Θ/2) and sin(Θ/2) are those of
        // the shorter way exchanged. `back` is normalized, not multiplied by the reciprocal of its
        // norm: however short h is, its quotient by the norm is a motion, but the reciprocal might
        // be infinite.
        let half_sine = arc.back.norm().scale(t.constant(0.5));
        let right_angle = Dual::new(t.constant(core::f64::consts::FRAC_PI_2), zero);
        let tau = t + t - t.constant(1.0);
        let angle = (right_angle - half_sine * arc.arc_over_chord).scale(tau);
        let (cos, sinc) = cos_sinc(angle * angle);
        let along = -(angle * sinc * arc.half_secant);
        let at_middle = arc.back.normalize().scale_dual(cos);
        let long = arc.sum.scale_dual_onto(along, at_middle);
        Self::from_array(vector::select(opposite, long.to_array(), short.to_array()))
    }
}

impl<L: Lanes> Quat<L> {
    /// Returns Θ/sin Θ, where Θ is half the angle of unit quaternions with w ≥ 0. The identity
    /// gives 1.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn half_angle_over_sine(self) -> L {
        HalfAngle::of(DualQuat::from_rotation(self)).over_sine().real
    }
}

/// Functions of Θ, half the dual angle of a motion with p_w ≥ 0, from which its logarithm and
/// its powers are computed.
pub(super) struct HalfAngle<L> {
    /// The squared chord C = 4 sin²(Θ/2).
    chord_squared: Dual<L>,
    /// The ratio K(C) of the arc to the chord.
    arc_over_chord: Dual<L>,
    /// The cosine cos(Θ/2).
    half_cosine: Dual<L>,
}

impl<L: Lanes> HalfAngle<L> {
    /// Computes C as sin²Θ/cos²(Θ/2) with cos²(Θ/2) = (1 + w)/2, where sin Θ is the length
    /// of the vector part. For small angles, 2(1 − w) would consist of rounding errors, while the
    /// vector part still has its full relative precision.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn of(sigma: DualQuat<L>) -> Self {
        let w = sigma.dual_scalar();
        let half = w.real.constant(0.5);
        let cosine_squared = Dual::new(w.real.mul_add(half, half), w.dual * half);
        let v = sigma.dual_vector();
        let across = vector::dot(v.real, v.dual);
        // Division by an infinite w would make C zero, as if there were no turn. Adding 0·w, which
        // is NaN for an infinite w, makes C NaN.
        let squared = w.real.mul_add(w.real.constant(0.0), vector::dot(v.real, v.real));
        let sine_squared = Dual::new(squared, across + across);
        let chord_squared = sine_squared / cosine_squared;
        Self {
            chord_squared,
            arc_over_chord: arc_over_chord(chord_squared),
            half_cosine: cosine_squared.sqrt(),
        }
    }

    /// Returns Θ/sin Θ = K/cos(Θ/2).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn over_sine(&self) -> Dual<L> {
        self.arc_over_chord / self.half_cosine
    }

    /// Returns Θ² = CK².
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn square(&self) -> Dual<L> {
        self.chord_squared * self.arc_over_chord * self.arc_over_chord
    }
}

/// The shorter arc from a to ±b. It holds 2m and −2h in place of m = (a ± b)/2 and h = (±b −
/// a)/2, because each of these takes only eight fused operations. The weights contain the missing
/// factors ½.
struct Arc<L> {
    /// The sum 2m = a ± b.
    sum: DualQuat<L>,
    /// The difference −2h = a ∓ b.
    back: DualQuat<L>,
    /// The squared chord C = ⟨2h, 2h⟩ = 4 sin²(Θ/2).
    chord_squared: Dual<L>,
    /// The ratio K(C) of the arc to the chord.
    arc_over_chord: Dual<L>,
    /// The weight 1/(2 cos(Θ/2)) of 2m, where 4 cos²(Θ/2) = 4 − C.
    half_secant: Dual<L>,
}

impl<L: Lanes> Arc<L> {
    /// Returns the arc from a to −b in the lanes where `opposite` is set, and to b in all others.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn between(a: DualQuat<L>, b: DualQuat<L>, opposite: L::Mask) -> Self {
        let one = a.real().w().constant(1.0);
        let sign = L::select(opposite, -one, one);
        let (sum, back) = (b.scale_onto(sign, a), b.scale_onto(-sign, a));
        let across = back.real().dot(back.dual());
        let chord_squared = Dual::new(back.real().dot(back.real()), across + across);
        // The function x^(−½) of x = 4 − C has the derivative −½ x^(−3/2) by x. Its
        // derivative by C is the negative of this.
        let secant = one / (one.constant(4.0) - chord_squared.real).sqrt();
        let slope = secant * one.constant(0.5) * (secant * secant);
        let half_secant = chord_squared.apply(secant, slope);
        let arc_over_chord = arc_over_chord(chord_squared);
        Self { sum, back, chord_squared, arc_over_chord, half_secant }
    }

    /// Returns the motion at `t`, which is cos(τΘ/2)/cos(Θ/2) m + τ K sinc(τΘ/2) h with τ =
    /// 2t − 1 and sinc x = sin(x)/x.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn at(&self, t: L) -> DualQuat<L> {
        // The weight of `back`, which is −2h, is −τK/2. The square of this weight times C is
        // (τΘ/2)².
        let weight = self.arc_over_chord.scale(t.constant(0.5) - t);
        // The weight is squared before it is multiplied by C. A subnormal C has lost digits. If t
        // is so large that such a C would give an angle that is not small, the square of the weight
        // overflows and the result is NaN.
        let (cos, sinc) = cos_sinc(self.chord_squared * (weight * weight));
        let middle = self.sum.scale_dual(cos * self.half_secant);
        self.back.scale_dual_onto(weight * sinc, middle)
    }
}

/// Returns (s + εu)(a + εb) for the dual vector s + εu and the dual number a + εb.
#[cfg_attr(not(opt_level_0), inline(always))]
fn times_dual<L: Lanes>(v: DualVector<L>, factor: Dual<L>) -> DualVector<L> {
    DualVector {
        real: vector::scale(v.real, factor.real),
        dual: vector::scale_onto(v.real, factor.dual, vector::scale(v.dual, factor.real)),
    }
}
