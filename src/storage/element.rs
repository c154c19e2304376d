//! [`Layout`], the form in which things lie in memory, and [`Element`], an element of a slice in
//! such a form. Each trait names the other: [`Element::Layout`] is the layout of an element, and
//! [`Layout::Record`] is the element of a layout for a given number of components.

use crate::number::Scalar;
use core::fmt::Debug;
use core::marker::PhantomData;
use dq8_simd::{Lanes, Level};

/// The place, in a slice, of the things that fill one register, one in each lane. In blocks these
/// are the things of register `register` within the block at index `element`. In plain records
/// these are the records at `element`, `element + stride`, `element + 2·stride` and so on.
#[derive(Clone, Copy, Debug)]
pub struct Tile {
    pub(crate) element: usize,
    pub(crate) register: usize,
    /// The distance between the records of neighbouring lanes, in records. `None` means 1, a
    /// constant that lets the compiler simplify the addresses.
    pub(crate) stride: Option<usize>,
}

impl Tile {
    /// Returns the tile of one register of the block at index `element`, or the tile of adjoining
    /// plain records that begin at index `element`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn at(element: usize, register: usize) -> Self {
        Self { element, register, stride: None }
    }

    /// Returns the tile of plain records that lie `stride` records apart, the first at index
    /// `element`. For blocks the stride has no meaning and is ignored.
    #[cfg_attr(not(opt_level_0), inline(always))]
    #[must_use]
    pub fn strided(self, stride: usize) -> Self {
        Self { stride: Some(stride), ..self }
    }
}

/// Returns the record that fills lanes to which no thing belongs: the identity for motions,
/// rotations and matrices, and zero for vectors and scalars. Arithmetic with these values is never
/// slow, while lanes with arbitrary contents might hold subnormal numbers, which are slow.
#[cfg_attr(not(opt_level_0), inline(always))]
#[must_use]
pub fn identity<R: Scalar, const C: usize>() -> [R; C] {
    Identity::<R, C>::RECORD
}

/// A type that holds the identity as a constant, so that the compiler passes a reference to it
/// instead of building it for each call.
struct Identity<R, const C: usize>(PhantomData<R>);

impl<R: Scalar, const C: usize> Identity<R, C> {
    const RECORD: [R; C] = {
        // The components with the value 1 lie at `one`, `one + stride`, `one + 2·stride`, ….
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
/// them. It is [`Aos`](super::Aos) or [`AoSoA`](super::AoSoA). The trait is sealed.
///
/// A layout that stores components in another type than registers hold, such as 16 bits each, would
/// be a new implementation of this trait; no kernel would have to change.
pub trait Layout: Copy + Debug + sealed::Sealed {
    /// The type of a component in a register.
    type Real: Scalar;
    /// The element type for things of `C` components without a name of their own: `[R; C]`, or a
    /// block.
    type Record<const C: usize>: Element<C, Layout = Self>;
    /// The register of the level `V` that holds one component of several things.
    type Register<V: Level>: Lanes<Real = Self::Real, Level = V>;
    /// The number of things in a [`Record`](Self::Record).
    const THINGS: usize;
    /// `true` if kernels over this layout are quicker with AVX-512 than with AVX2.
    const WIDE: bool;
    /// `true` if outputs in this layout can be written past the caches.
    const STREAMS: bool;

    /// Returns the number of registers that one component of a record fills: for a block, of all
    /// its things.
    #[must_use]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn registers<V: Level>() -> usize {
        (Self::THINGS / Self::Register::<V>::LANES).max(1)
    }
    /// Returns the number of records whose things fill one register, at least 1.
    #[must_use]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn records<V: Level>() -> usize {
        (Self::Register::<V>::LANES / Self::THINGS).max(1)
    }
    /// Returns `true` if a record is one thing, so that a register takes one thing from each of
    /// several records.
    #[must_use]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn transposes<V: Level>() -> bool {
        Self::THINGS == 1 && Self::Register::<V>::LANES > 1
    }
}

/// An element of a slice: a thing of `C` components, or a block of such things. This is the only
/// bound that code for any [`Layout`] needs; [the table](super) lists the types that implement it.
/// The trait is sealed.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known to dq8 as a thing of {C} numbers",
    label = "not an element of {C} numbers",
    note = "things of `f32` or `f64`: arrays `[R; {C}]`, dq8's own types, and blocks `dq8::simd::Block<[R; N], {C}>`; \
            `dq8::storage` has the table",
    note = "slices of glam's, nalgebra's and mint's types become slices of dq8's by a cast: `dq8::interop`"
)]
pub trait Element<const C: usize>: Copy + Debug + Send + Sync + sealed::Sealed {
    /// The layout of this element in memory.
    type Layout: Layout;

    /// Reads the things of a tile, one register for each component. Lanes beyond the end of `from`
    /// hold `padding` (see [`identity`](super::identity)). Returns `None` if the whole tile lies
    /// beyond the end.
    fn load<V: Level>(
        level: V,
        from: &[Self],
        tile: Tile,
        padding: &[Number<Self, C>; C],
    ) -> Option<[Register<Self, V, C>; C]>;

    /// Writes the things of a tile from one register for each component. Lanes beyond the end of
    /// `to` are dropped.
    fn store<V: Level>(components: [Register<Self, V, C>; C], to: &mut [Self], tile: Tile);

    /// Writes the things of a tile as [`store`](Self::store) does, from components in memory:
    /// `rows` has an array of lanes for each component, which is loaded into a register first.
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

    /// Returns the thing at `index`, counted over all things of all elements; `None` beyond the
    /// end.
    #[must_use]
    fn get(slice: &[Self], index: usize) -> Option<[Number<Self, C>; C]>;
    /// Writes the thing at `index`; does nothing beyond the end.
    fn set(slice: &mut [Self], index: usize, thing: [Number<Self, C>; C]);

    /// Calls `each` for every tile and stores the things that it returns, with stores that bypass
    /// the caches if the layout [allows them](Layout::STREAMS). Stops when `each` returns `None`.
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

    /// Returns the slice as arrays of `C` components if the things lie one after the other, and
    /// `None` for blocks. For a single thing such an array is faster than lanes.
    #[must_use]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn plain(slice: &[Self]) -> Option<&[[Number<Self, C>; C]]> {
        let _ = slice;
        None
    }
    /// Returns the mutable slice as arrays, as [`plain`](Self::plain) does.
    #[must_use]
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn plain_mut(slice: &mut [Self]) -> Option<&mut [[Number<Self, C>; C]]> {
        let _ = slice;
        None
    }
}

/// The type of an element's components, such as `f32`.
pub type Number<E, const C: usize> = <<E as Element<C>>::Layout as Layout>::Real;
/// The register of the level `V` that holds one component of an element's things.
pub type Register<E, V, const C: usize> = <<E as Element<C>>::Layout as Layout>::Register<V>;

/// Returns the tiles of a slice of `length` elements in order. The things of a tile fill one
/// register for each component.
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
