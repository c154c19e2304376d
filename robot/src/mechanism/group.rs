use core::ops::Range;
use dq8::storage::{Layout, Tile};
use dq8_simd::{Lanes, Level};

/// Bytes of a line of the caches.
const LINE: usize = 64;

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
        // Plain: the same thing of the next configuration lies `count` records on. Blocks hold one
        // of each per lane.
        let tile = Tile::at(self.first * count + index, self.register);
        if Y::transposes::<V>() { tile.strided(count) } else { tile }
    }

    /// Fetches the part of the next group's things that these of the `count` have among this one's.
    /// They follow in memory, but a step writes to as many places as there are lanes, which the CPU
    /// does not foresee: a third of the time where things do not fit the caches.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn prefetch_next<Y: Layout, V: Level, E>(
        self,
        level: V,
        things: &[E],
        these: Range<usize>,
        count: usize,
    ) {
        if !Y::transposes::<V>() {
            return;
        }
        let records = Y::records::<V>();
        let next = (self.first + records) * count + these.start * records;
        let part = things.iter().skip(next).take(these.len() * records);
        for ahead in part.step_by(LINE / size_of::<E>()) {
            level.prefetch(ahead);
        }
    }

    /// The configuration in the first lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn configuration<Y: Layout, V: Level>(self) -> usize {
        self.first * Y::THINGS + self.register * Y::Register::<V>::LANES
    }
}
