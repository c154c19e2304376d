//! The analytic functions behind the screw operations, on dual numbers.
//!
//! Half the angle of a motion, Θ, enters only through functions that are even in it. Taken as
//! functions of a *square* they are analytic, also at Θ = 0: no axis, no branch and no division by
//! a vanishing sine. On a dual argument they give value and derivative, f(a) + ε b f′(a) (Jia
//! eq. 10), the second from the derivative of the polynomial.
//!
//! The polynomials and their errors are in `even_coefficients.rs`, found by `scripts/fit_even.py`.

use super::Dual;
use super::even_coefficients as coefficients;
use dq8_simd::{Float, Lanes, Mask};

/// (π/2)², with the margin that the polynomials have.
const ORDINARY: f64 = 2.5;

/// An arc of up to a quarter of the unit circle over its chord, from the squared chord c:
/// arcsin(√c/2)/(√c/2) for c in [0, 2].
#[cfg_attr(not(opt_level_0), inline(always))]
pub fn arc_over_chord<L: Lanes>(c: Dual<L>) -> Dual<L> {
    let (value, derivative) = polynomial(&coefficients::ARC_F32, &coefficients::ARC_F64, c.real);
    c.apply(value, derivative)
}

/// cos √v and sin(√v)/√v for any v ≥ 0.
///
/// The derivatives are −½ sin(√v)/√v and (cos √v − sin(√v)/√v)/(2v); the second
/// cancels for small v and comes from the polynomial there.
#[cfg_attr(not(opt_level_0), inline(always))]
pub fn cos_sinc<L: Lanes>(v: Dual<L>) -> (Dual<L>, Dual<L>) {
    let minus_half = v.real.constant(-0.5);
    let (cos, _) = polynomial(&coefficients::COS_F32, &coefficients::COS_F64, v.real);
    let (sinc, slope) = polynomial(&coefficients::SINC_F32, &coefficients::SINC_F64, v.real);
    // Half angles up to a quarter turn, which is what the shorter way and the logarithm give. One
    // branch per register: only registers with an angle beyond it pay for the reduction.
    let ordinary = v.real.le(v.real.constant(ORDINARY));
    if ordinary.all() {
        return (v.apply(cos, minus_half * sinc), v.apply(sinc, slope));
    }
    let (far_cos, far_sinc, far_slope) = far_cos_sinc(v.real);
    let cos = L::select(ordinary, cos, far_cos);
    let sinc = L::select(ordinary, sinc, far_sinc);
    let slope = L::select(ordinary, slope, far_slope);
    (v.apply(cos, minus_half * sinc), v.apply(sinc, slope))
}

/// (1 − cos √u)/u and (√u − sin √u)/√u³ for any u ≥ 0: the integrals of sin and of 1
/// − cos in the left Jacobian of SE(3).
#[cfg_attr(not(opt_level_0), inline(always))]
pub fn exponential_integrals<L: Lanes>(u: Dual<L>) -> (Dual<L>, Dual<L>) {
    let one = u.real.constant(1.0);
    // 1 − cos x = 2 sin²(x/2): of half the angle, where nothing cancels.
    let (cos, sinc) = cos_sinc(u.scale(one.constant(0.25)));
    let first = sinc.scale(one.constant(0.5)) * sinc;
    let (value, slope) = polynomial(&coefficients::LEFT_F32, &coefficients::LEFT_F64, u.real);
    let second = u.apply(value, slope);
    let ordinary = u.real.le(one.constant(4.0 * ORDINARY));
    if ordinary.all() {
        return (first, second);
    }
    // sin x / x = cos(x/2) · sin(x/2)/(x/2). Far from zero the difference has all its digits.
    let far = (Dual::new(one, one.constant(0.0)) - cos * sinc) / u;
    (first, select(ordinary, second, far))
}

/// (1 − (√u/2) cot(√u/2))/u for any u ≥ 0 but (2π)², (4π)², …, where it is infinite.
#[cfg_attr(not(opt_level_0), inline(always))]
pub fn half_cotangent<L: Lanes>(u: Dual<L>) -> Dual<L> {
    let one = u.real.constant(1.0);
    let (value, slope) = polynomial(&coefficients::INVERSE_F32, &coefficients::INVERSE_F64, u.real);
    let near = u.apply(value, slope);
    let ordinary = u.real.le(one.constant(4.0 * ORDINARY));
    if ordinary.all() {
        return near;
    }
    let (cos, sinc) = cos_sinc(u.scale(one.constant(0.25)));
    let far = (Dual::new(one, one.constant(0.0)) - cos / sinc) / u;
    select(ordinary, near, far)
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn select<L: Lanes>(mask: L::Mask, yes: Dual<L>, no: Dual<L>) -> Dual<L> {
    Dual::new(L::select(mask, yes.real, no.real), L::select(mask, yes.dual, no.dual))
}

/// The largest half angle that has a sine and a cosine, radians: 2¹⁶ (`f32`), 2⁴⁵ (`f64`).
///
/// Beyond it a float is known to no more than 2⁻⁸ radians, and soon not even to a turn; and
/// what π in three parts leaves is no longer within the range of the polynomials, so that
/// rotations would not be unit.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn farthest<L: Lanes>() -> f64 {
    if L::Real::SINGLE { 65_536.0 } else { 35_184_372_088_832.0 }
}

/// cos √v, sin(√v)/√v and the derivative of the latter, for v > (π/2)²; NaN beyond
/// [`farthest`].
///
/// Errors grow with √v as those of √v itself do: a float of size y is only known to y/2²⁴
/// (2⁵³).
#[cfg_attr(not(opt_level_0), inline(always))]
fn far_cos_sinc<L: Lanes>(v: L) -> (L, L, L) {
    let root = v.sqrt();
    let is_near = root.le(v.constant(farthest::<L>()));
    // Larger values become NaN before the reduction, which would turn them into a plausible but
    // meaningless angle.
    let root = L::select(is_near, root, v.constant(f64::NAN));
    let (cos, sin) = cos_sin(root);
    let sinc = sin / root;
    (cos, sinc, (cos - sinc) / (v + v))
}

/// cos x and sin x for |x| up to [`farthest`]; beyond it they are anything.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn cos_sin<L: Lanes>(x: L) -> (L, L) {
    let (turns, rest) = half_turns(x);
    let square = rest * rest;
    let (cos, _) = polynomial(&coefficients::COS_F32, &coefficients::COS_F64, square);
    let (sinc, _) = polynomial(&coefficients::SINC_F32, &coefficients::SINC_F64, square);
    // (−1)ᵏ: k/2 is a whole number or half way between two, so `odd` is 0 or ½, and 1 −
    // 4·odd is the sign. Lanes have no parity of their own, and integers would need another type
    // of vector.
    let half_turns = turns * x.constant(0.5);
    let odd = (half_turns - round(half_turns)).abs();
    let sign = odd.neg_mul_add(x.constant(4.0), x.constant(1.0));
    (sign * cos, sign * rest * sinc)
}

/// The whole number k and the rest r of x = kπ + r, |r| ≤ π/2 but for rounding.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn half_turns<L: Lanes>(x: L) -> (L, L) {
    let turns = round(x * x.constant(core::f64::consts::FRAC_1_PI));
    // π in three parts whose products with a small integer are exact (Cody and Waite 1980).
    let [high, middle, low] = if L::Real::SINGLE {
        [3.140_625, 9.670_257_568_359_375e-4, 6.278_329_573_009_626e-7]
    } else {
        [3.141_592_502_593_994, 1.509_957_883_171_927_3e-7, 1.078_064_491_805_982_8e-14]
    };
    let rest = turns.neg_mul_add(x.constant(high), x);
    let rest = turns.neg_mul_add(x.constant(middle), rest);
    let rest = turns.neg_mul_add(x.constant(low), rest);
    (turns, rest)
}

/// The nearest whole number: adding 1.5·2²³ (2⁵²) leaves no bits for a fraction, and taking
/// it off again is exact. The factor 1.5 keeps negative numbers within the same binade. Right
/// for |x| below 2²² (2⁵¹).
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn round<L: Lanes>(x: L) -> L {
    let shift = x.constant(if L::Real::SINGLE { 12_582_912.0 } else { 6_755_399_441_055_744.0 });
    (x + shift) - shift
}

/// A polynomial, lowest coefficient first, and its derivative, in the precision of the lanes.
#[cfg_attr(not(opt_level_0), inline(always))]
fn polynomial<L: Lanes>(single: &[f32], double: &[f64], x: L) -> (L, L) {
    if L::Real::SINGLE { value_and_slope(single, x) } else { value_and_slope(double, x) }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn value_and_slope<L: Lanes, C: Copy + Into<f64>>(coefficients: &[C], x: L) -> (L, L) {
    let square = x * x;
    (two_chains(coefficients, 0, x, square), two_chains(coefficients, 1, x, square))
}

/// The derivative of this order, 0 or 1.
///
/// Even and odd powers from the third term on are summed in a Horner chain each: one chain of all
/// powers would wait twice as long for its own results. The first two terms, by far the largest,
/// come last and one after the other, as in Horner's scheme, so that nearly all rounding is that of
/// the result.
///
/// For six terms: (((c₃ + c₅x²)x + (c₂ + c₄x²))x + c₁)x + c₀. A chain begins with one
/// of the last two coefficients and takes every second one below it; which of the two ends with
/// c₂ depends on whether the number of terms is even. The derivative has the coefficients (k +
/// 1)cₖ₊₁, computed at compile time after unrolling.
#[cfg_attr(not(opt_level_0), inline(always))]
fn two_chains<L: Lanes, C: Copy + Into<f64>>(
    coefficients: &[C],
    order: usize,
    x: L,
    square: L,
) -> L {
    let terms = coefficients.len() - order;
    let factor = |power: usize| {
        let factor: f64 = coefficients[power + order].into();
        if order == 1 { factor * (power + 1) as f64 } else { factor }
    };
    // Both chains step by x², and neither waits for the other.
    let mut chains = [x.constant(factor(terms - 2)), x.constant(factor(terms - 1))];
    for power in (2..terms - 2).rev() {
        let chain = &mut chains[(terms - power) % 2];
        *chain = chain.mul_add(square, x.constant(factor(power)));
    }
    // The chain that ends with the second power, and the one that ends with the third.
    let [second, third] = if terms.is_multiple_of(2) { chains } else { [chains[1], chains[0]] };
    let rest = third.mul_add(x, second);
    rest.mul_add(x, x.constant(factor(1))).mul_add(x, x.constant(factor(0)))
}
