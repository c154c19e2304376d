//! [`LinearFirst`]: a twist whose linear part comes first in memory.

use super::aos::{self, Aos};
use super::element::{Element, Register, sealed};
use super::tile::Tile;
use crate::conversions::conversions;
use crate::geometry::Twist;
use crate::number::Scalar;
use dq8_simd::{Float, Level};

crate::plain::plain! {
    /// A twist in memory as `[vx, vy, vz, ωx, ωy, ωz]`, the order of pinocchio and of many controllers; `[R; 6]`,
    /// [`Twist`] and a [`Block`](super::Block) of six rows have the angular part first. It may be any element of six
    /// numbers: a column of a Jacobian, a velocity, an acceleration.
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
