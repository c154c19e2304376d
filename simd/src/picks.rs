//! [`CheckedIndices`], checked once; [`PickRows`]: which records of a table each lane takes by them, in place or from
//! [`Picks`]; [`Picked`]: with that table.

use crate::lanes::{Lanes, MAX_LANES};
use core::fmt::Debug;

/// How many records a lane takes.
pub const GROUP: usize = 4;

/// How an index lies in memory: `u8`, `u16` or `u32`. Sealed.
pub trait Index:
    Copy + Debug + Default + Into<u32> + Send + Sync + sealed::Sealed + 'static
{
}
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
    /// For tables of `bound` records.
    ///
    /// # Errors
    /// The position of the first index that is not below `bound`.
    pub fn new(indices: &'a [J], bound: usize) -> Result<Self, usize> {
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

    /// The indices of as many lanes as any vector has, in place: four for each, from index `4 · first` on. `None` if
    /// there are not as many.
    #[inline(always)]
    #[must_use]
    pub fn in_place(self, first: usize) -> Option<PickRows<'a, J>> {
        let rows = self.indices.as_chunks::<GROUP>().0.get(first..)?;
        Some(PickRows { rows: rows.first_chunk()?, bound: self.bound })
    }
}

/// Indices for each lane in memory of their own: for lanes whose indices do not lie in order.
#[derive(Clone, Debug)]
pub struct Picks<'a, J> {
    rows: [[J; GROUP]; MAX_LANES],
    checked: CheckedIndices<'a, J>,
}

impl<'a, J: Index> Picks<'a, J> {
    /// The first record for all lanes.
    #[inline(always)]
    #[must_use]
    pub fn new(checked: CheckedIndices<'a, J>) -> Self {
        Self { rows: [[J::default(); GROUP]; MAX_LANES], checked }
    }

    /// A lane takes the index at `position` as one of its own; the first record if there is no such index.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, which: usize, position: usize) {
        if let Some(slot) = self.rows.get_mut(lane).and_then(|row| row.get_mut(which)) {
            *slot = self.checked.indices.get(position).copied().unwrap_or_default();
        }
    }

    /// The indices.
    #[inline(always)]
    #[must_use]
    pub fn rows(&self) -> PickRows<'_, J> {
        PickRows { rows: &self.rows, bound: self.checked.bound }
    }
}

/// Four indices for each lane, none of them beyond a bound, if that is not zero.
#[derive(Clone, Copy, Debug)]
pub struct PickRows<'a, J> {
    rows: &'a [[J; GROUP]; MAX_LANES],
    bound: usize,
}

impl<'a, J: Index> PickRows<'a, J> {
    /// In `table`, if it has all those records.
    #[inline(always)]
    #[must_use]
    pub fn of<'t, R, const C: usize>(self, table: &'t [[R; C]]) -> Option<Picked<'a, 't, J, R, C>> {
        let fits = !table.is_empty() && self.bound <= table.len();
        fits.then_some(Picked { rows: self.rows, table })
    }
}

/// Records of a table, four for each lane, with all indices checked.
///
/// Indices are read where they lie, number by number, by the instructions that find addresses: offsets that a vector
/// multiplied and stored before took a third longer.
#[derive(Clone, Copy, Debug)]
pub struct Picked<'p, 't, J, R, const C: usize> {
    rows: &'p [[J; GROUP]; MAX_LANES],
    table: &'t [[R; C]],
}

impl<'t, J: Index, R, const C: usize> Picked<'_, 't, J, R, C> {
    /// One of the records of a lane.
    ///
    /// # Panics
    /// If there is no such lane, or `which` is not below four.
    #[inline(always)]
    #[must_use]
    pub fn record(&self, lane: usize, which: usize) -> &'t [R; C] {
        let index = self.rows[lane][which].into() as usize;
        // SAFETY: a checked index is below a bound that the table has; others are 0, and the table has a record.
        unsafe { self.table.get_unchecked(index) }
    }

    /// Transposes on the way in: component `c` of record `which` of lane `i` becomes lane `i` of vector `c`,
    /// for the four components from `from` on.
    ///
    /// # Panics
    /// If there are no such components, or `which` is not below four.
    #[inline(always)]
    #[must_use]
    pub fn quads<L: Lanes<Real = R>>(&self, level: L::Level, which: usize, from: usize) -> [L; 4] {
        const { assert!(4 <= C) };
        // `from + 4` may wrap.
        assert!(from <= C - 4 && which < GROUP, "no such components");
        let first = self.table.as_flattened().as_ptr();
        // SAFETY: each index is that of a record of the table, as in `record`, of which four numbers begin at
        // `from`; there are as many as any register has lanes.
        unsafe {
            L::load_quads(
                level,
                first.add(from),
                #[inline(always)]
                |lane| self.rows[lane][which].into() as usize * C,
            )
        }
    }
}
