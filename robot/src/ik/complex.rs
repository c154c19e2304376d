//! Angles as complex numbers e^{iθ}, one in each lane: turns are products, and only answers need
//! an arctangent.

use dq8::batch::{atan2, vector};
use dq8_simd::{Float, Lanes};

/// An angle, or a point in a plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Complex<L> {
    pub(super) re: L,
    pub(super) im: L,
}

impl<L: Lanes> Complex<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn splat(level: L::Level, [re, im]: [L::Real; 2]) -> Self {
        Self { re: L::splat(level, re), im: L::splat(level, im) }
    }

    /// The angle of a point; NaN at zero.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn unit(re: L, im: L) -> Self {
        let over = re.constant(1.0) / re.mul_add(re, im * im).sqrt();
        Self { re: re * over, im: im * over }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn norm(self) -> L {
        self.re.mul_add(self.re, self.im * self.im).sqrt()
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn times(self, other: Self) -> Self {
        Self {
            re: self.im.neg_mul_add(other.im, self.re * other.re),
            im: self.im.mul_add(other.re, self.re * other.im),
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn plus(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn conj(self) -> Self {
        Self { re: self.re, im: -self.im }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn select(mask: L::Mask, yes: Self, no: Self) -> Self {
        Self { re: L::select(mask, yes.re, no.re), im: L::select(mask, yes.im, no.im) }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn angle(self) -> L {
        atan2(self.im, self.re)
    }

    /// The vector turned about a unit axis (Rodrigues).
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn about(self, axis: [L; 3], v: [L; 3]) -> [L; 3] {
        let along = (v[0].constant(1.0) - self.re) * vector::dot(axis, v);
        let turned = vector::scale_onto(vector::cross(axis, v), self.im, vector::scale(v, self.re));
        vector::scale_onto(axis, along, turned)
    }

    /// The turn about a unit axis that brings `v` onto `w`, or as near as it can; NaN where one of
    /// them is along the axis.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn onto(axis: [L; 3], v: [L; 3], w: [L; 3]) -> Self {
        // Only what is across the axis counts. Where that is little, products of the whole vectors
        // would have lost it.
        let (v, w) = (vector::cross(axis, v), vector::cross(axis, w));
        Self::unit(vector::dot(v, w), vector::dot(axis, vector::cross(v, w)))
    }
}

/// The two solutions of an equation in one angle, or the first where they are one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fork<L: Lanes> {
    pub(super) turns: [Complex<L>; 2],
    pub(super) exists: [L::Mask; 2],
    /// Whether they are one, or hardly apart.
    pub(super) is_singular: L::Mask,
    /// By how much an angle is off, for a unit of roundoff of what it is computed from: much where
    /// the two meet.
    pub(super) blur: L,
}

impl<L: Lanes> Fork<L> {
    /// The angles of base·(re ± i·im), all of any length. An im that is less than `part` of the
    /// whole, both squared, is hardly any. The roundoff of `re` is that of numbers as large as
    /// `size`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(
        base: Complex<L>,
        [re, im]: [L; 2],
        exists: L::Mask,
        is_double: L::Mask,
        [part, size]: [L; 2],
    ) -> Self {
        let way = Complex { re, im };
        let [one, other] = [base.times(way), base.times(way.conj())];
        let turns = [Complex::unit(one.re, one.im), Complex::unit(other.re, other.im)];
        let square = im * im;
        let is_singular = is_double | square.le(part * re.mul_add(re, square));
        // Where they meet, the angle is the root of a roundoff.
        let least = size * size.constant(root_of_epsilon::<L>());
        let blur = size / L::select(im.lt(least), least, im);
        Self { turns, exists: [exists, exists & !is_double], is_singular, blur }
    }
}

/// The root of the distance from 1 to the next larger number, rounded up to a power of two.
fn root_of_epsilon<L: Lanes>() -> f64 {
    if L::Real::SINGLE { 1.0 / 2048.0 } else { 1.0 / 67_108_864.0 }
}

/// The angle between two unit vectors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Apart<L: Lanes> {
    cosine: L,
    sine: L,
    square: L,
    slack: [L; 2],
    pub(super) is_along: L::Mask,
}

impl<L: Lanes> Apart<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn new(v: [L; 3], w: [L; 3], slack: [L; 2]) -> Self {
        let across = vector::cross(v, w);
        let square = vector::dot(across, across);
        let sine = square.sqrt();
        Self { cosine: vector::dot(v, w), sine, square, slack, is_along: sine.le(slack[0]) }
    }

    /// Turns about `axis` that bring `v` as far from `to`. All are unit vectors.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn bend(&self, to: [L; 3], axis: [L; 3], v: [L; 3]) -> Fork<L> {
        let Self { cosine, sine, square, slack: [slack, part], .. } = *self;
        let (one, other) = (vector::dot(to, axis), vector::dot(axis, v));
        let both = one * other;
        let base =
            Complex { re: vector::dot(to, v) - both, im: vector::dot(to, vector::cross(axis, v)) };
        // 1 − cos² − a² − b² + 2ab cos for the cosines a and b to the axis, without its
        // rounding where the sine is small and they are alike.
        let is_back = cosine.lt(sine.constant(0.0));
        let (away, other) = (both + both, L::select(is_back, -other, other));
        let away = L::select(is_back, -away, away) * square / (sine.constant(1.0) + cosine.abs());
        let differ = one - other;
        let left = differ.neg_mul_add(differ, square) - away;
        let least = L::select(sine.lt(slack), slack, sine) * slack;
        // Of axes along each other, the root of a rounding.
        let root = L::select(self.is_along, sine.constant(0.0), positive(left).sqrt());
        let parts = [cosine - both, root];
        Fork::new(base, parts, (-least).le(left), left.le(least), [part, sine.constant(1.0)])
    }
}

/// Zero below it.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(super) fn positive<L: Lanes>(number: L) -> L {
    let zero = number.constant(0.0);
    L::select(number.lt(zero), zero, number)
}
