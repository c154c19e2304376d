//! [`CheckedIndices`], checked once; [`PickRows`]: which records of a table each lane takes by
//! them, in place or from [`Picks`]; [`Picked`]: with that table; [`PickedInPlace`]: any number of
//! rows in place, with their table.

use crate::index::saturated;
use crate::lanes::{Lanes, MAX_LANES};
use core::fmt::Debug;

/// How many records a lane takes.
pub const RECORDS_PER_LANE: usize = 4;

/// How an index lies in memory: `u8`, `u16` or `u32`. Sealed.
pub trait Index:
    Copy + Debug + Default + Into<u32> + Send + Sync + sealed::Sealed + 'static
{
    /// Four indices. Overridden where one load of all four is quicker than four.
    #[doc(hidden)]
    #[inline(always)]
    fn numbers(row: [Self; RECORDS_PER_LANE]) -> [usize; RECORDS_PER_LANE] {
        let [a, b, c, d] = row;
        [a.into() as usize, b.into() as usize, c.into() as usize, d.into() as usize]
    }
}
impl Index for u8 {}
impl Index for u16 {
    #[inline(always)]
    fn numbers(row: [Self; RECORDS_PER_LANE]) -> [usize; RECORDS_PER_LANE] {
        let word: u64 = bytemuck::must_cast(row);
        let (a, b) = (usize::from(word as u16), usize::from((word >> 16) as u16));
        let (c, d) = (usize::from((word >> 32) as u16), usize::from((word >> 48) as u16));
        if cfg!(target_endian = "little") { [a, b, c, d] } else { [d, c, b, a] }
    }
}
impl Index for u32 {}

mod sealed {
    pub trait Sealed {}
    impl Sealed for u8 {}
    impl Sealed for u16 {}
    impl Sealed for u32 {}
}

/// Indices of records of a table, none of them beyond a bound: rows of some columns, a row every so
/// many indices. What lies between rows is something else, and never read.
#[derive(Clone, Copy, Debug)]
pub struct CheckedIndices<'a, J> {
    indices: &'a [J],
    columns: usize,
    stride: usize,
    bound: usize,
}

impl<'a, J: Index> CheckedIndices<'a, J> {
    /// For tables of `bound` records. There are as many rows as `indices` has whole; none if a row
    /// has no columns, or more than there are indices from a row to the next.
    ///
    /// # Errors
    /// The row and the column of the first index that is not below `bound`.
    pub fn new(
        indices: &'a [J],
        columns: usize,
        stride: usize,
        bound: usize,
    ) -> Result<Self, (usize, usize)> {
        let beyond = |&index: &J| saturated::<usize>(index.into()) >= bound;
        let indices = if 0 < columns && columns <= stride { indices } else { &[] };
        for (index, row) in indices.chunks(stride.max(1)).enumerate() {
            let Some(row) = row.get(..columns) else { break };
            if let Some(column) = row.iter().position(beyond) {
                return Err((index, column));
            }
        }
        Ok(Self { indices, columns, stride, bound })
    }

    /// The indices, with whatever lies between rows.
    #[inline(always)]
    #[must_use]
    pub fn indices(self) -> &'a [J] {
        self.indices
    }

    /// How many rows there are. Divides.
    #[inline(always)]
    #[must_use]
    pub fn rows(self) -> usize {
        let more = self.indices.len().checked_sub(self.columns);
        more.and_then(|more| more.checked_div(self.stride))
            .map_or(0, |more| if self.indices.is_empty() { 0 } else { more + 1 })
    }

    /// How many indices a row has.
    #[inline(always)]
    #[must_use]
    pub fn columns(self) -> usize {
        self.columns
    }

    /// A row. Empty if there is no such row.
    #[inline(always)]
    #[must_use]
    pub fn row(self, row: usize) -> &'a [J] {
        // Whole rows have been checked, and nothing else; a product that wraps is the beginning of
        // none.
        let from = row.checked_mul(self.stride).and_then(|from| self.indices.get(from..));
        from.and_then(|from| from.get(..self.columns)).unwrap_or_default()
    }

    /// How many records the table must have.
    #[inline(always)]
    #[must_use]
    pub fn bound(self) -> usize {
        self.bound
    }

    /// The indices of as many lanes as any vector has, in place: a row for each from row `first`
    /// on. `None` if there are not as many, or rows have not four columns, or something lies
    /// between them.
    #[inline(always)]
    #[must_use]
    pub fn in_place(self, first: usize) -> Option<PickRows<'a, J>> {
        Some(PickRows { rows: self.fours(first)?.first_chunk()?, bound: self.bound })
    }

    /// Some rows of four indices, from row `first` on, in `table`. `None` if there are not as many,
    /// rows have not four columns, something lies between them, or the table is too short.
    #[inline(always)]
    #[must_use]
    pub fn all_in_place<'t, R, const C: usize>(
        self,
        first: usize,
        count: usize,
        table: &'t [[R; C]],
    ) -> Option<PickedInPlace<'a, 't, J, R, C>> {
        let rows = self.fours(first)?.get(..count)?;
        (self.bound <= table.len()).then_some(PickedInPlace { rows, table })
    }

    /// The rows from row `first` on, if they have four columns and nothing lies between them.
    #[inline(always)]
    fn fours(self, first: usize) -> Option<&'a [[J; RECORDS_PER_LANE]]> {
        let packed = self.columns == RECORDS_PER_LANE && self.stride == RECORDS_PER_LANE;
        if packed { self.indices.as_chunks().0.get(first..) } else { None }
    }
}

/// Rows of four indices in place, one after the other, none of them beyond a bound, with a table
/// that has all those records.
#[derive(Clone, Copy, Debug)]
pub struct PickedInPlace<'a, 't, J, R, const C: usize> {
    rows: &'a [[J; RECORDS_PER_LANE]],
    table: &'t [[R; C]],
}

impl<'t, J: Index, R, const C: usize> PickedInPlace<'_, 't, J, R, C> {
    /// The records of a row. `None` if there is no such row.
    #[inline(always)]
    #[must_use]
    pub fn records(&self, row: usize) -> Option<[&'t [R; C]; RECORDS_PER_LANE]> {
        let &row = self.rows.get(row)?;
        // SAFETY: these indices have been checked, and the table has as many records.
        Some(unsafe { records(row, self.table) })
    }
}

/// The records of four indices.
///
/// # Safety
/// The table has them.
#[inline(always)]
unsafe fn records<J: Index, R, const C: usize>(
    row: [J; RECORDS_PER_LANE],
    table: &[[R; C]],
) -> [&[R; C]; RECORDS_PER_LANE] {
    let [a, b, c, d] = J::numbers(row);
    // SAFETY: promised.
    unsafe {
        [
            table.get_unchecked(a),
            table.get_unchecked(b),
            table.get_unchecked(c),
            table.get_unchecked(d),
        ]
    }
}

/// Indices for each lane in memory of their own: for lanes whose indices do not lie in order.
#[derive(Clone, Debug)]
pub struct Picks<'a, J> {
    rows: [[J; RECORDS_PER_LANE]; MAX_LANES],
    checked: CheckedIndices<'a, J>,
}

impl<'a, J: Index> Picks<'a, J> {
    /// The first record for all lanes.
    #[inline(always)]
    #[must_use]
    pub fn new(checked: CheckedIndices<'a, J>) -> Self {
        Self { rows: [[J::default(); RECORDS_PER_LANE]; MAX_LANES], checked }
    }

    /// The first lanes take the four indices of a row each, from row `first` on. False if there are
    /// not as many rows, or rows of another number; lanes may have been written then.
    #[inline(always)]
    pub fn set_rows(&mut self, lanes: usize, first: usize) -> bool {
        let CheckedIndices { indices, columns, stride, .. } = self.checked;
        let Some(from) = first.checked_mul(stride).filter(|_| columns == RECORDS_PER_LANE) else {
            return false;
        };
        let mut rest = indices.get(from..).unwrap_or_default();
        for slots in self.rows.iter_mut().take(lanes) {
            let Some(own) = rest.first_chunk() else { return false };
            *slots = *own;
            // The last row may end the slice.
            rest = rest.get(stride..).unwrap_or_default();
        }
        true
    }

    /// A lane takes the indices of a row from column `from` on; for those that are not there the
    /// first of the row, and the first record, and false, if there is no such row.
    #[inline(always)]
    pub fn set_row(&mut self, lane: usize, row: usize, from: usize) -> bool {
        let (row, given) = (self.checked.row(row), self.checked.columns.saturating_sub(from));
        if let Some(slots) = self.rows.get_mut(lane) {
            // A loop of a length that is known: one over those that are there takes twice as long.
            for (which, slot) in slots.iter_mut().enumerate() {
                let column = if which < given { from + which } else { 0 };
                *slot = row.get(column).copied().unwrap_or_default();
            }
        }
        !row.is_empty()
    }

    /// A lane takes an index as its first; the first record if there is no such index.
    #[inline(always)]
    pub fn set_first(&mut self, lane: usize, row: usize, column: usize) {
        if let Some([slot, ..]) = self.rows.get_mut(lane) {
            *slot = self.checked.row(row).get(column).copied().unwrap_or_default();
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
    rows: &'a [[J; RECORDS_PER_LANE]; MAX_LANES],
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
/// Indices are read where they lie, number by number or four at a time, and make addresses at once:
/// offsets that a vector multiplied and stored before took a third longer.
#[derive(Clone, Copy, Debug)]
pub struct Picked<'p, 't, J, R, const C: usize> {
    rows: &'p [[J; RECORDS_PER_LANE]; MAX_LANES],
    table: &'t [[R; C]],
}

impl<'t, J: Index, R, const C: usize> Picked<'_, 't, J, R, C> {
    /// The records of a lane.
    ///
    /// # Panics
    /// If there is no such lane.
    #[inline(always)]
    #[must_use]
    pub fn records(&self, lane: usize) -> [&'t [R; C]; RECORDS_PER_LANE] {
        // SAFETY: a checked index is below a bound that the table has; others are 0, and the table
        // has a record.
        unsafe { records(self.rows[lane], self.table) }
    }

    /// Transposes on the way in: component `c` of record `which` of lane `i` becomes lane `i` of
    /// vector `c`, for the four components from `from` on.
    ///
    /// # Panics
    /// If there are no such components, or `which` is not below four.
    #[inline(always)]
    #[must_use]
    pub fn quads<L: Lanes<Real = R>>(&self, level: L::Level, which: usize, from: usize) -> [L; 4] {
        const { assert!(4 <= C) };
        // `from + 4` may wrap.
        assert!(from <= C - 4 && which < RECORDS_PER_LANE, "no such components");
        let first = self.table.as_flattened().as_ptr();
        // SAFETY: each index is that of a record of the table, as in `records`, of which four
        // numbers begin at `from`; there are as many as any register has lanes.
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
