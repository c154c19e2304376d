use crate::storage::{Layout, Tile};
use dq8_simd::{Lanes, Level};

/// The configurations that the lanes of a kernel hold.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Group {
    /// The block, or the configuration in the first lane.
    pub(super) first: usize,
    pub(super) register: usize,
}

impl Group {
    /// Number `index` of the `count` things that each configuration has.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn tile<Y: Layout, V: Level>(self, index: usize, count: usize) -> Tile {
        // Plain: the same thing of the next configuration lies `count` records on. Blocks hold one of each per lane.
        let stride = if Y::transposes::<V>() { Some(count) } else { None };
        Tile { element: self.first * count + index, register: self.register, stride }
    }

    /// The configuration in the first lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(super) fn configuration<Y: Layout, V: Level>(self) -> usize {
        self.first * Y::THINGS + self.register * Y::Register::<V>::LANES
    }
}
