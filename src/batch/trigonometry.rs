//! Sine, cosine and tangent, and the angles back.
//!
//! All angles are arcs of at most an eighth of a turn, put together: the sine by its polynomial of
//! the square, the arc by that of [`arc_over_chord`](super::even::arc_over_chord).

use super::Dual;
use super::even::{arc_over_chord, cos_sinc, farthest, round};
use core::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};
use dq8_simd::{Float, Lanes};

impl<L: Lanes> Dual<L> {
    /// sin a + ε b cos a, radians; NaN beyond 2¹⁶ rad (`f32`) or 2⁴⁵ rad (`f64`).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn sin(self) -> Self {
        let (sin, cos) = sin_cos(self.real);
        self.apply(sin, cos)
    }

    /// cos a − ε b sin a, radians; NaN beyond 2¹⁶ rad (`f32`) or 2⁴⁵ rad (`f64`).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn cos(self) -> Self {
        let (sin, cos) = sin_cos(self.real);
        self.apply(cos, -sin)
    }

    /// tan a + ε b/cos²a, radians; NaN beyond 2¹⁶ rad (`f32`) or 2⁴⁵ rad (`f64`).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn tan(self) -> Self {
        let (sin, cos) = sin_cos(self.real);
        let tan = sin / cos;
        self.apply(tan, tan.mul_add(tan, tan.constant(1.0)))
    }

    /// arcsin a + ε b/√(1 − a²), radians, |a| ≤ 1, else NaN; the derivative is infinite at
    /// ±1.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn asin(self) -> Self {
        self.apply(asin(self.real), self.real.constant(1.0) / cathetus(self.real))
    }

    /// arccos a − ε b/√(1 − a²), radians, |a| ≤ 1, else NaN; the derivative is infinite
    /// at ±1.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn acos(self) -> Self {
        self.apply(acos(self.real), self.real.constant(-1.0) / cathetus(self.real))
    }

    /// arctan a + ε b/(1 + a²), radians.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn atan(self) -> Self {
        let one = self.real.constant(1.0);
        self.apply(atan(self.real), one / self.real.mul_add(self.real, one))
    }

    /// The angle of the point (`x`, `self`), radians, with the derivative (x dy − y dx)/(x² +
    /// y²), by ratios to the larger of the two: squares might vanish.
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

/// sin x and cos x, radians; NaN beyond [`farthest`]. Both keep their relative precision where they
/// vanish (in `f64` up to 2²⁶ quarter turns): the turns taken off are quarters, so that the one
/// which vanishes is always a sine.
#[cfg_attr(not(opt_level_0), inline(always))]
fn sin_cos<L: Lanes>(x: L) -> (L, L) {
    let near = x.abs().le(x.constant(farthest::<L>()));
    let x = L::select(near, x, x.constant(f64::NAN));
    let quarters = round(x * x.constant(FRAC_2_PI));
    let rest = without_quarters(x, quarters);
    let (cos, sinc) = cos_sinc(Dual::new(rest * rest, x.constant(0.0)));
    let (sin, cos) = (rest * sinc.real, cos.real);
    // Of whole turns: 0, ¼, ±½ or −¼.
    let turns = quarters * x.constant(0.25);
    let turns = turns - round(turns);
    let (quarter, half) = (x.constant(0.25), x.constant(0.5));
    let is_odd = turns.abs().eq(quarter);
    let is_half = turns.abs().eq(half);
    let (up, across) = (L::select(is_odd, cos, sin), L::select(is_odd, sin, cos));
    let up = L::select(is_half | turns.eq(-quarter), -up, up);
    (up, L::select(is_half | turns.eq(quarter), -across, across))
}

/// x − kπ/2, with π/2 in five parts whose products with k are exact, but for the last (Cody and
/// Waite 1980): of eight bits in `f32`, where k is up to 2¹⁶; of 27 in `f64`, exact up to
/// 2²⁶. So many, because the `f32` nearest to a quarter turn is 2·10⁻⁸ away from one.
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
    // All bits of these differences are representable, so they are exact.
    let before = k.neg_mul_add(x.constant(second), k.neg_mul_add(x.constant(first), x));
    // The next difference is exact if little is left. If much is left, its rounding error is added
    // to the last part.
    let third = x.constant(third);
    let rest = k.neg_mul_add(third, before);
    let added = k.mul_add(third, rest - before);
    // Zeros keep their sign, because no part is negative and zero is subtracted.
    k.neg_mul_add(x.constant(fourth), rest) - k.mul_add(x.constant(fifth), added)
}

/// arcsin of a number in [0, 1/√2].
#[cfg_attr(not(opt_level_0), inline(always))]
fn small_arc<L: Lanes>(sine: L) -> L {
    let chord_squared = sine * sine * sine.constant(4.0);
    sine * arc_over_chord(Dual::new(chord_squared, sine.constant(0.0))).real
}

/// √(1 − x²), without the rounding of a square near 1; NaN for |x| > 1.
#[cfg_attr(not(opt_level_0), inline(always))]
fn cathetus<L: Lanes>(x: L) -> L {
    let one = x.constant(1.0);
    ((one - x) * (one + x)).sqrt()
}

/// arcsin x, radians; NaN for |x| > 1.
#[cfg_attr(not(opt_level_0), inline(always))]
fn asin<L: Lanes>(x: L) -> L {
    let (sine, cosine) = (x.abs(), cathetus(x));
    let is_small = sine.le(cosine);
    let arc = small_arc(L::select(is_small, sine, cosine));
    L::select(is_small, arc, x.constant(FRAC_PI_2) - arc).copysign(x)
}

/// arccos x, radians, in [0, π]; NaN for |x| > 1.
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

/// arctan x, radians.
#[cfg_attr(not(opt_level_0), inline(always))]
fn atan<L: Lanes>(x: L) -> L {
    atan2(x, x.constant(1.0))
}

/// The angle of the point (`x`, `y`), radians in [−π, π], signs of zeros and infinite
/// coordinates as in IEEE 754.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn atan2<L: Lanes>(y: L, x: L) -> L {
    let (up, along) = (y.abs(), x.abs());
    let (zero, one) = (x.constant(0.0), x.constant(1.0));
    let is_steep = along.lt(up);
    let ratio = L::select(is_steep, along, up) / L::select(is_steep, up, along);
    // Neither 0/0 nor ∞/∞ is a number.
    let equal = L::select(up.eq(zero), zero, one);
    let ratio = L::select(up.eq(along), equal, ratio);
    let arc = small_arc(ratio / ratio.mul_add(ratio, one).sqrt());
    let arc = L::select(is_steep, x.constant(FRAC_PI_2) - arc, arc);
    let is_backward = one.copysign(x).lt(zero);
    L::select(is_backward, x.constant(PI) - arc, arc).copysign(y)
}
