//! Sine, cosine and tangent, and their inverse functions.
//!
//! Every angle is reduced to an arc of at most an eighth of a turn. Its sine is the arc times a
//! polynomial in the square of the arc. The inverse functions use
//! [`arc_over_chord`](super::even::arc_over_chord), a polynomial in the square of the chord.

use super::Dual;
use super::even::{arc_over_chord, cos_sinc, farthest, round};
use core::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};
use dq8_simd::{Float, Lanes};

impl<L: Lanes> Dual<L> {
    /// Returns sin a + ε b cos a, with a in radians. The result is NaN beyond 2¹⁶ rad (`f32`)
    /// or 2⁴⁵ rad (`f64`).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn sin(self) -> Self {
        let (sin, cos) = sin_cos(self.real);
        self.apply(sin, cos)
    }

    /// Returns cos a − ε b sin a, with a in radians. The result is NaN beyond 2¹⁶ rad (`f32`)
    /// or 2⁴⁵ rad (`f64`).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn cos(self) -> Self {
        let (sin, cos) = sin_cos(self.real);
        self.apply(cos, -sin)
    }

    /// Returns tan a + ε b/cos²a, with a in radians. The result is NaN beyond 2¹⁶ rad (`f32`)
    /// or 2⁴⁵ rad (`f64`).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn tan(self) -> Self {
        let (sin, cos) = sin_cos(self.real);
        let tan = sin / cos;
        self.apply(tan, tan.mul_add(tan, tan.constant(1.0)))
    }

    /// Returns arcsin a + ε b/√(1 − a²), in radians. The result is NaN for |a| > 1, and the
    /// derivative is infinite at ±1.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn asin(self) -> Self {
        self.apply(asin(self.real), self.real.constant(1.0) / cathetus(self.real))
    }

    /// Returns arccos a − ε b/√(1 − a²), in radians. The result is NaN for |a| > 1, and the
    /// derivative is infinite at ±1.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn acos(self) -> Self {
        self.apply(acos(self.real), self.real.constant(-1.0) / cathetus(self.real))
    }

    /// Returns arctan a + ε b/(1 + a²), in radians.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn atan(self) -> Self {
        let one = self.real.constant(1.0);
        self.apply(atan(self.real), one / self.real.mul_add(self.real, one))
    }

    /// Returns the angle of the point (`x`, `self`), in radians. Its dual part is the derivative (x
    /// dy − y dx)/(x² + y²). x and y are first divided by the larger of |x| and |y|, because
    /// their squares might underflow to zero.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn atan2(self, x: Self) -> Self {
        let (up, along) = (self.real.abs(), x.real.abs());
        let largest = L::select(along.lt(up), up, along);
        let (sin, cos) = (self.real / largest, x.real / largest);
        let turned = sin.neg_mul_add(x.dual, cos * self.dual);
        let squared = sin.mul_add(sin, cos * cos);
        Self::new(atan2(self.real, x.real), turned / squared / largest)
    }
}

/// Returns sin x and cos x for x in radians; both are NaN for |x| beyond [`farthest`]. Both keep
/// their relative precision near their zeros (in `f64` up to 2²⁶ quarter turns): whole quarter
/// turns are subtracted from x, so near a zero the result is always the sine of a small remainder.
#[cfg_attr(not(opt_level_0), inline(always))]
fn sin_cos<L: Lanes>(x: L) -> (L, L) {
    let near = x.abs().le(x.constant(farthest::<L>()));
    let x = L::select(near, x, x.constant(f64::NAN));
    let quarters = round(x * x.constant(FRAC_2_PI));
    let rest = without_quarters(x, quarters);
    let (cos, sinc) = cos_sinc(Dual::new(rest * rest, x.constant(0.0)));
    let (sin, cos) = (rest * sinc.real, cos.real);
    // `turns` becomes the fraction of a turn that was subtracted: 0, ¼, ±½ or −¼.
    let turns = quarters * x.constant(0.25);
    let turns = turns - round(turns);
    let (quarter, half) = (x.constant(0.25), x.constant(0.5));
    let is_odd = turns.abs().eq(quarter);
    let is_half = turns.abs().eq(half);
    let (up, across) = (L::select(is_odd, cos, sin), L::select(is_odd, sin, cos));
    let up = L::select(is_half | turns.eq(-quarter), -up, up);
    (up, L::select(is_half | turns.eq(quarter), -across, across))
}

/// Returns x − kπ/2, where π/2 is the sum of five parts. The products of k with all parts but
/// the last are exact (Cody and Waite 1980). The parts have eight bits in `f32`, for k up to
/// 2¹⁶, and 27 bits in `f64`, for k up to 2²⁶. Fewer parts do not suffice, because there is
/// an `f32` that differs from a multiple of a quarter turn by only 2·10⁻⁸.
#[cfg_attr(not(opt_level_0), inline(always))]
fn without_quarters<L: Lanes>(x: L, k: L) -> L {
    let [first, second, third, fourth, fifth] = if L::Real::SINGLE {
        [
            1.570_312_5,
            4.825_592_041_015_625e-4,
            1.266_598_701_477_050_8e-6,
            9.895_302_355_289_46e-10,
            2.563_344_068_257_089_6e-12,
        ]
    } else {
        [
            1.570_796_251_296_997,
            7.549_789_948_768_648e-8,
            6.123_233_932_053_594e-17,
            6.368_317_116_855_041e-25,
            4.665_590_917_179_985e-33,
        ]
    };
    // These two differences have no more bits than a float holds, so they are exact.
    let before = k.neg_mul_add(x.constant(second), k.neg_mul_add(x.constant(first), x));
    // The next difference is exact if the remainder is small. If it is large, the rounding error of
    // the difference is added to the last part.
    let third = x.constant(third);
    let rest = k.neg_mul_add(third, before);
    let added = k.mul_add(third, rest - before);
    // A zero x keeps its sign: k is then +0 and all parts are positive, so every step subtracts +0,
    // and −0 − (+0) is −0.
    k.neg_mul_add(x.constant(fourth), rest) - k.mul_add(x.constant(fifth), added)
}

/// Returns the arcsine of `sine`, which must be in [0, 1/√2].
#[cfg_attr(not(opt_level_0), inline(always))]
fn small_arc<L: Lanes>(sine: L) -> L {
    let chord_squared = sine * sine * sine.constant(4.0);
    sine * arc_over_chord(Dual::new(chord_squared, sine.constant(0.0))).real
}

/// Returns √(1 − x²) as √((1 − x)(1 + x)), which avoids the rounding of x² near 1. The
/// result is NaN for |x| > 1.
#[cfg_attr(not(opt_level_0), inline(always))]
fn cathetus<L: Lanes>(x: L) -> L {
    let one = x.constant(1.0);
    ((one - x) * (one + x)).sqrt()
}

/// Returns arcsin x in radians, or NaN for |x| > 1.
#[cfg_attr(not(opt_level_0), inline(always))]
fn asin<L: Lanes>(x: L) -> L {
    let (sine, cosine) = (x.abs(), cathetus(x));
    let is_small = sine.le(cosine);
    let arc = small_arc(L::select(is_small, sine, cosine));
    L::select(is_small, arc, x.constant(FRAC_PI_2) - arc).copysign(x)
}

/// Returns arccos x in [0, π] radians, or NaN for |x| > 1.
#[cfg_attr(not(opt_level_0), inline(always))]
fn acos<L: Lanes>(x: L) -> L {
    let (cosine, sine) = (x.abs(), cathetus(x));
    let is_across = cosine.le(sine);
    let arc = small_arc(L::select(is_across, cosine, sine));
    let backward = x.lt(x.constant(0.0));
    let across = x.constant(FRAC_PI_2) - arc.copysign(x);
    let along = L::select(backward, x.constant(PI) - arc, arc);
    L::select(is_across, across, along)
}

/// Returns arctan x in radians.
#[cfg_attr(not(opt_level_0), inline(always))]
fn atan<L: Lanes>(x: L) -> L {
    atan2(x, x.constant(1.0))
}

/// Returns the angle of the point (`x`, `y`) in [−π, π] radians. Signs of zeros and infinite
/// coordinates have the effect that IEEE 754 prescribes.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn atan2<L: Lanes>(y: L, x: L) -> L {
    let (up, along) = (y.abs(), x.abs());
    let (zero, one) = (x.constant(0.0), x.constant(1.0));
    let is_steep = along.lt(up);
    let ratio = L::select(is_steep, along, up) / L::select(is_steep, up, along);
    // If both coordinates are zero, or both are infinite, their quotient would be NaN. So the ratio
    // is set to 0 for zeros and to 1 for infinities.
    let equal = L::select(up.eq(zero), zero, one);
    let ratio = L::select(up.eq(along), equal, ratio);
    let arc = small_arc(ratio / ratio.mul_add(ratio, one).sqrt());
    let arc = L::select(is_steep, x.constant(FRAC_PI_2) - arc, arc);
    let is_backward = one.copysign(x).lt(zero);
    L::select(is_backward, x.constant(PI) - arc, arc).copysign(y)
}
