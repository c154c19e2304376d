//! [`Gather`]: reads of a table in which each lane reads a row of its own.
//!
//! The table is a clip that is played for many instances. A row of the table holds the poses of one
//! frame. Each lane is an instance, which is at a frame of its own.
//!
//! ```text
//! Gather::new(frames, pitch)          finds the greatest frame
//!   .rows(first)                      finds where each lane's row begins
//! load_gathered(table, rows, column)  checks only that the greatest row has the record
//! ```

use crate::MAX_LANES;
use crate::index::saturated;
use crate::lanes::Lanes;

/// A list with one frame of a table for each instance. Row `frame` of the table is its `pitch`
/// records from record `frame · pitch` on.
///
/// ```
/// use dq8_simd::internal::Gather;
/// use dq8_simd::{Lanes, Portable, Records, f32x4};
/// // Three rows of two records.
/// let table: Vec<[f32; 4]> = (0..6_u8).map(|i| [f32::from(i); 4]).collect();
/// let frames = [2, 0, 0, 1];
/// let gather = Gather::new(&frames, 2);
/// let rows = gather.rows::<f32x4, 4>(0).unwrap();
/// let [x, ..] = f32x4::load_gathered(Portable, &table, &rows, 1).unwrap();
/// assert_eq!(x.to_array(), [5.0, 1.0, 1.0, 3.0]);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Gather<'f> {
    pub(crate) frames: &'f [u32],
    pub(crate) pitch: usize,
    /// The index of the first record in the row of the greatest frame.
    pub(crate) greatest: usize,
}

impl<'f> Gather<'f> {
    /// Makes a gather of these frames, one per instance, from a table whose rows have `pitch`
    /// records.
    #[must_use]
    #[inline(always)]
    pub fn new(frames: &'f [u32], pitch: usize) -> Self {
        let mut greatest = 0;
        for &frame in frames {
            greatest = frame.max(greatest);
        }
        let greatest = saturated::<usize>(greatest);
        Self { frames, pitch, greatest: greatest.saturating_mul(pitch) }
    }

    /// Returns the frames, one per instance.
    #[must_use]
    #[inline(always)]
    pub fn frames(self) -> &'f [u32] {
        self.frames
    }

    /// Returns the rows that the lanes of a vector read: lane `i` reads the row of frame
    /// `frames[first + i]`. Lanes after the last frame read the row of the last frame. The records
    /// of the table have `C` components. Returns `None` if there are no frames.
    #[must_use]
    #[inline(always)]
    pub fn rows<L: Lanes, const C: usize>(self, first: usize) -> Option<GatheredRows<C>> {
        let copied;
        let mut frames = self.frames.get(first..).unwrap_or_default();
        if frames.len() < L::LANES {
            copied = padded(frames, *self.frames.last()?);
            frames = &copied;
        }
        let mut starts = [0; MAX_LANES];
        // The loop has `LANES` iterations, which is a constant. With a count that is known at run
        // time only, the compiler makes masked stores to `starts`, and the loads from `starts` then
        // wait for them.
        for (start, &frame) in starts.iter_mut().zip(frames.get(..L::LANES)?) {
            // If the product wraps, the row is beyond the end of every table. Then the greatest row
            // is also beyond the end, and `load_gathered` refuses to read.
            *start = (frame as usize).wrapping_mul(self.pitch.wrapping_mul(C));
        }
        Some(GatheredRows { starts, greatest: self.greatest })
    }

    /// Returns a gather of a range of these frames, which is empty if an end of the range is beyond
    /// the last frame.
    #[must_use]
    pub fn part(self, frames: core::ops::Range<usize>) -> Self {
        Self { frames: self.frames.get(frames).unwrap_or_default(), ..self }
    }
}

/// The rows of a [`Gather`] that the lanes of a vector read, in a table of records of `C`
/// components. The same rows serve for all columns of the table.
#[derive(Clone, Copy, Debug)]
pub struct GatheredRows<const C: usize> {
    /// The index, in components, at which each row begins in the table.
    pub(crate) starts: [usize; MAX_LANES],
    /// The index of the first record in the greatest row.
    pub(crate) greatest: usize,
}

/// Returns an array with one value per lane, for vectors with more lanes than `values`: first
/// `values`, then `last` in the remaining lanes.
#[cold]
#[inline(never)]
pub(super) fn padded<T: Copy>(values: &[T], last: T) -> [T; MAX_LANES] {
    let mut padded = [last; MAX_LANES];
    for (slot, &value) in padded.iter_mut().zip(values) {
        *slot = value;
    }
    padded
}
