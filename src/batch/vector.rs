//! Vectors of lanes as plain arrays, most of them of three.

use dq8_simd::Lanes;

#[inline(always)]
pub(crate) fn add<L: Lanes>(a: [L; 3], b: [L; 3]) -> [L; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
pub(crate) fn scale<L: Lanes>(a: [L; 3], s: L) -> [L; 3] {
    [a[0] * s, a[1] * s, a[2] * s]
}

/// a·s + b
#[inline(always)]
pub(crate) fn scale_onto<L: Lanes>(a: [L; 3], s: L, b: [L; 3]) -> [L; 3] {
    [a[0].mul_add(s, b[0]), a[1].mul_add(s, b[1]), a[2].mul_add(s, b[2])]
}

#[inline(always)]
pub(crate) fn dot<L: Lanes>(a: [L; 3], b: [L; 3]) -> L {
    a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
}

#[inline(always)]
pub(crate) fn cross<L: Lanes>(a: [L; 3], b: [L; 3]) -> [L; 3] {
    [
        a[2].neg_mul_add(b[1], a[1] * b[2]),
        a[0].neg_mul_add(b[2], a[2] * b[0]),
        a[1].neg_mul_add(b[0], a[0] * b[1]),
    ]
}

/// a × b + c
#[inline(always)]
pub(crate) fn cross_onto<L: Lanes>(a: [L; 3], b: [L; 3], c: [L; 3]) -> [L; 3] {
    [
        a[2].neg_mul_add(b[1], a[1].mul_add(b[2], c[0])),
        a[0].neg_mul_add(b[2], a[2].mul_add(b[0], c[1])),
        a[1].neg_mul_add(b[0], a[0].mul_add(b[1], c[2])),
    ]
}

#[inline(always)]
pub(crate) fn select<L: Lanes, const N: usize>(mask: L::Mask, yes: [L; N], no: [L; N]) -> [L; N] {
    let mut picked = no;
    for (slot, value) in picked.iter_mut().zip(yes) {
        *slot = L::select(mask, value, *slot);
    }
    picked
}

/// The same numbers in every lane.
#[inline(always)]
pub(crate) fn splat<L: Lanes, const N: usize>(level: L::Level, numbers: [L::Real; N]) -> [L; N] {
    let mut lanes = [L::splat(level, L::Real::default()); N];
    for (lane, number) in lanes.iter_mut().zip(numbers) {
        *lane = L::splat(level, number);
    }
    lanes
}

/// Where a number is neither infinite nor NaN.
#[inline(always)]
pub(crate) fn is_finite<L: Lanes>(number: L) -> L::Mask {
    let zero = number.constant(0.0);
    (number * zero).eq(zero)
}
