//! [`Gather`]: records from anywhere in memory to lanes and back.

use crate::lane::Lane;

/// Where the records of [`Indices::COUNT`] lanes are, and how long memory must be for all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Indices {
    at: [u32; Self::COUNT],
    /// The largest index, and one.
    reach: usize,
}

impl Indices {
    /// As many as the widest gather has lanes.
    pub const COUNT: usize = 8;

    /// Finds out how far `at` reaches: once, so that a gather compares one number.
    #[must_use]
    pub const fn new(at: [u32; Self::COUNT]) -> Self {
        let mut reach = 0;
        let mut lane = 0;
        while lane < Self::COUNT {
            let end = (at[lane] as usize).saturating_add(1);
            reach = if end > reach { end } else { reach };
            lane += 1;
        }
        Self { at, reach }
    }

    /// The indices.
    #[must_use]
    pub const fn get(&self) -> &[u32; Self::COUNT] {
        &self.at
    }

    /// The indices of `LANES` lanes from `first` on, if there are so many and memory of `length`
    /// records holds all of [`get`](Self::get).
    #[inline(always)]
    pub(crate) fn within<const LANES: usize>(
        &self,
        first: usize,
        length: usize,
    ) -> Option<&[u32; LANES]> {
        if self.reach > length {
            return None;
        }
        self.at.get(first..).and_then(<[u32]>::first_chunk)
    }
}

/// Lanes that can be filled from records anywhere in memory: at most [`Indices::COUNT`].
pub trait Gather: Lane {
    /// Transposes on the way in: lane `i` of `C` vectors is record `at.get()[first + i]` of `from`.
    /// `None` if some index of `at` is beyond the end of `from`, or there are too few.
    #[inline(always)]
    fn gather<const C: usize>(
        level: Self::Level,
        from: &[[Self::Real; C]],
        at: &Indices,
        first: usize,
    ) -> Option<[Self; C]> {
        let zero = [Self::Real::default(); C];
        let mut records = [zero; Indices::COUNT];
        let at = at.within::<{ Indices::COUNT }>(0, from.len())?.get(first..first + Self::LANES)?;
        for (record, &index) in records.iter_mut().zip(at) {
            *record = *from.get(index as usize)?;
        }
        Some(Self::load_records(level, &records, zero))
    }

    /// Transposes on the way out: lane `i` of `C` vectors becomes record `at.get()[first + i]` of
    /// `to`, the later of two lanes at one place. Writes nothing where [`gather`](Self::gather) reads
    /// nothing.
    #[inline(always)]
    fn scatter<const C: usize>(
        components: [Self; C],
        to: &mut [[Self::Real; C]],
        at: &Indices,
        first: usize,
    ) {
        let mut records = [[Self::Real::default(); C]; Indices::COUNT];
        Self::store_records(components, &mut records);
        let at = at.within::<{ Indices::COUNT }>(0, to.len());
        let Some(at) = at.and_then(|at| at.get(first..first + Self::LANES)) else { return };
        for (record, &index) in records.iter().zip(at) {
            if let Some(slot) = to.get_mut(index as usize) {
                *slot = *record;
            }
        }
    }
}
