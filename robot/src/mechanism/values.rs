//! The values of joints, from memory to lanes.

use core::fmt::Debug;
use core::ops::Range;
use dq8::batch::{cos_sin, farthest};
use dq8::storage::{AoSoA, Element, Layout, Tile, same_length, whole_instances};
use dq8::{Scalar, ShapeError};
use dq8_simd::{Block, Lanes, Level, Records, Row};

/// Joint values, or rates, for poses in the layout `Y`: plain numbers, `[configuration][value]` or
/// in columns, `[value]` slices of `[configuration]`, for any; or [`Block`](dq8::storage::Block)s
/// of one number, `[configuration block][value]` for blocks of as many lanes. Sealed.
///
/// Where plain values meet poses in blocks, the last block may have lanes without a configuration.
/// The poses there are those of values that are all zero.
pub trait JointValues<Y: Layout>: Copy + Debug + Send + Sync + sealed::Sealed {
    #[doc(hidden)]
    fn check(
        what: &'static str,
        slice: &[Self],
        count: usize,
        elements: usize,
    ) -> Result<(), ShapeError>;
    /// The number of items, blocks or plain numbers, that belong to one element of poses for each
    /// value. Zero for columns, in which configurations do not follow each other.
    #[doc(hidden)]
    const EACH: usize;
    /// The values of `elements` configurations, or blocks of them, from `first` on; fewer at the
    /// end. Columns are not cut.
    #[doc(hidden)]
    fn part(slice: &[Self], count: usize, first: usize, elements: usize) -> Part<'_, Self> {
        if Self::EACH == 0 {
            return Part { slice, first };
        }
        let rest = slice.get(first * Self::EACH * count..).unwrap_or_default();
        Part { slice: rest.get(..elements * Self::EACH * count).unwrap_or(rest), first: 0 }
    }
    /// Four values from number `first` on, one configuration per lane. Those beyond `count` are not
    /// used.
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

/// Plain numbers, for poses in any layout. One `impl` for every `Scalar` would overlap with that
/// for blocks, so each type of number has its own.
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
                // If a configuration has fewer than four, the rest is read from the next one and
                // not used.
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
        // The usual case is four loads, one after the other.
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

/// Values or rates of some configurations.
#[derive(Clone, Copy, Debug)]
#[doc(hidden)]
pub struct Part<'s, T> {
    slice: &'s [T],
    /// The first configuration, for columns, which hold those of others too.
    first: usize,
}

/// The values of one configuration in each lane.
pub(crate) trait LaneValues<L: Lanes> {
    /// Value number `index`.
    fn get(&mut self, level: L::Level, index: usize) -> L;
    /// Cosine and sine of half of value number `index`.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn half_angle(&mut self, level: L::Level, index: usize) -> [L; 2] {
        let value = self.get(level, index);
        checked_cos_sin(value * value.constant(0.5))
    }
}

/// The first of no values: its distance to any number is more than four.
const NOWHERE: usize = usize::MAX / 2;

/// The values of a group, loaded four at a time and kept until others are asked for. Plain values
/// are transposed four at a time, and four cosines do not wait for each other.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CachedValues<'s, Y: Layout, T, V: Level> {
    part: Part<'s, T>,
    /// The number of values of a configuration.
    count: usize,
    group: Group,
    /// The first of the four that are loaded.
    first: usize,
    quad: [Y::Register<V>; 4],
    /// Cosine and sine of half of each of the four, if `has_cos_sin`.
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

    /// Goes on to another group.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn seek(&mut self, group: Group) {
        (self.group, self.first) = (group, NOWHERE);
        if T::EACH == 0 {
            self.group.first += self.part.first;
        }
    }

    /// Loads value number `index` if need be, and gives its place among the four.
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

/// Cosine and sine, or NaN for an angle that is out of the range of the lanes.
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

/// Bytes of a cache line.
const LINE: usize = 64;

/// The configurations that the lanes of a kernel hold at a time.
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
        // In plain slices the same thing of the next configuration lies `count` records on. A block
        // holds it in the next lane.
        let tile = Tile::at(self.first * count + index, self.register);
        if Y::transposes::<V>() { tile.strided(count) } else { tile }
    }

    /// Fetches the memory in which the next group will write `these` of its `count` things. The CPU
    /// does not foresee that by itself, as a step writes to as many places as there are lanes: it
    /// saves a third of the time if things do not fit the caches.
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

    /// The number of the configuration in the first lane.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub(crate) fn configuration<Y: Layout, V: Level>(self) -> usize {
        self.first * Y::THINGS + self.register * Y::Register::<V>::LANES
    }
}
