//! [`Gather`]: which row of a table each lane reads; [`GatheredRows`] of it.

use crate::MAX_LANES;
use crate::index::saturated;
use crate::lanes::Lanes;

/// A row of a table for each lane: row `frames[i]` holds the records `frames[i] · pitch` and
/// following.
///
/// The greatest of them is found once, so that a load of any lanes needs one comparison to be safe.
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
    /// Where the row of the greatest frame begins.
    pub(crate) greatest: usize,
}

impl<'f> Gather<'f> {
    /// Frames of a table whose rows are `pitch` records.
    #[must_use]
    pub fn new(frames: &'f [u32], pitch: usize) -> Self {
        let greatest = frames.iter().max().map_or(0, |&frame| saturated::<usize>(frame));
        Self { frames, pitch, greatest: greatest.saturating_mul(pitch) }
    }

    /// The frames.
    #[must_use]
    #[inline(always)]
    pub fn frames(self) -> &'f [u32] {
        self.frames
    }

    /// The rows that so many lanes read, of records of `C` numbers: those of the frames from number
    /// `first` on; lanes beyond the last frame have its row too. `None` if there is no frame.
    #[must_use]
    #[inline(always)]
    pub fn rows<L: Lanes, const C: usize>(self, first: usize) -> Option<GatheredRows<C>> {
        let padded;
        let mut frames = self.frames.get(first..).unwrap_or_default();
        if frames.len() < L::LANES {
            padded = repeat(frames, *self.frames.last()?);
            frames = &padded;
        }
        let mut starts = [0; MAX_LANES];
        // `LANES` of them, a constant: for a count that it does not know the compiler makes masked
        // stores, and the loads after them wait for memory.
        for (start, &frame) in starts.iter_mut().zip(frames.get(..L::LANES)?) {
            // What wraps lies beyond every table, and so does the greatest.
            *start = (frame as usize).wrapping_mul(self.pitch.wrapping_mul(C));
        }
        Some(GatheredRows { starts, greatest: self.greatest })
    }

    /// Some of the frames; none beyond the last.
    #[must_use]
    pub fn part(self, frames: core::ops::Range<usize>) -> Self {
        Self { frames: self.frames.get(frames).unwrap_or_default(), ..self }
    }
}

/// The rows of a [`Gather`] that the lanes of a vector read, found once for all columns of records
/// of `C` numbers.
#[derive(Clone, Copy, Debug)]
pub struct GatheredRows<const C: usize> {
    /// Where each begins, in numbers.
    pub(crate) starts: [usize; MAX_LANES],
    /// Where the greatest begins, in records.
    pub(crate) greatest: usize,
}

/// Some frames, and `last` in the places that are left.
#[cold]
#[inline(never)]
fn repeat(frames: &[u32], last: u32) -> [u32; MAX_LANES] {
    let mut padded = [last; MAX_LANES];
    for (slot, &frame) in padded.iter_mut().zip(frames) {
        *slot = frame;
    }
    padded
}
