//! The input of kernels: a slice, or what their output still holds; and motions from it.

use super::element::{Element, Register, Tile, identity};
use crate::batch;
use core::ops::Range;
use dq8_simd::Level;

/// The input of a kernel: a slice of its own, or, in place, what its output still holds.
#[derive(Clone, Copy, Debug)]
pub enum Source<'s, E> {
    Slice(&'s [E]),
    Output,
}

impl<'s, E> Source<'s, E> {
    /// The slice to read, of a kernel that writes `output`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn or<'o>(self, output: &'o [E]) -> &'o [E]
    where
        's: 'o,
    {
        match self {
            Self::Slice(slice) => slice,
            Self::Output => output,
        }
    }

    /// The input at these elements; nothing beyond the end of a slice.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn part(self, elements: Range<usize>) -> Self {
        match self {
            Self::Slice(slice) => Self::Slice(slice.get(elements).unwrap_or_default()),
            Self::Output => Self::Output,
        }
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn is_output(&self) -> bool {
        matches!(self, Self::Output)
    }
}

/// The motions of one register.
pub(crate) type Motions<E, V> = batch::DualQuat<Register<E, V, 8>>;

/// The motions of a tile; the identity in lanes beyond the end of `slice`.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn motions<E: Element<8>, V: Level>(
    level: V,
    slice: &[E],
    tile: Tile,
) -> Option<Motions<E, V>> {
    Some(batch::DualQuat::from_array(E::load(level, slice, tile, &identity())?))
}
