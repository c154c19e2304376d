//! [`Length`]: Euclidean lengths whose computation neither overflows nor underflows.

use dq8_simd::{Float, Lanes, Mask};

/// The length of a vector in each lane, and division by it.
///
/// In `f32`, squares overflow for components beyond about 2⁶⁴ and vanish below 2⁻⁶⁴. So
/// if a length in any lane is so large or so small, each vector is first multiplied by a power of
/// two, its *stretch*. The stretch is 1 in lanes whose squares are in range.
#[derive(Clone, Copy)]
pub(super) struct Length<L> {
    /// The length of the vector times its stretch.
    root: L,
    /// The first factor of a division by the length: the reciprocal of `root`, times a power of two
    /// if any lane is stretched.
    first: L,
    /// The second factor of a division by the length, and the stretch; `None` if no lane is
    /// stretched.
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

    /// Returns the vector divided by its length, with the same bits as [`of`](Self::of) and
    /// [`divide_all`](Self::divide_all). The branch for vectors whose squares are in range, and the
    /// branch for the others, which first scales the vector, share the last multiplication. With a
    /// multiplication in each branch, the compiler would compute both products for each component
    /// and select one.
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
        // A component is divided by the length in two multiplications. For short vectors both
        // factors are at least 1, and for long vectors at most 1. So the first product lies between
        // the component and the quotient, and it overflows or vanishes only if the component or the
        // quotient does.
        let balance = power_by_size(small, fits, one, up - half, down + half);
        let first = one / root * balance;
        let second = power_by_size(small, fits, one, half, -half);
        Self { root, first, stretched: Some((second, stretch)) }
    }

    /// Returns the length of the vector, without the stretch.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn value(self) -> L {
        match self.stretched {
            None => self.root,
            Some((_, stretch)) => self.root / stretch,
        }
    }

    /// Returns `component` divided by the length.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn divide(self, component: L) -> L {
        match self.stretched {
            None => component * self.first,
            Some((second, _)) => component * self.first * second,
        }
    }

    /// Returns the vector with every component divided by the length.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn divide_all<const N: usize>(self, vector: [L; N]) -> [L; N] {
        let mut quotients = vector;
        for component in &mut quotients {
            *component = self.divide(*component);
        }
        quotients
    }
}

/// Returns the vector with every component multiplied by a factor.
#[cfg_attr(not(opt_level_0), inline(always))]
fn scaled<L: Lanes, const N: usize>(mut vector: [L; N], factor: L) -> [L; N] {
    for component in &mut vector {
        *component = *component * factor;
    }
    vector
}

/// The squared lengths, if all are within the safe range. Otherwise two masks of lanes: `small` if
/// the squared length is too small, and `fits` if it is not too large.
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

/// Returns three exponents (a, b, c) of two. Lengths from 2⁻ᵃ to 2ᵃ need no stretch. Shorter
/// vectors are multiplied by 2 to the power b, longer vectors by 2 to the power c. Then all squares
/// are within range, and so are the intermediate quotients.
const fn bounds<L: Lanes>() -> (i64, i64, i64) {
    if L::Real::SINGLE { (40, 88, -66) } else { (400, 564, -514) }
}

/// Returns 2 to the power `short` in the lanes that are `small`, 2 to the power `long` in the lanes
/// whose squares do not fit, and 1 in all others.
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

/// Returns 2ⁿ, made from the bits of a float, because `core` has no `powi`.
pub(super) const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) << 52).cast_unsigned())
}
