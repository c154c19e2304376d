use dq8::storage::{Layout, Tile};
use dq8_simd::{Lanes, Level};

/// The configurations that the lanes of a kernel hold.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Group {
    /// The block, or the configuration in the first lane.
    pub(crate) first: usize,
    pub(crate) register: usize,
}

impl Group {
    /// Number `index` of the `count` things that each configuration has.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn tile<Y: Layout, V: Level>(self, index: usize, count: usize) -> Tile {
        // Plain: the same thing of the next configuration lies `count` records on. Blocks hold one of each per lane.
        let tile = Tile::at(self.first * count + index, self.register);
        if Y::transposes::<V>() { tile.strided(count) } else { tile }
    }

    /// The configuration in the first lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn configuration<Y: Layout, V: Level>(self) -> usize {
        self.first * Y::THINGS + self.register * Y::Register::<V>::LANES
    }
}
