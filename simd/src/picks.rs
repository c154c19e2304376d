//! [`CheckedIndices`], checked once; [`Picks`]: which records of a table each lane takes by them; [`Picked`]:
//! with that table.

use crate::lanes::{Lanes, MAX_LANES};
use core::fmt::Debug;

/// How many records a lane takes.
pub const GROUP: usize = 4;

/// How an index lies in memory: `u8`, `u16` or `u32`. Sealed.
pub trait Index: Copy + Debug + Into<u32> + Send + Sync + sealed::Sealed + 'static {}
impl Index for u8 {}
impl Index for u16 {}
impl Index for u32 {}

mod sealed {
    pub trait Sealed {}
    impl Sealed for u8 {}
    impl Sealed for u16 {}
    impl Sealed for u32 {}
}

/// Indices of records of a table, none of them beyond a bound.
#[derive(Clone, Copy, Debug)]
pub struct CheckedIndices<'a, J> {
    indices: &'a [J],
    bound: usize,
}

impl<'a, J: Index> CheckedIndices<'a, J> {
    /// A table must not have more records: what is counted in numbers is a `u32`.
    pub const MOST: usize = (u32::MAX / 16) as usize;

    /// For tables of `bound` records.
    ///
    /// # Errors
    /// The position of the first index that is not below `bound`, or [`MOST`](Self::MOST).
    pub fn new(indices: &'a [J], bound: usize) -> Result<Self, usize> {
        let bound = bound.min(Self::MOST);
        let beyond = |&index: &J| index.into() as usize >= bound;
        indices.iter().position(beyond).map_or(Ok(Self { indices, bound }), Err)
    }

    /// The indices.
    #[inline(always)]
    #[must_use]
    pub fn indices(self) -> &'a [J] {
        self.indices
    }

    /// How many records the table must have.
    #[inline(always)]
    #[must_use]
    pub fn bound(self) -> usize {
        self.bound
    }
}

/// Which records of `C` numbers each lane takes from a table, four of them.
///
/// Aligned like all that is written and read in pieces: what crosses a cache line takes a detour.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub struct Picks<'a, J, const C: usize> {
    /// Where the records begin, counted in numbers: indices times `C`.
    offsets: [[u32; GROUP]; MAX_LANES],
    checked: CheckedIndices<'a, J>,
}

impl<'a, J: Index, const C: usize> Picks<'a, J, C> {
    /// The first record for all lanes.
    #[inline(always)]
    #[must_use]
    pub fn new(checked: CheckedIndices<'a, J>) -> Self {
        const { assert!(4 <= C && C <= 16) };
        Self { offsets: [[0; GROUP]; MAX_LANES], checked }
    }

    /// The first `lanes` lanes take four indices each, in order, from index `4 · first` on. If there are not as
    /// many, nothing changes.
    #[inline(always)]
    pub fn set_rows(&mut self, first: usize, lanes: usize) {
        let rows = self.checked.indices.as_chunks::<GROUP>().0.get(first..);
        let Some(rows) = rows.and_then(|rows| rows.get(..lanes)) else { return };
        let lanes = lanes.min(MAX_LANES);
        let mut lane = 0;
        while lane < lanes {
            let [a, b, c, d] = rows[lane];
            let mut row = [a.into(), b.into(), c.into(), d.into()];
            let mut which = 0;
            while which < GROUP {
                row[which] *= C as u32;
                which += 1;
            }
            self.offsets[lane] = row;
            lane += 1;
        }
    }

    /// A lane takes the index at `position` as one of its own; the first record if there is no such index.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, which: usize, position: usize) {
        if let Some(offset) = self.offsets.get_mut(lane).and_then(|row| row.get_mut(which)) {
            let index = self.checked.indices.get(position);
            *offset = index.map_or(0, |&index| index.into() * C as u32);
        }
    }

    /// In `table`, if it has all those records.
    #[inline(always)]
    #[must_use]
    pub fn of<'t, R>(&'t self, table: &'t [[R; C]]) -> Option<Picked<'t, R, C>> {
        let fits = !table.is_empty() && self.checked.bound <= table.len();
        fits.then_some(Picked { offsets: &self.offsets, table })
    }
}

/// Records of a table, four for each lane, with all indices checked.
#[derive(Clone, Copy, Debug)]
pub struct Picked<'a, R, const C: usize> {
    offsets: &'a [[u32; GROUP]; MAX_LANES],
    table: &'a [[R; C]],
}

impl<'a, R, const C: usize> Picked<'a, R, C> {
    /// One of the records of a lane.
    ///
    /// # Panics
    /// If there is no such lane, or `which` is not below four.
    #[inline(always)]
    #[must_use]
    pub fn record(&self, lane: usize, which: usize) -> &'a [R; C] {
        let offset = self.offsets[lane][which] as usize;
        let first = self.table.as_flattened().as_ptr();
        // SAFETY: a record of the table. Offsets are 0 or `C` times a checked index, below a bound that the table has
        // and that is small enough for `u32`.
        unsafe { &*first.add(offset).cast() }
    }

    /// Transposes on the way in: component `c` of record `which` of lane `i` becomes lane `i` of vector `c`,
    /// for the four components from `from` on.
    ///
    /// # Panics
    /// If there are no such components, or `which` is not below four.
    #[inline(always)]
    #[must_use]
    pub fn quads<L: Lanes<Real = R>>(&self, level: L::Level, which: usize, from: usize) -> [L; 4] {
        // `C` is at least four; `from + 4` may wrap.
        assert!(from <= C - 4 && which < GROUP, "no such components");
        let first = self.table.as_flattened().as_ptr();
        // SAFETY: each offset is that of a record of the table, as in `record`, of which four numbers begin at
        // `from`; there are as many as any register has lanes.
        unsafe {
            L::load_quads(
                level,
                first.add(from),
                #[inline(always)]
                |lane| self.offsets[lane][which] as usize,
            )
        }
    }
}
