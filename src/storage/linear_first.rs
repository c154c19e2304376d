//! [`LinearFirst`]: a twist whose linear part comes first in memory.

use super::aos::{self, Aos};
use super::element::{Element, Register, sealed};
use super::tile::Tile;
use crate::conversions::conversions;
use crate::geometry::Twist;
use crate::number::Scalar;
use dq8_simd::{Float, Level};

crate::pod::pod! {
    /// A twist in memory as `[vx, vy, vz, ωx, ωy, ωz]`, the order of pinocchio and of many
    /// controllers; `[R; 6]`, [`Twist`] and a [`Block`](super::Block) of six rows have the angular
    /// part first. It may be any element of six numbers: a column of a Jacobian, a velocity, an
    /// acceleration. Six of them are a matrix whose rows and columns have that order: a covariance.
    ///
    /// ```
    /// use dq8::{Twist, storage::LinearFirst};
    /// // A wheel two metres away turns about z.
    /// let spin = Twist { angular: [0.0, 0.0, 1.0], linear: [0.0, -2.0, 0.0] };
    /// assert_eq!(LinearFirst::from(spin), LinearFirst([0.0, -2.0, 0.0, 0.0, 0.0, 1.0]));
    /// assert_eq!(Twist::from(LinearFirst::from(spin)), spin);
    /// ```
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct LinearFirst<R>(pub [R; 6]);
}

/// The two halves, the other first.
#[cfg_attr(not(opt_level_0), inline(always))]
const fn other<T: Copy>([a, b, c, d, e, f]: [T; 6]) -> [T; 6] {
    [d, e, f, a, b, c]
}

conversions! {
    [R: Copy] Twist<R> => LinearFirst<R>: |twist| Self(other(twist.to_array()));
    [R: Copy] LinearFirst<R> => Twist<R>: |twist| Self::from_array(other(twist.0));
}

impl<R> sealed::Sealed for LinearFirst<R> {}
impl<R: Scalar> Element<6> for LinearFirst<R> {
    type Layout = Aos<R>;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(
        level: V,
        from: &[Self],
        tile: Tile,
        padding: &[R; 6],
    ) -> Option<[Register<Self, V, 6>; 6]> {
        let numbers = aos::load(level, bytemuck::must_cast_slice(from), tile, &other(*padding))?;
        Some(other(numbers))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store<V: Level>(components: [<R as Float>::Lanes<V>; 6], to: &mut [Self], tile: Tile) {
        aos::store(other(components), bytemuck::must_cast_slice_mut(to), tile);
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn get(slice: &[Self], index: usize) -> Option<[R; 6]> {
        slice.get(index).map(|twist| other(twist.0))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn set(slice: &mut [Self], index: usize, thing: [R; 6]) {
        if let Some(slot) = slice.get_mut(index) {
            *slot = Self(other(thing));
        }
    }
}

/// The numbers of a 6×6 matrix, the halves of rows and columns changed.
#[cfg_attr(not(opt_level_0), inline(always))]
fn others<T: Copy>(matrix: [T; 36]) -> [T; 36] {
    let mut changed = matrix;
    for row in 0..6 {
        for column in 0..6 {
            changed[6 * ((row + 3) % 6) + (column + 3) % 6] = matrix[6 * row + column];
        }
    }
    changed
}

impl<R: Scalar> Element<36> for [LinearFirst<R>; 6] {
    type Layout = Aos<R>;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(
        level: V,
        from: &[Self],
        tile: Tile,
        padding: &[R; 36],
    ) -> Option<[Register<Self, V, 36>; 36]> {
        let padding = &others(*padding);
        Some(others(aos::load(level, bytemuck::must_cast_slice(from), tile, padding)?))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn store<V: Level>(components: [<R as Float>::Lanes<V>; 36], to: &mut [Self], tile: Tile) {
        aos::store(others(components), bytemuck::must_cast_slice_mut(to), tile);
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn get(slice: &[Self], index: usize) -> Option<[R; 36]> {
        slice.get(index).map(|matrix| others(bytemuck::must_cast(*matrix)))
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn set(slice: &mut [Self], index: usize, thing: [R; 36]) {
        if let Some(slot) = slice.get_mut(index) {
            *slot = bytemuck::must_cast(others(thing));
        }
    }
}
