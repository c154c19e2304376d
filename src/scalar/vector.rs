//! Three-vectors as arrays, and their lengths. Terms are added in the order of the papers, and no
//! multiplication is fused with an addition.

pub use crate::geometry::vector::{add, cross, dot, scale, sub};
use crate::number::Real;

/// Returns the largest of the absolute values, or NaN if a component is NaN.
#[inline]
pub(crate) fn largest<R: Real, const N: usize>(components: [R; N]) -> R {
    components.iter().fold(R::ZERO, |largest, c| c.abs().max_or_nan(largest))
}

/// Returns the Euclidean length of `components`, however large or small they are. The components
/// are first divided by the largest of them, because their squares might overflow or vanish.
#[inline]
#[must_use]
pub fn norm<R: Real, const N: usize>(components: [R; N]) -> R {
    let largest = largest(components);
    if largest == R::ZERO || !largest.is_finite() {
        return largest;
    }
    let mut sum = R::ZERO;
    for c in components {
        let ratio = c / largest;
        sum += ratio * ratio;
    }
    largest * sum.sqrt()
}

/// Returns the factor by which components of the length `norm` are multiplied before their length
/// is measured again, or `None` if that is not needed. Very short vectors need a large factor,
/// because subnormal numbers have lost digits. Vectors of infinite length need the factor ¼,
/// because their length may then be finite.
#[inline]
pub(crate) fn stretch<R: Real>(norm: R) -> Option<R> {
    // The factor is 2¹⁰⁰, because multiplying by a power of two is exact.
    let stretch = R::from(1.267_650_6e30);
    if norm * stretch < R::ONE {
        return Some(stretch);
    }
    (norm == R::ONE / R::ZERO).then_some(R::HALF * R::HALF)
}

/// Returns the unit vector along `components`, whose length `norm` is not zero.
pub(crate) fn direction<R: Real, const N: usize>(components: [R; N], norm: R) -> [R; N] {
    let Some(stretch) = stretch(norm) else { return components.map(|c| c / norm) };
    let stretched = components.map(|c| c * stretch);
    let norm = self::norm(stretched);
    stretched.map(|c| c / norm)
}

/// The length of a vector, stored as `stretched`, which is `stretch` times the length. A very short
/// vector is multiplied by `stretch` before its length is taken, because its length would otherwise
/// have few digits.
#[derive(Clone, Copy)]
pub(crate) struct Length<R> {
    stretch: R,
    stretched: R,
}

impl<R: Real> Length<R> {
    /// Makes the length of components whose norm is `norm`.
    #[inline]
    pub(crate) fn of<const N: usize>(components: [R; N], norm: R) -> Self {
        match stretch(norm) {
            Some(stretch) => {
                Self { stretch, stretched: self::norm(components.map(|c| c * stretch)) }
            }
            None => Self { stretch: R::ONE, stretched: norm },
        }
    }

    /// Divides components by the length. Like [`over_norm`], it multiplies by the reciprocal of the
    /// length.
    #[inline]
    pub(crate) fn divide<const N: usize>(self, numbers: [R; N]) -> [R; N] {
        over_norm(numbers.map(|c| c * self.stretch), self.stretched)
    }
}

/// Returns the part of `vector` at right angles to the unit vector `along`.
#[inline]
pub(crate) fn across<R: Real>(along: [R; 3], vector: [R; 3]) -> [R; 3] {
    sub(vector, scale(along, dot(along, vector)))
}

/// Returns a unit vector at right angles to the unit vector `along`, which is as near as possible
/// to the coordinate axis farthest from `along`.
#[inline]
pub(crate) fn any_across<R: Real>(along: [R; 3]) -> [R; 3] {
    let [x, y, z] = along.map(Real::abs);
    let mut axis = [R::ZERO; 3];
    axis[if x <= y && x <= z { 0 } else { usize::from(y > z) + 1 }] = R::ONE;
    let across = across(along, axis);
    over_norm(across, norm(across))
}

/// Divides every component by `norm`, by multiplying with the reciprocal of `norm`.
///
/// A division by the norm would round in one direction: if the norm is one unit of the last place
/// below 1, it would raise every component by a whole unit, where half a unit would be right. The
/// next normalization corrects |p|, but nothing corrects the length of q. A chain that normalizes
/// at every product would therefore scale its translation by about 10⁻⁹ per product, always in
/// the same direction (measured in `lab/src/products.rs`).
#[inline]
#[must_use]
pub fn over_norm<R: Real, const N: usize>(components: [R; N], norm: R) -> [R; N] {
    // Outside of these bounds the reciprocal of the norm is not a normal number in `f32`.
    let large = R::from(1e30);
    if norm > large || norm * large < R::ONE {
        return components.map(|c| c / norm);
    }
    let reciprocal = R::ONE / norm;
    components.map(|c| c * reciprocal)
}
