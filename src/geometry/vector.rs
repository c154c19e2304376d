//! Three-vectors as arrays of floats or of lanes.

use core::ops::{Add, Mul, Sub};

/// Returns a + b.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn add<T: Copy + Add<Output = T>>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Returns a − b.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn sub<T: Copy + Sub<Output = T>>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Returns a·s.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn scale<T: Copy + Mul<Output = T>>(a: [T; 3], s: T) -> [T; 3] {
    [a[0] * s, a[1] * s, a[2] * s]
}

/// Returns the scalar product a · b.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn dot<T>(a: [T; 3], b: [T; 3]) -> T
where
    T: Copy + Add<Output = T> + Mul<Output = T>,
{
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns the cross product a × b.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn cross<T>(a: [T; 3], b: [T; 3]) -> [T; 3]
where
    T: Copy + Sub<Output = T> + Mul<Output = T>,
{
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
