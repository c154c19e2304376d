//! Lines, planes and points together, on lanes: what [`Line`](crate::Line) and [`Plane`](crate::Plane) have for
//! real numbers with errors, with masks.
//!
//! Where the reference returns an error, the mask `failed` holds and every number is NaN. The rules are the
//! same: directions and normals have any length but zero, what is returned has length 1, and two
//! directions whose sine is at most [`parallel_sine`] are parallel.

mod crossing;
mod line;
mod perpendicular;
mod plane;

pub use perpendicular::CommonPerpendicular;

use super::length::Length;
use super::vector;
use dq8_simd::Lanes;

/// Eight units of roundoff: two of each direction, doubled.
#[cfg_attr(not(opt_level_0), inline(always))]
fn parallel_sine<L: Lanes>(one: L) -> L {
    one.constant(4.0 * vector::epsilon::<L>())
}

/// The vector with length 1, the length that it had, and where it has no direction: it is zero, or a
/// component is not finite. The length of finite components may overflow: it still divides them.
#[cfg_attr(not(opt_level_0), inline(always))]
fn unit<L: Lanes>(of: [L; 3]) -> ([L; 3], Length<L>, L::Mask) {
    let length = Length::of(of, of[0].constant(1.0));
    let value = length.value();
    let has_direction = value.constant(0.0).lt(value) & vector::are_finite(of);
    (length.divide_all(of), length, !has_direction)
}

/// The length of a vector.
#[cfg_attr(not(opt_level_0), inline(always))]
fn norm<L: Lanes>(of: [L; 3]) -> L {
    Length::of(of, of[0].constant(1.0)).value()
}

/// The larger of two lengths: what the rounding of a distance is relative to.
#[cfg_attr(not(opt_level_0), inline(always))]
fn size<L: Lanes>(a: [L; 3], b: [L; 3]) -> L {
    let (a, b) = (norm(a), norm(b));
    L::select(b.lt(a), a, b)
}

/// NaN where the mask holds.
#[cfg_attr(not(opt_level_0), inline(always))]
fn without<L: Lanes, const N: usize>(failed: L::Mask, numbers: [L; N]) -> [L; N] {
    let nan = numbers[0].constant(f64::NAN);
    vector::select(failed, [nan; N], numbers)
}
