//! [`Length`]: Euclidean lengths that neither overflow nor vanish on the way.

use dq8_simd::{Float, Lane, Mask};

/// The length of a vector in each lane, and division by it.
///
/// Squares overflow for components beyond about 2⁶⁴ (`f32`) and vanish below 2⁻⁶⁴, so where any
/// lane is out of the ordinary, all are stretched by a power of two, which is 1 for ordinary lanes.
#[derive(Clone, Copy)]
pub(super) struct Length<L> {
    /// The length of the stretched vector, and its reciprocal.
    root: L,
    recip: L,
    /// Square root of the stretch, so that it can be applied in two steps that do not overflow.
    half_stretch: Option<L>,
}

impl<L: Lane> Length<L> {
    #[inline(always)]
    pub(super) fn of<const N: usize>(vector: [L; N], one: L) -> Self {
        let squared = sum_of_squares(vector, one);
        let (limit, half_stretch) = if L::Real::SINGLE {
            (power_of_two(80), power_of_two(48))
        } else {
            (power_of_two(800), power_of_two(350))
        };
        let small = squared.lt(one.with(1.0 / limit));
        let fits = squared.le(one.with(limit));
        if (fits & !small).all() {
            let root = squared.sqrt();
            return Self { root, recip: one / root, half_stretch: None };
        }
        let stretch = L::select(
            small,
            one.with(half_stretch),
            L::select(fits, one, one.with(1.0 / half_stretch)),
        );
        let mut stretched = vector;
        for component in &mut stretched {
            *component = *component * stretch * stretch;
        }
        let root = sum_of_squares(stretched, one).sqrt();
        Self { root, recip: one / root, half_stretch: Some(stretch) }
    }

    /// The length itself.
    #[inline(always)]
    pub(super) fn value(self) -> L {
        match self.half_stretch {
            None => self.root,
            Some(stretch) => self.root / stretch / stretch,
        }
    }

    /// `component` divided by the length.
    #[inline(always)]
    pub(super) fn divide(self, component: L) -> L {
        match self.half_stretch {
            None => component * self.recip,
            Some(stretch) => component * stretch * self.recip * stretch,
        }
    }

    /// Every component divided by the length.
    #[inline(always)]
    pub(super) fn divide_all<const N: usize>(self, vector: [L; N]) -> [L; N] {
        let mut quotients = vector;
        for component in &mut quotients {
            *component = self.divide(*component);
        }
        quotients
    }
}

#[inline(always)]
fn sum_of_squares<L: Lane, const N: usize>(vector: [L; N], one: L) -> L {
    let mut sum = one.with(0.0);
    for component in vector {
        sum = component.mul_add(component, sum);
    }
    sum
}

/// 2ⁿ, written as the bits of a float: `core` has no `powi`.
const fn power_of_two(exponent: u64) -> f64 {
    f64::from_bits((1023 + exponent) << 52)
}
