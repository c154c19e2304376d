//! [`Length`]: Euclidean lengths that neither overflow nor vanish on the way.

use dq8_simd::{Float, Lanes, Mask};

/// The length of a vector in each lane, and division by it.
///
/// Squares overflow for components beyond about 2⁶⁴ (`f32`) and vanish below 2⁻⁶⁴, so
/// where any lane is out of the ordinary, all are stretched by a power of two, which is 1 for
/// ordinary lanes.
#[derive(Clone, Copy)]
pub(super) struct Length<L> {
    /// The length of the vector after stretching.
    root: L,
    /// The reciprocal of `root`; if any lane is stretched, multiplied by a power of two.
    first: L,
    /// The remaining factor and the stretch, if any lane is stretched.
    stretched: Option<(L, L)>,
}

impl<L: Lanes> Length<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn of<const N: usize>(vector: [L; N], one: L) -> Self {
        match Squared::of(vector, one) {
            Squared::Fits(squared) => {
                let root = squared.sqrt();
                Self { root, first: one / root, stretched: None }
            }
            Squared::Beyond { small, fits } => Self::stretched(vector, small, fits, one),
        }
    }

    /// The vector divided by its length: as [`of`](Self::of) and [`divide_all`](Self::divide_all)
    /// have it, but both ways meet before the last product. Where they meet after it, the compiler
    /// computes both for each component, and selects.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn unit<const N: usize>(vector: [L; N], one: L) -> [L; N] {
        let (vector, factor) = match Squared::of(vector, one) {
            Squared::Fits(squared) => (vector, one / squared.sqrt()),
            Squared::Beyond { small, fits } => {
                let length = Self::stretched(vector, small, fits, one);
                (scaled(vector, length.first), length.stretched.map_or(one, |(second, _)| second))
            }
        };
        scaled(vector, factor)
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn stretched<const N: usize>(vector: [L; N], small: L::Mask, fits: L::Mask, one: L) -> Self {
        let (half, up, down) = bounds::<L>();
        let stretch = power_by_size(small, fits, one, up, down);
        let root = sum_of_squares(scaled(vector, stretch), one).sqrt();
        // The stretch times the reciprocal in two factors: short vectors are divided by two that
        // are no less than 1, long ones by two that are no greater, so nothing on the way is beyond
        // both ends of the quotient.
        let balance = power_by_size(small, fits, one, up - half, down + half);
        let first = one / root * balance;
        let second = power_by_size(small, fits, one, half, -half);
        Self { root, first, stretched: Some((second, stretch)) }
    }

    /// The length itself.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn value(self) -> L {
        match self.stretched {
            None => self.root,
            Some((_, stretch)) => self.root / stretch,
        }
    }

    /// `component` divided by the length.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn divide(self, component: L) -> L {
        match self.stretched {
            None => component * self.first,
            Some((second, _)) => component * self.first * second,
        }
    }

    /// Every component divided by the length.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn divide_all<const N: usize>(self, vector: [L; N]) -> [L; N] {
        let mut quotients = vector;
        for component in &mut quotients {
            *component = self.divide(*component);
        }
        quotients
    }
}

/// Every component times a factor.
#[cfg_attr(not(opt_level_0), inline(always))]
fn scaled<L: Lanes, const N: usize>(mut vector: [L; N], factor: L) -> [L; N] {
    for component in &mut vector {
        *component = *component * factor;
    }
    vector
}

/// The squared lengths, or where they are `small` and where they fit.
enum Squared<L: Lanes> {
    Fits(L),
    Beyond { small: L::Mask, fits: L::Mask },
}

impl<L: Lanes> Squared<L> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn of<const N: usize>(vector: [L; N], one: L) -> Self {
        let squared = sum_of_squares(vector, one);
        let limit = power_of_two(2 * bounds::<L>().0);
        let small = squared.lt(one.constant(1.0 / limit));
        let fits = squared.le(one.constant(limit));
        if (fits & !small).all() { Self::Fits(squared) } else { Self::Beyond { small, fits } }
    }
}

/// Three exponents of two: the greatest of ordinary lengths, and the two by which short and long
/// vectors are stretched. Then the squares of all numbers fit, and so do the quotients on the way.
const fn bounds<L: Lanes>() -> (i64, i64, i64) {
    if L::Real::SINGLE { (40, 88, -66) } else { (400, 564, -514) }
}

/// 2 to one power where a vector is `small`, to another where its squares do not fit, and 1
/// elsewhere.
#[cfg_attr(not(opt_level_0), inline(always))]
fn power_by_size<L: Lanes>(small: L::Mask, fits: L::Mask, one: L, short: i64, long: i64) -> L {
    let long = L::select(fits, one, one.constant(power_of_two(long)));
    L::select(small, one.constant(power_of_two(short)), long)
}

#[cfg_attr(not(opt_level_0), inline(always))]
fn sum_of_squares<L: Lanes, const N: usize>(vector: [L; N], one: L) -> L {
    let mut sum = one.constant(0.0);
    for component in vector {
        sum = component.mul_add(component, sum);
    }
    sum
}

/// 2ⁿ, written as the bits of a float: `core` has no `powi`.
pub(super) const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) << 52).cast_unsigned())
}
