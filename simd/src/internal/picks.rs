//! Reads of a table's records by indices, as a vertex reads the motions of its joints.
//!
//! The indices are a table of their own. A row has `columns` indices (the joints of one vertex),
//! and the next row begins `stride` indices after it. Memory between rows may hold other data (the
//! vertex's position, say) and is never read:
//!
//! ```text
//! columns = 4, stride = 6:    a a a a . .  b b b b . .  c c c c
//! ```
//!
//! A kernel reads four indices per lane at a time. The indices pass through these types:
//!
//! ```text
//! CheckedIndices          checked once: all indices are below a bound
//!   .in_place(first)      rows of four that adjoin in memory, one per lane -> PickRows
//!   Picks::new, .rows()   four indices per lane, copied from anywhere     -> PickRows
//!   PickRows::of(table)   checked: the table reaches the bound            -> Picked
//!   .all_in_place(table)  any number of rows of four that adjoin          -> PickedInPlace
//! ```

use crate::index::saturated;
use crate::lanes::{Lanes, MAX_LANES};
use core::fmt::Debug;

/// The count of records that a lane reads at a time.
pub const RECORDS_PER_LANE: usize = 4;

/// The type of an index in memory: `u8`, `u16` or `u32`. The trait is sealed.
pub trait Index:
    Copy + Debug + Default + Into<u32> + Send + Sync + sealed::Sealed + 'static
{
    /// Returns four indices as `usize`. For `u16`, one load reads all four, which is quicker.
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

/// A table of indices, all of them below a bound. Its rows have `columns` indices and begin
/// `stride` indices apart.
#[derive(Clone, Copy, Debug)]
pub struct CheckedIndices<'a, J> {
    indices: &'a [J],
    columns: usize,
    stride: usize,
    bound: usize,
}

impl<'a, J: Index> CheckedIndices<'a, J> {
    /// Checks that every index is below `bound`, the count of records that may be read. Rows begin
    /// `stride` indices apart and have `columns` indices; an incomplete row at the end of `indices`
    /// does not count. There are no rows if `columns` is 0 or more than `stride`.
    ///
    /// # Errors
    /// Returns the row and the column of the first index that is not below `bound`.
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

    /// Returns the slice of indices, including the memory between rows.
    #[inline(always)]
    #[must_use]
    pub fn indices(self) -> &'a [J] {
        self.indices
    }

    /// Returns the count of rows, which costs a division.
    #[inline(always)]
    #[must_use]
    pub fn rows(self) -> usize {
        let more = self.indices.len().checked_sub(self.columns);
        more.and_then(|more| more.checked_div(self.stride))
            .map_or(0, |more| if self.indices.is_empty() { 0 } else { more + 1 })
    }

    /// Returns the count of indices of a row.
    #[inline(always)]
    #[must_use]
    pub fn columns(self) -> usize {
        self.columns
    }

    /// Returns the indices of a row, or an empty slice if there is no such row.
    #[inline(always)]
    #[must_use]
    pub fn row(self, row: usize) -> &'a [J] {
        // `new` has checked only whole rows, so an incomplete row at the end of the slice counts as
        // missing.
        let from = row.checked_mul(self.stride).and_then(|from| self.indices.get(from..));
        from.and_then(|from| from.get(..self.columns)).unwrap_or_default()
    }

    /// Returns the bound of the indices. They may read a table only if it has at least this many
    /// records.
    #[inline(always)]
    #[must_use]
    pub fn bound(self) -> usize {
        self.bound
    }

    /// Returns the indices of [`MAX_LANES`] lanes without copying them: lane `i` has row
    /// `first + i`. Returns `None` if there are fewer rows from `first` on, or if `columns` or
    /// `stride` is not four.
    #[inline(always)]
    #[must_use]
    pub fn in_place(self, first: usize) -> Option<PickRows<'a, J>> {
        Some(PickRows { rows: self.fours(first)?.first_chunk()?, bound: self.bound })
    }

    /// Checks that `count` rows of four indices, from row `first` on, stay inside `table`, and
    /// returns the rows paired with the table. Returns `None` if there are fewer rows, if `columns`
    /// or `stride` is not four, or if the table has fewer records than [`bound`](Self::bound).
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

    /// Returns the rows from row `first` on, or `None` if `columns` or `stride` is not four.
    #[inline(always)]
    fn fours(self, first: usize) -> Option<&'a [[J; RECORDS_PER_LANE]]> {
        let packed = self.columns == RECORDS_PER_LANE && self.stride == RECORDS_PER_LANE;
        if packed { self.indices.as_chunks().0.get(first..) } else { None }
    }
}

/// Rows of four indices that adjoin in memory, paired with a table that has a record for each
/// index.
#[derive(Clone, Copy, Debug)]
pub struct PickedInPlace<'a, 't, J, R, const C: usize> {
    rows: &'a [[J; RECORDS_PER_LANE]],
    table: &'t [[R; C]],
}

impl<'t, J: Index, R, const C: usize> PickedInPlace<'_, 't, J, R, C> {
    /// Returns the four records that a row's indices name, or `None` if there is no such row.
    #[inline(always)]
    #[must_use]
    pub fn records(&self, row: usize) -> Option<[&'t [R; C]; RECORDS_PER_LANE]> {
        let &row = self.rows.get(row)?;
        // SAFETY: only `all_in_place` makes this type, from indices that are all below a bound,
        // after it has checked that the table has at least as many records as the bound.
        Some(unsafe { records(row, self.table) })
    }
}

/// Returns the records of `table` that four indices name.
///
/// # Safety
/// Every index of `row` must be less than the length of `table`.
#[inline(always)]
unsafe fn records<J: Index, R, const C: usize>(
    row: [J; RECORDS_PER_LANE],
    table: &[[R; C]],
) -> [&[R; C]; RECORDS_PER_LANE] {
    let [a, b, c, d] = J::numbers(row);
    // SAFETY: a to d are the indices of `row`, which the caller guarantees to be less than the
    // length of `table`.
    unsafe {
        [
            table.get_unchecked(a),
            table.get_unchecked(b),
            table.get_unchecked(c),
            table.get_unchecked(d),
        ]
    }
}

/// Four indices per lane, copied from [`CheckedIndices`]. This is for rows that
/// [`CheckedIndices::in_place`] refuses, because they do not have four indices or do not adjoin.
#[derive(Clone, Debug)]
pub struct Picks<'a, J> {
    rows: [[J; RECORDS_PER_LANE]; MAX_LANES],
    checked: CheckedIndices<'a, J>,
}

impl<'a, J: Index> Picks<'a, J> {
    /// Makes picks with index 0 for all lanes.
    #[inline(always)]
    #[must_use]
    pub fn new(checked: CheckedIndices<'a, J>) -> Self {
        Self { rows: [[J::default(); RECORDS_PER_LANE]; MAX_LANES], checked }
    }

    /// Copies row `first + i` to lane `i`, for the first `lanes` lanes. Returns `false` if there
    /// are fewer rows, or if rows do not have four indices; some lanes may then be written.
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
            // The slice may end right after the last row, before the whole stride.
            rest = rest.get(stride..).unwrap_or_default();
        }
        true
    }

    /// Copies four indices of a row to a lane, from column `from` on. Columns that the row does not
    /// have are replaced by column 0. If there is no such row, the lane has index 0 and the return
    /// value is `false`.
    #[inline(always)]
    pub fn set_row(&mut self, lane: usize, row: usize, from: usize) -> bool {
        let (row, given) = (self.checked.row(row), self.checked.columns.saturating_sub(from));
        if let Some(slots) = self.rows.get_mut(lane) {
            // The loop always has four iterations. A loop over only the columns that the row has
            // takes twice as long.
            for (which, slot) in slots.iter_mut().enumerate() {
                let column = if which < given { from + which } else { 0 };
                *slot = row.get(column).copied().unwrap_or_default();
            }
        }
        !row.is_empty()
    }

    /// Copies the index at `row` and `column` to the first of a lane's four indices, or 0 if there
    /// is no such row or column.
    #[inline(always)]
    pub fn set_first(&mut self, lane: usize, row: usize, column: usize) {
        if let Some([slot, ..]) = self.rows.get_mut(lane) {
            *slot = self.checked.row(row).get(column).copied().unwrap_or_default();
        }
    }

    /// Returns the indices of all lanes.
    #[inline(always)]
    #[must_use]
    pub fn rows(&self) -> PickRows<'_, J> {
        PickRows { rows: &self.rows, bound: self.checked.bound }
    }
}

/// Four indices per lane. Each index is below a bound, or 0.
#[derive(Clone, Copy, Debug)]
pub struct PickRows<'a, J> {
    rows: &'a [[J; RECORDS_PER_LANE]; MAX_LANES],
    bound: usize,
}

impl<'a, J: Index> PickRows<'a, J> {
    /// Checks that these indices stay inside `table`, and returns them paired with the table.
    /// Returns `None` if the table is empty or has fewer records than the bound of the indices.
    #[inline(always)]
    #[must_use]
    pub fn of<'t, R, const C: usize>(self, table: &'t [[R; C]]) -> Option<Picked<'a, 't, J, R, C>> {
        let fits = !table.is_empty() && self.bound <= table.len();
        fits.then_some(Picked { rows: self.rows, table })
    }
}

/// Four indices per lane, paired with a table that has a record for each index.
///
/// An index is converted to an address just before the record is read. A version that first
/// computed the offsets of many lanes as a vector and stored them took a third longer.
#[derive(Clone, Copy, Debug)]
pub struct Picked<'p, 't, J, R, const C: usize> {
    rows: &'p [[J; RECORDS_PER_LANE]; MAX_LANES],
    table: &'t [[R; C]],
}

impl<'t, J: Index, R, const C: usize> Picked<'_, 't, J, R, C> {
    /// Returns the four records that a lane's indices name.
    ///
    /// # Panics
    /// Panics if there is no such lane.
    #[inline(always)]
    #[must_use]
    pub fn records(&self, lane: usize) -> [&'t [R; C]; RECORDS_PER_LANE] {
        // SAFETY: each index is 0 or below a bound. Only `PickRows::of` makes this type, after it
        // has checked that the table is not empty and has at least as many records as the bound.
        unsafe { records(self.rows[lane], self.table) }
    }

    /// Loads four components of one record per lane: component `from + c` of the record that index
    /// `which` of lane `i` names becomes lane `i` of vector `c`.
    ///
    /// # Panics
    /// Panics if `from + 4` is more than `C`, or if `which` is not below four.
    #[inline(always)]
    #[must_use]
    pub fn quads<L: Lanes<Real = R>>(&self, level: L::Level, which: usize, from: usize) -> [L; 4] {
        const { assert!(4 <= C) };
        // The condition is not `from + 4 <= C`, because that sum may wrap.
        assert!(from <= C - 4 && which < RECORDS_PER_LANE, "no such components");
        let first = self.table.as_flattened().as_ptr();
        // SAFETY: each index is 0 or below a bound, and the table is not empty and has at least as
        // many records as the bound, as `PickRows::of` has checked. A record has four components
        // from `from` on, as asserted above.
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
