//! [`Layout`] and [`Element`], which name each other: a layout has elements of any number of
//! components, and an element has a layout.

use crate::number::Scalar;
use core::fmt::Debug;
use core::marker::PhantomData;
use dq8_simd::{Lanes, Level};

/// The things that a register reads: register `register` of the block `element`; or, where a record
/// is one thing, those at `element`, `element + stride`, `element + 2·stride`, … one in each
/// lane.
#[derive(Clone, Copy, Debug)]
pub struct Tile {
    pub(crate) element: usize,
    pub(crate) register: usize,
    /// `None` is 1, which the compiler can see.
    pub(crate) stride: Option<usize>,
}

impl Tile {
    /// The lanes of one register of the block `element`, or as many records as it reads from there
    /// on.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn at(element: usize, register: usize) -> Self {
        Self { element, register, stride: None }
    }

    /// The same, of plain records that lie `stride` records apart; of blocks, the register alone
    /// counts.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn strided(self, stride: usize) -> Self {
        Self { stride: Some(stride), ..self }
    }
}

/// The filling of lanes without a thing: the motion, rotation or matrix that changes nothing, and
/// zero for vectors and numbers. Computing with it is never slow, as it is with garbage.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn identity<R: Scalar, const C: usize>() -> [R; C] {
    Identity::<R, C>::RECORD
}

/// A constant, so that nothing is built where it is passed on.
struct Identity<R, const C: usize>(PhantomData<R>);

impl<R: Scalar, const C: usize> Identity<R, C> {
    const RECORD: [R; C] = {
        // Ones begin at `one`, with this stride.
        let (mut one, stride) = match C {
            4 | 7 | 8 => (3, C),
            12 | 16 => (0, 5),
            _ => (C, 1),
        };
        let mut record = [R::ZERO; C];
        while one < C {
            record[one] = R::ONE;
            one += stride;
        }
        record
    };
}

/// The form in which things of any number of components lie in memory, and the registers that read
/// them: [`Aos`](super::Aos) or [`AoSoA`](super::AoSoA). Sealed.
///
/// A layout whose numbers in memory are not those in registers, say 16 bits each, would be another
/// implementation; no kernel would change.
pub trait Layout: Copy + Debug + sealed::Sealed {
    /// The number in a register.
    type Real: Scalar;
    /// The element of a slice of which only the number of components is known: `[R; C]`, or a
    /// block.
    type Record<const C: usize>: Element<C, Layout = Self>;
    /// One register of `V`.
    type Register<V: Level>: Lanes<Real = Self::Real, Level = V>;
    /// The number of things in a [`Record`](Self::Record).
    const THINGS: usize;
    /// `true` if kernels over this layout gain from AVX-512.
    const WIDE: bool;
    /// `true` if it can be written past the caches, on targets that may have more memory than
    /// caches.
    const STREAMS: bool;

    /// The number of registers that read one component of a record.
    #[must_use]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn registers<V: Level>() -> usize {
        (Self::THINGS / Self::Register::<V>::LANES).max(1)
    }
    /// The number of records that a register reads.
    #[must_use]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn records<V: Level>() -> usize {
        (Self::Register::<V>::LANES / Self::THINGS).max(1)
    }
    /// `true` if a register reads one thing from each of several records.
    #[must_use]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn transposes<V: Level>() -> bool {
        Self::THINGS == 1 && Self::Register::<V>::LANES > 1
    }
}

/// An element of a slice: a thing of `C` numbers, or a block of such things. The one bound that
/// code for any [`Layout`] needs; [the table](super) says what implements it. Sealed.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to dq8 as a thing of {C} numbers",
    label = "not an element of {C} numbers",
    note = "things of `f32` or `f64`: arrays `[R; {C}]`, dq8's own types, and blocks `dq8::simd::Block<[R; N], {C}>`; \
            `dq8::storage` has the table",
    note = "slices of glam's, nalgebra's and mint's types become slices of dq8's by a cast: `dq8::interop`"
)]
pub trait Element<const C: usize>: Copy + Debug + Send + Sync + sealed::Sealed {
    /// The form in which it lies in memory.
    type Layout: Layout;

    /// Each component of the things of a tile, a register each. What lies beyond the end of `from`
    /// is `padding` (see [`identity`](super::identity)); `None` if the tile begins beyond it.
    fn load<V: Level>(
        level: V,
        from: &[Self],
        tile: Tile,
        padding: &[Number<Self, C>; C],
    ) -> Option<[Register<Self, V, C>; C]>;

    /// The things of a tile from each component; what lies beyond the end of `to` is dropped.
    fn store<V: Level>(components: [Register<Self, V, C>; C], to: &mut [Self], tile: Tile);

    /// [`store`](Self::store) of components that lie in memory as registers hold them.
    #[doc(hidden)]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn copy<V: Level>(
        level: V,
        rows: &[<Register<Self, V, C> as Lanes>::Array],
        to: &mut [Self],
        tile: Tile,
    ) {
        let zero = Number::<Self, C>::default();
        let mut components = [Register::<Self, V, C>::splat(level, zero); C];
        for (component, row) in components.iter_mut().zip(rows) {
            *component = Lanes::load(level, row);
        }
        Self::store(components, to, tile);
    }

    /// Thing number `index`.
    #[must_use]
    fn get(slice: &[Self], index: usize) -> Option<[Number<Self, C>; C]>;
    /// Writes thing number `index`; nothing beyond the last.
    fn set(slice: &mut [Self], index: usize, thing: [Number<Self, C>; C]);

    /// [`store`](Self::store)s what `each` makes of every tile, past the caches where the layout
    /// [can](Layout::STREAMS). The first `None` ends.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn stream<V: Level>(
        level: V,
        to: &mut [Self],
        mut each: impl FnMut(Tile) -> Option<[Register<Self, V, C>; C]>,
    ) {
        let _ = level;
        for tile in tiles::<Self, V, C>(to.len()) {
            let Some(components) = each(tile) else { return };
            Self::store(components, to, tile);
        }
    }

    /// The same numbers as arrays, if they lie one after the other: for one thing this is faster
    /// than lanes. `None` for blocks.
    #[must_use]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn plain(slice: &[Self]) -> Option<&[[Number<Self, C>; C]]> {
        let _ = slice;
        None
    }
    /// [`plain`](Self::plain), to be written.
    #[must_use]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn plain_mut(slice: &mut [Self]) -> Option<&mut [[Number<Self, C>; C]]> {
        let _ = slice;
        None
    }
}

/// The number that an element is made of.
pub type Number<E, const C: usize> = <<E as Element<C>>::Layout as Layout>::Real;
/// The register that reads one component of an element.
pub type Register<E, V, const C: usize> = <<E as Element<C>>::Layout as Layout>::Register<V>;

/// The tiles of a slice of `length` elements, in order: each is a register for each component.
#[cfg_attr(not(opt_level_0), inline(always))]
pub fn tiles<E: Element<C>, V: Level, const C: usize>(length: usize) -> impl Iterator<Item = Tile> {
    Tiles {
        next: Tile::at(0, 0),
        length,
        records: E::Layout::records::<V>(),
        registers: E::Layout::registers::<V>(),
    }
}

struct Tiles {
    next: Tile,
    length: usize,
    records: usize,
    registers: usize,
}

impl Iterator for Tiles {
    type Item = Tile;

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn next(&mut self) -> Option<Tile> {
        let tile = self.next;
        if tile.element >= self.length {
            return None;
        }
        self.next.register += 1;
        if self.next.register == self.registers {
            self.next = Tile::at(tile.element + self.records, 0);
        }
        Some(tile)
    }
}

pub(super) mod sealed {
    pub trait Sealed {}
}
