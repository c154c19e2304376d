//! The functions eˣ and ln x.
//!
//! Lanes have no integer operations. So a power of two is computed as a product of powers with the
//! exponents 1, 2, 4, 8 and so on, with one comparison for each. The logarithm divides by such
//! powers in the same way. Both are exact.

use super::Dual;
use super::even::round;
use super::length::power_of_two;
use core::f64::consts::{LOG2_E, SQRT_2};
use dq8_simd::{Float, Lanes};

impl<L: Lanes> Dual<L> {
    /// Returns exp(a + εb) = eᵃ + ε b eᵃ.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn exp(self) -> Self {
        let exp = exp(self.real);
        self.apply(exp, exp)
    }

    /// Returns ln(a + εb) = ln a + ε b/a, or NaN for a < 0.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn ln(self) -> Self {
        self.apply(ln(self.real), self.real.constant(1.0) / self.real)
    }
}

/// Returns the exponents of the powers of two that are tried as factors, the largest first. Every
/// exponent of a float is a sum of them.
#[cfg_attr(not(opt_level_0), inline(always))]
fn exponents<L: Lanes>() -> &'static [i64] {
    const ALL: [i64; 10] = [512, 256, 128, 64, 32, 16, 8, 4, 2, 1];
    if L::Real::SINGLE { ALL.split_at(3).1 } else { &ALL }
}

/// Returns ln 2 as the sum of two parts. The first part has so few bits that its products with
/// exponents are exact.
#[cfg_attr(not(opt_level_0), inline(always))]
fn ln_2<L: Lanes>() -> [f64; 2] {
    if L::Real::SINGLE {
        [0.693_359_375, -2.121_944_400_546_905_8e-4]
    } else {
        [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10]
    }
}

/// Returns 2ᵏ for an integer k with |k| < 128 (`f32`) or 1024 (`f64`).
#[cfg_attr(not(opt_level_0), inline(always))]
fn two_to_the<L: Lanes>(k: L) -> L {
    let one = k.constant(1.0);
    let (mut power, mut left) = (one, k.abs());
    for &exponent in exponents::<L>() {
        let step = k.constant(exponent as f64);
        let goes = step.le(left);
        power = L::select(goes, power * k.constant(power_of_two(exponent)), power);
        left = L::select(goes, left - step, left);
    }
    L::select(k.lt(k.constant(0.0)), one / power, power)
}

/// Returns eˣ = 2ᵏeʳ with |r| ≤ ½ ln 2, where eʳ is computed by its power series.
#[cfg_attr(not(opt_level_0), inline(always))]
fn exp<L: Lanes>(x: L) -> L {
    // For x beyond ±`end`, eˣ is infinite or zero in this precision.
    let (end, terms) = if L::Real::SINGLE { (105.0, 8) } else { (746.0, 14) };
    let end = x.constant(end);
    let x = L::select(end.lt(x), end, L::select(x.lt(-end), -end, x));
    let k = round(x * x.constant(LOG2_E));
    let [high, low] = ln_2::<L>();
    let rest = k.neg_mul_add(x.constant(low), k.neg_mul_add(x.constant(high), x));
    // Horner's scheme sums rⁿ/n! from n = `terms` down to n = 0, with r = `rest`.
    let mut factorial = 1.0;
    for n in 2..=terms {
        factorial *= f64::from(n);
    }
    let mut sum = x.constant(1.0 / factorial);
    for n in (1..=terms).rev() {
        factorial /= f64::from(n);
        sum = sum.mul_add(rest, x.constant(1.0 / factorial));
    }
    // The factor 2ᵏ is applied as two factors, because 2ᵏ may be out of range although the
    // result is not.
    let first = round(k * x.constant(0.5));
    sum * two_to_the(first) * two_to_the(k - first)
}

/// Returns ln x = k ln 2 + 2 artanh((m − 1)/(m + 1)) for x = 2ᵏm with m in [1/√2, √2],
/// where artanh is computed by its power series. The result is −∞ for x = 0 and NaN for x < 0.
#[cfg_attr(not(opt_level_0), inline(always))]
fn ln<L: Lanes>(x: L) -> L {
    let (zero, one) = (x.constant(0.0), x.constant(1.0));
    let (mut m, mut k) = (x, zero);
    for &exponent in exponents::<L>() {
        let goes = x.constant(power_of_two(exponent)).le(m);
        m = L::select(goes, m * x.constant(power_of_two(-exponent)), m);
        k = L::select(goes, k + x.constant(exponent as f64), k);
    }
    // The largest exponent is tried twice, because subnormal values reach farther below 1 than
    // finite values reach above 1.
    for exponent in exponents::<L>().iter().take(1).chain(exponents::<L>()).copied() {
        let goes = m.lt(x.constant(power_of_two(1 - exponent)));
        m = L::select(goes, m * x.constant(power_of_two(exponent)), m);
        k = L::select(goes, k - x.constant(exponent as f64), k);
    }
    let halve = x.constant(SQRT_2).lt(m);
    m = L::select(halve, m * x.constant(0.5), m);
    k = L::select(halve, k + one, k);

    let s = (m - one) / (m + one);
    let square = s * s;
    let terms = if L::Real::SINGLE { 5 } else { 11 };
    let mut sum = x.constant(1.0 / f64::from(2 * terms + 1));
    for n in (1..terms).rev() {
        sum = sum.mul_add(square, x.constant(1.0 / f64::from(2 * n + 1)));
    }
    let twice = s + s;
    let rest = (twice * square).mul_add(sum, twice);
    let [high, low] = ln_2::<L>();
    let ln = k.mul_add(x.constant(high), k.mul_add(x.constant(low), rest));
    let ln = L::select(x.eq(zero), zero.constant(f64::NEG_INFINITY), ln);
    let ln = L::select(x.lt(zero), zero.constant(f64::NAN), ln);
    L::select(x.eq(zero.constant(f64::INFINITY)), x, ln)
}
