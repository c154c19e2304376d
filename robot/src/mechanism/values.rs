//! The values of joints: their layouts in slices, and the code that loads them into registers with
//! one configuration per lane.

use core::fmt::Debug;
use core::ops::Range;
use dq8::batch::{cos_sin, farthest};
use dq8::storage::{AoSoA, Element, Layout, Tile, same_length, whole_instances};
use dq8::{Scalar, ShapeError};
use dq8_simd::{Block, Lanes, Level, Records, Row};

/// An item of a slice of joint values, or rates, that can be used with poses in the layout `Y`.
/// Three layouts exist. For poses in any layout, values are plain floats `[configuration][value]`,
/// or columns: a slice `[configuration]` for each value. For poses in blocks, values may also be
/// [`Block`](dq8::storage::Block)s of one component, `[configuration block][value]`, with as many
/// lanes as the blocks of poses. The trait is sealed.
///
/// If values are plain and poses are in blocks, the last block may have lanes without a
/// configuration. The poses in these lanes are computed from values that are all zero.
pub trait JointValues<Y: Layout>: Copy + Debug + Send + Sync + sealed::Sealed {
    #[doc(hidden)]
    fn check(
        what: &'static str,
        slice: &[Self],
        count: usize,
        elements: usize,
    ) -> Result<(), ShapeError>;
    /// The number of items of this slice that hold one joint's values for one element of the slice
    /// of poses. It is 1 for blocks beside blocks, and for floats beside plain poses. It is the
    /// number of lanes for floats beside blocks. It is zero for columns, whose items are whole
    /// slices.
    #[doc(hidden)]
    const EACH: usize;
    /// Returns the values of `elements` elements of the slice of poses (configurations or blocks),
    /// from element `first` on, or fewer at the end of the slice. Columns are returned whole,
    /// because each has values for all configurations.
    #[doc(hidden)]
    fn part(slice: &[Self], count: usize, first: usize, elements: usize) -> Part<'_, Self> {
        if Self::EACH == 0 {
            return Part { slice, first };
        }
        let rest = slice.get(first * Self::EACH * count..).unwrap_or_default();
        Part { slice: rest.get(..elements * Self::EACH * count).unwrap_or(rest), first: 0 }
    }
    /// Loads four consecutive values of a group of configurations, from index `first` on, into four
    /// registers with one configuration per lane. A configuration has `count` values; registers
    /// beyond that count are not used.
    #[doc(hidden)]
    fn load<V: Level>(
        level: V,
        slice: &[Self],
        count: usize,
        group: Group,
        first: usize,
    ) -> [Y::Register<V>; 4];
}

impl<A: Row<Real: Scalar>> JointValues<AoSoA<A>> for Block<A, 1> {
    const EACH: usize = 1;

    #[inline]
    fn check(
        what: &'static str,
        slice: &[Self],
        count: usize,
        elements: usize,
    ) -> Result<(), ShapeError> {
        same_length(what, slice.len(), elements * count)
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(
        level: V,
        slice: &[Self],
        count: usize,
        group: Group,
        first: usize,
    ) -> [<AoSoA<A> as Layout>::Register<V>; 4] {
        let mut quad = [Lanes::splat(level, A::Real::default()); 4];
        for (number, index) in quad.iter_mut().zip(first..count) {
            let tile = group.tile::<AoSoA<A>, V>(index, count);
            if let Some([loaded]) = Element::load(level, slice, tile, &[A::Real::default()]) {
                *number = loaded;
            }
        }
        quad
    }
}

/// Implements the trait for plain floats, for poses in any layout. One `impl` for every `Scalar`
/// would overlap with the `impl` for blocks, so `f32` and `f64` each have their own.
macro_rules! plain_values {
    ($($real:ident)*) => {$(
        impl<Y: Layout<Real = $real>> JointValues<Y> for $real {
            const EACH: usize = Y::THINGS;

            #[inline]
            fn check(
                what: &'static str,
                slice: &[Self],
                count: usize,
                elements: usize,
            ) -> Result<(), ShapeError> {
                let configurations = whole_instances(what, count, slice.len())?;
                if count > 0 && configurations.div_ceil(Y::THINGS) == elements {
                    return Ok(());
                }
                same_length(what, slice.len(), elements * Y::THINGS * count)
            }

            #[cfg_attr(not(opt_level_0), inline(always))]
            fn load<V: Level>(
                level: V,
                slice: &[Self],
                count: usize,
                group: Group,
                first: usize,
            ) -> [Y::Register<V>; 4] {
                let start = group.configuration::<Y, V>() * count + first;
                let rows = slice.get(start..).unwrap_or_default();
                // If a configuration has fewer than four values, the remaining registers are read
                // from the next configuration and not used.
                if let Some(quad) = Y::Register::<V>::load_rows(level, rows, count) {
                    return quad;
                }
                let mut quad = [Y::Register::<V>::splat(level, 0.0); 4];
                for (number, index) in quad.iter_mut().zip(0..count - first) {
                    let rows: &[[$real; 1]] = bytemuck::must_cast_slice(rows);
                    if let Some(rows) = rows.get(index..) {
                        [*number] = Records::load_strided(level, rows, Some(count), &[0.0]);
                    }
                }
                quad
            }
        }
    )*};
}
plain_values! { f32 f64 }

impl<Y: Layout> JointValues<Y> for &[Y::Real] {
    const EACH: usize = 0;

    #[inline]
    fn check(
        what: &'static str,
        slice: &[Self],
        count: usize,
        elements: usize,
    ) -> Result<(), ShapeError> {
        same_length(what, slice.len(), count)?;
        let length = slice.first().map_or(elements * Y::THINGS, |column| column.len());
        if length.div_ceil(Y::THINGS) != elements {
            return same_length(what, length, elements * Y::THINGS);
        }
        slice.iter().try_for_each(|column| same_length(what, column.len(), length))
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn load<V: Level>(
        level: V,
        slice: &[Self],
        _: usize,
        group: Group,
        first: usize,
    ) -> [Y::Register<V>; 4] {
        let (at, lanes) = (group.configuration::<Y, V>(), Y::Register::<V>::LANES);
        let columns = slice.get(first..).unwrap_or_default();
        let mut quad = [Y::Register::<V>::splat(level, Y::Real::default()); 4];
        // In the usual case there are four columns with enough rows, and four loads suffice.
        if let Some(four) = columns.first_chunk::<4>()
            && four.iter().all(|column| column.len() >= at + lanes)
        {
            for (number, column) in quad.iter_mut().zip(four) {
                let mut array = number.to_array();
                if let Some(row) = column.get(at..at + lanes) {
                    array.as_mut().copy_from_slice(row);
                }
                *number = Lanes::load(level, &array);
            }
            return quad;
        }
        for (number, column) in quad.iter_mut().zip(columns) {
            let rest = column.get(at..).unwrap_or_default();
            *number = Lanes::load_partial(level, rest, Y::Real::default());
        }
        quad
    }
}

/// The values or rates of a range of configurations.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Part<'s, T> {
    slice: &'s [T],
    /// The index of the first configuration of this part. It is zero unless the values are columns:
    /// each part gets all columns whole, whereas in the other layouts `slice` begins with this
    /// configuration.
    first: usize,
}

/// The values of joints in registers, one configuration per lane.
pub(crate) trait LaneValues<L: Lanes> {
    /// Returns the value with this `index`.
    fn get(&mut self, level: L::Level, index: usize) -> L;
    /// Returns the cosine and the sine of half of the value with this `index`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn half_angle(&mut self, level: L::Level, index: usize) -> [L; 2] {
        let value = self.get(level, index);
        checked_cos_sin(value * value.constant(0.5))
    }
}

/// The index `first` while no values are loaded. It differs from the index of every value by more
/// than four.
const NOWHERE: usize = usize::MAX / 2;

/// The values of a group of configurations. Four consecutive values are loaded at a time, and kept
/// until a value outside of these four is needed. The transpose of plain values yields four values
/// at a time, and the CPU overlaps the computation of four independent cosines.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CachedValues<'s, Y: Layout, T, V: Level> {
    part: Part<'s, T>,
    /// The count of values of a configuration.
    count: usize,
    group: Group,
    /// The index of the first of the four loaded values.
    first: usize,
    quad: [Y::Register<V>; 4],
    /// The cosine and the sine of half of each of the four values; valid if `has_cos_sin`.
    cos_sin: [[Y::Register<V>; 2]; 4],
    has_cos_sin: bool,
}

impl<'s, Y: Layout, T: JointValues<Y>, V: Level> CachedValues<'s, Y, T, V> {
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn new(level: V, part: Part<'s, T>, count: usize) -> Self {
        let zero = Y::Register::<V>::splat(level, Y::Real::default());
        let group = Group { first: 0, register: 0 };
        let (quad, cos_sin) = ([zero; 4], [[zero; 2]; 4]);
        Self { part, count, group, first: NOWHERE, quad, cos_sin, has_cos_sin: false }
    }

    /// Moves on to another group of configurations.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn seek(&mut self, group: Group) {
        (self.group, self.first) = (group, NOWHERE);
        if T::EACH == 0 {
            self.group.first += self.part.first;
        }
    }

    /// Loads the value with this `index` unless it is loaded, and returns its place among the four.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn find(&mut self, level: V, index: usize) -> usize {
        if index.wrapping_sub(self.first) >= 4 {
            self.first = (index & !3).min(self.count.max(4) - 4);
            self.quad = T::load(level, self.part.slice, self.count, self.group, self.first);
            self.has_cos_sin = false;
        }
        index.wrapping_sub(self.first) & 3
    }
}

impl<Y: Layout, T: JointValues<Y>, V: Level> LaneValues<Y::Register<V>>
    for CachedValues<'_, Y, T, V>
{
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn get(&mut self, level: V, index: usize) -> Y::Register<V> {
        let offset = self.find(level, index);
        self.quad[offset]
    }

    #[cfg_attr(not(opt_level_0), inline(always))]
    fn half_angle(&mut self, level: V, index: usize) -> [Y::Register<V>; 2] {
        let offset = self.find(level, index);
        if !self.has_cos_sin {
            for (turn, &number) in self.cos_sin.iter_mut().zip(&self.quad) {
                *turn = checked_cos_sin(number * number.constant(0.5));
            }
            self.has_cos_sin = true;
        }
        self.cos_sin[offset]
    }
}

/// Returns the cosine and the sine of `half`, or NaN if `half` is beyond the range in which lanes
/// compute them.
#[cfg_attr(not(opt_level_0), inline(always))]
pub(crate) fn checked_cos_sin<L: Lanes>(half: L) -> [L; 2] {
    let near = half.abs().le(half.constant(farthest::<L>()));
    let (cos, sin) = cos_sin(L::select(near, half, half.constant(f64::NAN)));
    [cos, sin]
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
    impl<R> Sealed for &[R] {}
    impl<A> Sealed for dq8_simd::Block<A, 1> {}
}

/// The count of bytes of a cache line.
const LINE: usize = 64;

/// The group of configurations that the lanes of a kernel compute at a time.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Group {
    /// The index of the block or, for plain slices, of the configuration in the first lane.
    pub(crate) first: usize,
    pub(crate) register: usize,
}

impl Group {
    /// Returns the place in a slice (a [`Tile`]) of item `index` of each configuration in this
    /// group, where a configuration has `count` items, such as poses of links.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn tile<Y: Layout, V: Level>(self, index: usize, count: usize) -> Tile {
        // In plain slices the same item of the next configuration lies `count` records further on.
        // In blocks it lies in the next lane of the same block.
        let tile = Tile::at(self.first * count + index, self.register);
        if Y::transposes::<V>() { tile.strided(count) } else { tile }
    }

    /// Prefetches the memory to which the next group will write the items `these`, a range of
    /// indices among the `count` items of each configuration. The CPU's own prefetcher does not
    /// follow these writes, because there are as many streams of them as lanes. The prefetch saves
    /// a third of the time if the output does not fit the caches.
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

    /// Returns the index of the configuration in the first lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn configuration<Y: Layout, V: Level>(self) -> usize {
        self.first * Y::THINGS + self.register * Y::Register::<V>::LANES
    }
}
