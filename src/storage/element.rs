use super::sealed::Sealed;
use super::{Layout, Tile};
use core::fmt::Debug;
use dq8_simd::Level;

/// An element of a slice: a thing of `C` numbers, or a block of such things. The one bound that code
/// for any [`Layout`] needs; [the table](super) says what implements it. Sealed.
pub trait Element<const C: usize>: Copy + Debug + Sealed {
    /// How it lies in memory.
    type Layout: Layout;

    /// Each component of the things of a tile, a register each. What lies beyond the end of `from` is
    /// `padding` (see [`identity`](super::identity)); `None` if the tile begins beyond it.
    fn load<V: Level>(
        level: V,
        from: &[Self],
        tile: Tile,
        padding: &[Number<Self, C>; C],
    ) -> Option<[Register<Self, V, C>; C]>;

    /// The things of a tile from each component; what lies beyond the end of `to` is dropped.
    fn store<V: Level>(components: [Register<Self, V, C>; C], to: &mut [Self], tile: Tile);

    /// Thing number `index`.
    #[must_use]
    fn get(slice: &[Self], index: usize) -> Option<[Number<Self, C>; C]>;
    /// Writes thing number `index`; nothing beyond the last.
    fn set(slice: &mut [Self], index: usize, thing: [Number<Self, C>; C]);

    /// [`store`](Self::store)s what `each` makes of every tile, past the caches where the layout
    /// [can](Layout::STREAMS). The first `None` ends.
    #[inline(always)]
    fn stream<V: Level>(
        level: V,
        to: &mut [Self],
        mut each: impl FnMut(Tile) -> Option<[Register<Self, V, C>; C]>,
    ) {
        let _ = level;
        for tile in super::tiles::<Self, V, C>(to.len()) {
            let Some(components) = each(tile) else { return };
            Self::store(components, to, tile);
        }
    }

    /// The same numbers as arrays, if they lie one after the other: for one thing this is faster than
    /// lanes. `None` for blocks.
    #[must_use]
    #[inline(always)]
    fn plain(slice: &[Self]) -> Option<&[[Number<Self, C>; C]]> {
        let _ = slice;
        None
    }
    /// [`plain`](Self::plain), to be written.
    #[must_use]
    #[inline(always)]
    fn plain_mut(slice: &mut [Self]) -> Option<&mut [[Number<Self, C>; C]]> {
        let _ = slice;
        None
    }
}

/// The number that an element is made of.
pub type Number<E, const C: usize> = <<E as Element<C>>::Layout as Layout>::Real;
/// The register that reads one component of an element.
pub type Register<E, V, const C: usize> = <<E as Element<C>>::Layout as Layout>::Register<V>;
