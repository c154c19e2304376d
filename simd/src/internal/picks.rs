//! Records of a table by indices from memory, as a vertex reads the motions of its joints.
//!
//! The indices are a table of their own. A row has `columns` indices (the joints of one vertex),
//! and the next row begins `stride` indices later; what is between rows is something else (a
//! vertex's position, say) and is never read:
//!
//! ```text
//! columns = 4, stride = 6:    a a a a . .  b b b b . .  c c c c
//! ```
//!
//! Each vector of lanes takes four indices per lane at a time. They go through these types:
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

/// The number of records that a lane takes at a time.
pub const RECORDS_PER_LANE: usize = 4;

/// The type of an index in memory: `u8`, `u16` or `u32`. The trait is sealed.
pub trait Index:
    Copy + Debug + Default + Into<u32> + Send + Sync + sealed::Sealed + 'static
{
    /// Four indices as `usize`. `u16` loads all four at once, which is quicker.
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

/// Indices of records of a table, all of them below a bound, in rows of `columns` indices that
/// begin `stride` indices apart.
#[derive(Clone, Copy, Debug)]
pub struct CheckedIndices<'a, J> {
    indices: &'a [J],
    columns: usize,
    stride: usize,
    bound: usize,
}

impl<'a, J: Index> CheckedIndices<'a, J> {
    /// Checks that every index is below `bound`, the number of records of the table. There are as
    /// many rows as fit into `indices` as a whole, and none if `columns` is 0 or more than
    /// `stride`.
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

    /// The indices, including what is between rows.
    #[inline(always)]
    #[must_use]
    pub fn indices(self) -> &'a [J] {
        self.indices
    }

    /// The number of rows. This costs a division.
    #[inline(always)]
    #[must_use]
    pub fn rows(self) -> usize {
        let more = self.indices.len().checked_sub(self.columns);
        more.and_then(|more| more.checked_div(self.stride))
            .map_or(0, |more| if self.indices.is_empty() { 0 } else { more + 1 })
    }

    /// The number of indices of a row.
    #[inline(always)]
    #[must_use]
    pub fn columns(self) -> usize {
        self.columns
    }

    /// The indices of a row, or nothing if there is no such row.
    #[inline(always)]
    #[must_use]
    pub fn row(self, row: usize) -> &'a [J] {
        // Only whole rows have been checked, so a row that is cut off by the end is none.
        let from = row.checked_mul(self.stride).and_then(|from| self.indices.get(from..));
        from.and_then(|from| from.get(..self.columns)).unwrap_or_default()
    }

    /// The number of records that the table must have.
    #[inline(always)]
    #[must_use]
    pub fn bound(self) -> usize {
        self.bound
    }

    /// The indices of [`MAX_LANES`] lanes, in place: lane `i` takes row `first + i`. `None` if
    /// there are not as many rows, or if `columns` or `stride` is not four.
    #[inline(always)]
    #[must_use]
    pub fn in_place(self, first: usize) -> Option<PickRows<'a, J>> {
        Some(PickRows { rows: self.fours(first)?.first_chunk()?, bound: self.bound })
    }

    /// The records of `count` rows of four indices, from row `first` on, in `table`. `None` if
    /// there are not as many rows, if `columns` or `stride` is not four, or if the table is too
    /// short.
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

    /// The rows from row `first` on, if `columns` and `stride` are four.
    #[inline(always)]
    fn fours(self, first: usize) -> Option<&'a [[J; RECORDS_PER_LANE]]> {
        let packed = self.columns == RECORDS_PER_LANE && self.stride == RECORDS_PER_LANE;
        if packed { self.indices.as_chunks().0.get(first..) } else { None }
    }
}

/// Rows of four indices that adjoin in memory, with a table that has all these records.
#[derive(Clone, Copy, Debug)]
pub struct PickedInPlace<'a, 't, J, R, const C: usize> {
    rows: &'a [[J; RECORDS_PER_LANE]],
    table: &'t [[R; C]],
}

impl<'t, J: Index, R, const C: usize> PickedInPlace<'_, 't, J, R, C> {
    /// The four records of a row. `None` if there is no such row.
    #[inline(always)]
    #[must_use]
    pub fn records(&self, row: usize) -> Option<[&'t [R; C]; RECORDS_PER_LANE]> {
        let &row = self.rows.get(row)?;
        // SAFETY: the indices are below a bound, and the table has as many records.
        Some(unsafe { records(row, self.table) })
    }
}

/// The records of four indices.
///
/// # Safety
/// The table must have them.
#[inline(always)]
unsafe fn records<J: Index, R, const C: usize>(
    row: [J; RECORDS_PER_LANE],
    table: &[[R; C]],
) -> [&[R; C]; RECORDS_PER_LANE] {
    let [a, b, c, d] = J::numbers(row);
    // SAFETY: the caller keeps the conditions of this function under `# Safety`, which are those of
    // the code here.
    unsafe {
        [
            table.get_unchecked(a),
            table.get_unchecked(b),
            table.get_unchecked(c),
            table.get_unchecked(d),
        ]
    }
}

/// Four indices per lane, copied from [`CheckedIndices`], for lanes whose rows are not of four
/// indices that adjoin.
#[derive(Clone, Debug)]
pub struct Picks<'a, J> {
    rows: [[J; RECORDS_PER_LANE]; MAX_LANES],
    checked: CheckedIndices<'a, J>,
}

impl<'a, J: Index> Picks<'a, J> {
    /// Index 0 for all lanes.
    #[inline(always)]
    #[must_use]
    pub fn new(checked: CheckedIndices<'a, J>) -> Self {
        Self { rows: [[J::default(); RECORDS_PER_LANE]; MAX_LANES], checked }
    }

    /// Copies a row of four indices to each of the first `lanes` lanes, from row `first` on.
    /// Returns `false`, and may have written some lanes, if there are not as many rows, or if rows
    /// do not have four indices.
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
            // The slice may end right after the last row, less than a stride later.
            rest = rest.get(stride..).unwrap_or_default();
        }
        true
    }

    /// Copies four indices of a row to a lane, from column `from` on. Columns that the row does not
    /// have are replaced by its first one. If there is no such row, the lane takes index 0 and the
    /// return value is `false`.
    #[inline(always)]
    pub fn set_row(&mut self, lane: usize, row: usize, from: usize) -> bool {
        let (row, given) = (self.checked.row(row), self.checked.columns.saturating_sub(from));
        if let Some(slots) = self.rows.get_mut(lane) {
            // The loop always has four turns: one over the columns that exist takes twice as long.
            for (which, slot) in slots.iter_mut().enumerate() {
                let column = if which < given { from + which } else { 0 };
                *slot = row.get(column).copied().unwrap_or_default();
            }
        }
        !row.is_empty()
    }

    /// Copies one index to be the first of a lane, or 0 if there is no such row or column.
    #[inline(always)]
    pub fn set_first(&mut self, lane: usize, row: usize, column: usize) {
        if let Some([slot, ..]) = self.rows.get_mut(lane) {
            *slot = self.checked.row(row).get(column).copied().unwrap_or_default();
        }
    }

    /// The indices of all lanes.
    #[inline(always)]
    #[must_use]
    pub fn rows(&self) -> PickRows<'_, J> {
        PickRows { rows: &self.rows, bound: self.checked.bound }
    }
}

/// Four indices per lane, each of them below a bound, or 0.
#[derive(Clone, Copy, Debug)]
pub struct PickRows<'a, J> {
    rows: &'a [[J; RECORDS_PER_LANE]; MAX_LANES],
    bound: usize,
}

impl<'a, J: Index> PickRows<'a, J> {
    /// The records of these indices in `table`, or `None` if it does not have all of them.
    #[inline(always)]
    #[must_use]
    pub fn of<'t, R, const C: usize>(self, table: &'t [[R; C]]) -> Option<Picked<'a, 't, J, R, C>> {
        let fits = !table.is_empty() && self.bound <= table.len();
        fits.then_some(Picked { rows: self.rows, table })
    }
}

/// Four records of a table per lane, all of which the table has.
///
/// An index is turned into an address just before it is read. To compute the offsets of many lanes
/// as a vector and store them first took a third longer.
#[derive(Clone, Copy, Debug)]
pub struct Picked<'p, 't, J, R, const C: usize> {
    rows: &'p [[J; RECORDS_PER_LANE]; MAX_LANES],
    table: &'t [[R; C]],
}

impl<'t, J: Index, R, const C: usize> Picked<'_, 't, J, R, C> {
    /// The four records of a lane.
    ///
    /// # Panics
    /// Panics if there is no such lane.
    #[inline(always)]
    #[must_use]
    pub fn records(&self, lane: usize) -> [&'t [R; C]; RECORDS_PER_LANE] {
        // SAFETY: an index is below a bound that the table reaches, or 0, and the table has a first
        // record.
        unsafe { records(self.rows[lane], self.table) }
    }

    /// Loads four components of one record per lane: component `from + c` of record `which` of lane
    /// `i` becomes lane `i` of vector `c`.
    ///
    /// # Panics
    /// Panics if there are no such components, or if `which` is not below four.
    #[inline(always)]
    #[must_use]
    pub fn quads<L: Lanes<Real = R>>(&self, level: L::Level, which: usize, from: usize) -> [L; 4] {
        const { assert!(4 <= C) };
        // `from + 4 <= C` would be wrong: the sum may wrap.
        assert!(from <= C - 4 && which < RECORDS_PER_LANE, "no such components");
        let first = self.table.as_flattened().as_ptr();
        // SAFETY: the table has a record for each index, as in `records`, which has four numbers
        // from `from` on, and there are indices for as many lanes as any vector has.
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
