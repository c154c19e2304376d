//! Vectors on lanes as arrays, mostly of three components, for kernels that users write.
//! Multiplications are fused with additions.

use super::length::Length;
use dq8_simd::{Float, Lanes};

/// Returns a + b.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn add<L: Lanes>(a: [L; 3], b: [L; 3]) -> [L; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Returns a − b.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn sub<L: Lanes>(a: [L; 3], b: [L; 3]) -> [L; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Returns a·s.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn scale<L: Lanes>(a: [L; 3], s: L) -> [L; 3] {
    [a[0] * s, a[1] * s, a[2] * s]
}

/// Returns a·s + b.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn scale_onto<L: Lanes>(a: [L; 3], s: L, b: [L; 3]) -> [L; 3] {
    [a[0].mul_add(s, b[0]), a[1].mul_add(s, b[1]), a[2].mul_add(s, b[2])]
}

/// Returns the scalar product a · b.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn dot<L: Lanes>(a: [L; 3], b: [L; 3]) -> L {
    a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
}

/// Returns the cross product a × b.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn cross<L: Lanes>(a: [L; 3], b: [L; 3]) -> [L; 3] {
    [
        a[2].neg_mul_add(b[1], a[1] * b[2]),
        a[0].neg_mul_add(b[2], a[2] * b[0]),
        a[1].neg_mul_add(b[0], a[0] * b[1]),
    ]
}

/// Returns a × b + c.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn cross_onto<L: Lanes>(a: [L; 3], b: [L; 3], c: [L; 3]) -> [L; 3] {
    [
        a[2].neg_mul_add(b[1], a[1].mul_add(b[2], c[0])),
        a[0].neg_mul_add(b[2], a[2].mul_add(b[0], c[1])),
        a[1].neg_mul_add(b[0], a[0].mul_add(b[1], c[2])),
    ]
}

/// Returns `yes` in the lanes in which the mask is set, and `no` in all other lanes.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn select<L: Lanes, const N: usize>(mask: L::Mask, yes: [L; N], no: [L; N]) -> [L; N] {
    let mut picked = no;
    for (slot, value) in picked.iter_mut().zip(yes) {
        *slot = L::select(mask, value, *slot);
    }
    picked
}

/// Returns the same vector in every lane.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn splat<L: Lanes, const N: usize>(level: L::Level, numbers: [L::Real; N]) -> [L; N] {
    let mut lanes = [L::splat(level, L::Real::default()); N];
    for (lane, number) in lanes.iter_mut().zip(numbers) {
        *lane = L::splat(level, number);
    }
    lanes
}

/// Returns the mask of the lanes in which a value is finite, neither infinite nor NaN.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn is_finite<L: Lanes>(number: L) -> L::Mask {
    let zero = number.constant(0.0);
    (number * zero).eq(zero)
}

/// Returns the mask of the lanes in which all values are finite.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn are_finite<L: Lanes, const N: usize>(numbers: [L; N]) -> L::Mask {
    let zero = numbers[0].constant(0.0);
    // The product 0·c is 0 if c is finite and NaN otherwise, so the sum is 0 only if all values
    // are finite.
    let mut sum = zero;
    for number in numbers {
        sum = number.mul_add(zero, sum);
    }
    sum.eq(zero)
}

/// Returns the difference between 1 and the next larger float of this precision.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn epsilon<L: Lanes>() -> f64 {
    if L::Real::SINGLE { f64::from(f32::EPSILON) } else { f64::EPSILON }
}

/// Returns the part of `vector` that is orthogonal to the unit vector `along`.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn across<L: Lanes>(along: [L; 3], vector: [L; 3]) -> [L; 3] {
    scale_onto(along, -dot(along, vector), vector)
}

/// Returns a unit vector orthogonal to the unit vector `along`: it takes the coordinate axis
/// farthest from `along`, and removes its component along `along`.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn any_across<L: Lanes>(along: [L; 3]) -> [L; 3] {
    let [x, y, z] = [along[0].abs(), along[1].abs(), along[2].abs()];
    let (zero, one) = (x.constant(0.0), x.constant(1.0));
    let is_x = x.le(y) & x.le(z);
    let y_or_z = select(z.lt(y), [zero, zero, one], [zero, one, zero]);
    let across = across(along, select(is_x, [one, zero, zero], y_or_z));
    Length::of(across, one).divide_all(across)
}
