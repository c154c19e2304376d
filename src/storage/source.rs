//! [`Source`], the input of kernels, which is a slice or the kernel's own output, and the function
//! that loads motions from a slice.

use super::element::{Element, Register, Tile, identity};
use crate::batch;
use core::ops::Range;
use dq8_simd::Level;

/// The input of a kernel: a slice, or the present contents of the output if the kernel works in
/// place.
#[derive(Clone, Copy, Debug)]
pub enum Source<'s, E> {
    Slice(&'s [E]),
    Output,
}

impl<'s, E> Source<'s, E> {
    /// Returns the slice that the kernel reads: the input slice, or `output` if the kernel works in
    /// place.
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

    /// Returns the part of the input at these indices; `None` if the slice ends before them.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn part(self, elements: Range<usize>) -> Option<Self> {
        Some(match self {
            Self::Slice(slice) => Self::Slice(slice.get(elements)?),
            Self::Output => Self::Output,
        })
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn is_output(&self) -> bool {
        matches!(self, Self::Output)
    }
}

/// Several motions in registers, with one register for each component and one motion in each lane.
pub(crate) type Motions<E, V> = batch::DualQuat<Register<E, V, 8>>;

/// Reads the motions of a tile; lanes beyond the end of `slice` hold the identity.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn motions<E: Element<8>, V: Level>(
    level: V,
    slice: &[E],
    tile: Tile,
) -> Option<Motions<E, V>> {
    Some(batch::DualQuat::from_array(E::load(level, slice, tile, &identity())?))
}
