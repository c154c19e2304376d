//! The analytic functions behind the screw operations, on dual numbers.
//!
//! The logarithm, exponential and powers of a motion depend on Θ, half its dual angle, only
//! through even functions of Θ. As functions of the *square* Θ² these are analytic, also at Θ
//! = 0. So they need no axis, no branch and no division by a sine that may vanish. For a dual
//! argument a + εb each function returns f(a) + ε b f′(a) (Jia eq. 10), where f′ is the
//! derivative of the polynomial of f.
//!
//! The coefficients of the polynomials, which `scripts/fit_even.py` finds, and their errors are in
//! `even_coefficients.rs`.

use super::Dual;
use super::even_coefficients as coefficients;
use dq8_simd::{Float, Lanes, Mask};

/// The bound of v = Θ² up to which the polynomials of sine and cosine are used: (π/2)² with a
/// margin.
const ORDINARY: f64 = 2.5;

/// Returns the ratio of an arc of the unit circle, of up to a quarter of the circle, to its chord.
/// The argument c is the squared chord, in [0, 2], and the ratio is arcsin(√c/2)/(√c/2).
#[cfg_attr(not(opt_level_0), inline(always))]
pub fn arc_over_chord<L: Lanes>(c: Dual<L>) -> Dual<L> {
    let (value, derivative) = polynomial(&coefficients::ARC_F32, &coefficients::ARC_F64, c.real);
    c.apply(value, derivative)
}

/// Returns cos √v and sin(√v)/√v for any v ≥ 0.
///
/// Their derivatives are −½ sin(√v)/√v and (cos √v − sin(√v)/√v)/(2v). The second
/// formula loses digits by cancellation for small v, so for small v the derivative of the
/// polynomial is used.
#[cfg_attr(not(opt_level_0), inline(always))]
pub fn cos_sinc<L: Lanes>(v: Dual<L>) -> (Dual<L>, Dual<L>) {
    let minus_half = v.real.constant(-0.5);
    let (cos, _) = polynomial(&coefficients::COS_F32, &coefficients::COS_F64, v.real);
    let (sinc, slope) = polynomial(&coefficients::SINC_F32, &coefficients::SINC_F64, v.real);
    // Half angles up to a quarter turn need no reduction, and the logarithm and the shorter way
    // have no larger half angles. The branch is taken for the whole register, so only registers
    // with a larger angle cost the time of the reduction.
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

/// Returns (1 − cos √u)/u and (√u − sin √u)/√u³ for any u ≥ 0. They are the
/// coefficients in the left Jacobian of SE(3), where they arise as integrals of sin and of 1 −
/// cos.
#[cfg_attr(not(opt_level_0), inline(always))]
pub fn exponential_integrals<L: Lanes>(u: Dual<L>) -> (Dual<L>, Dual<L>) {
    let one = u.real.constant(1.0);
    // The sine of half the angle gives 1 − cos x = 2 sin²(x/2) without cancellation.
    let (cos, sinc) = cos_sinc(u.scale(one.constant(0.25)));
    let first = sinc.scale(one.constant(0.5)) * sinc;
    let (value, slope) = polynomial(&coefficients::LEFT_F32, &coefficients::LEFT_F64, u.real);
    let second = u.apply(value, slope);
    let ordinary = u.real.le(one.constant(4.0 * ORDINARY));
    if ordinary.all() {
        return (first, second);
    }
    // The ratio sin x / x is cos(x/2) · sin(x/2)/(x/2). Far from zero, the subtraction of this
    // ratio from 1 loses no digits.
    let far = (Dual::new(one, one.constant(0.0)) - cos * sinc) / u;
    (first, select(ordinary, second, far))
}

/// Returns (1 − (√u/2) cot(√u/2))/u for any u ≥ 0. It is infinite at u = (2π)², (4π)²,
/// and so on.
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

/// Returns the largest half angle in radians for which the functions here compute a sine and a
/// cosine: 2¹⁶ (`f32`) or 2⁴⁵ (`f64`).
///
/// The rounding error of a larger angle is 2⁻⁸ radians or more, and for much larger angles it
/// exceeds a turn. Moreover the remainder after the reduction with π in three parts would leave
/// the range of the polynomials, so rotations would not be unit.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn farthest<L: Lanes>() -> f64 {
    if L::Real::SINGLE { 65_536.0 } else { 35_184_372_088_832.0 }
}

/// Returns cos √v, sin(√v)/√v and the derivative of sin(√v)/√v by v, for v > (π/2)².
/// All three are NaN where √v is beyond [`farthest`].
///
/// The errors grow with √v like the rounding error of √v itself, because a float of size y has
/// a rounding error of up to y/2²⁴ (`f64`: y/2⁵³).
#[cfg_attr(not(opt_level_0), inline(always))]
fn far_cos_sinc<L: Lanes>(v: L) -> (L, L, L) {
    let root = v.sqrt();
    let is_near = root.le(v.constant(farthest::<L>()));
    // Larger values become NaN before the reduction, because it would turn them into angles that
    // look plausible but have no meaning.
    let root = L::select(is_near, root, v.constant(f64::NAN));
    let (cos, sin) = cos_sin(root);
    let sinc = sin / root;
    (cos, sinc, (cos - sinc) / (v + v))
}

/// Returns cos x and sin x for |x| up to [`farthest`]. For larger |x| the results have no meaning.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn cos_sin<L: Lanes>(x: L) -> (L, L) {
    let (turns, rest) = half_turns(x);
    let square = rest * rest;
    let (cos, _) = polynomial(&coefficients::COS_F32, &coefficients::COS_F64, square);
    let (sinc, _) = polynomial(&coefficients::SINC_F32, &coefficients::SINC_F64, square);
    // The sign is (−1)ᵏ, where k = `turns` is an integer. k/2 is an integer for even k and lies
    // half way between two integers for odd k, so `odd` is 0 or ½ and 1 − 4·odd is the sign.
    // Lanes have no test for odd values, because they hold floats, and integers would need another
    // vector type.
    let half_turns = turns * x.constant(0.5);
    let odd = (half_turns - round(half_turns)).abs();
    let sign = odd.neg_mul_add(x.constant(4.0), x.constant(1.0));
    (sign * cos, sign * rest * sinc)
}

/// Returns the integer k and the remainder r of x = kπ + r, with |r| ≤ π/2 up to rounding.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn half_turns<L: Lanes>(x: L) -> (L, L) {
    let turns = round(x * x.constant(core::f64::consts::FRAC_1_PI));
    // π is the sum of three parts. The products of k with the parts are exact for small k (Cody
    // and Waite 1980).
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

/// Returns the nearest integer, for |x| below 2²² (`f64`: 2⁵¹). Adding 1.5·2²³ (`f64`:
/// 1.5·2⁵²) rounds x to an integer, because the sum has no bits for a fraction; subtracting it
/// again is exact. With the factor 1.5 the sum has the same exponent for negative x.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn round<L: Lanes>(x: L) -> L {
    let shift = x.constant(if L::Real::SINGLE { 12_582_912.0 } else { 6_755_399_441_055_744.0 });
    (x + shift) - shift
}

/// Returns the value and the derivative at x of a polynomial. Its coefficients, lowest degree
/// first, are given in both precisions; the element type of the lanes selects one.
#[cfg_attr(not(opt_level_0), inline(always))]
fn polynomial<L: Lanes>(single: &[f32], double: &[f64], x: L) -> (L, L) {
    if L::Real::SINGLE { value_and_slope(single, x) } else { value_and_slope(double, x) }
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn value_and_slope<L: Lanes, C: Copy + Into<f64>>(coefficients: &[C], x: L) -> (L, L) {
    let square = x * x;
    (two_chains(coefficients, 0, x, square), two_chains(coefficients, 1, x, square))
}

/// Returns the polynomial at x (`order` = 0) or its first derivative (`order` = 1); `square` is
/// x².
///
/// From the third term on, the even powers are summed in one Horner chain and the odd powers in
/// another. In a single chain of all powers, the operations would wait twice as long for each
/// other. The first two terms are by far the largest. They are added last, one after the other as
/// in Horner's scheme, so that nearly the only rounding error is that of the result.
///
/// For six terms: (((c₃ + c₅x²)x + (c₂ + c₄x²))x + c₁)x + c₀. Each chain begins with
/// one of the last two coefficients and takes every second coefficient below it. Whether the number
/// of terms is even or odd decides which chain ends with c₂. The derivative has the coefficients
/// (k + 1)cₖ₊₁, which the compiler computes after it has unrolled the loop.
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
    // Each step multiplies a chain by x², and neither chain waits for the other.
    let mut chains = [x.constant(factor(terms - 2)), x.constant(factor(terms - 1))];
    for power in (2..terms - 2).rev() {
        let chain = &mut chains[(terms - power) % 2];
        *chain = chain.mul_add(square, x.constant(factor(power)));
    }
    // One chain ends with the coefficient of x², the other with that of x³.
    let [second, third] = if terms.is_multiple_of(2) { chains } else { [chains[1], chains[0]] };
    let rest = third.mul_add(x, second);
    rest.mul_add(x, x.constant(factor(1))).mul_add(x, x.constant(factor(0)))
}
