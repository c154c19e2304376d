//! [`Gather`]: which row of a table each lane reads.

use crate::index::saturated;

/// A row of a table for each lane: row `frames[i]` holds the records `frames[i] · pitch` and following.
///
/// The greatest of them is found once, so that a load of any lanes needs one comparison to be safe.
///
/// ```
/// use dq8_simd::{Gather, Lanes, Portable, Records, f32x4};
/// // Three rows of two records.
/// let table: Vec<[f32; 4]> = (0..6_u8).map(|i| [f32::from(i); 4]).collect();
/// let frames = [2, 0, 0, 1];
/// let gather = Gather::new(&frames, 2);
/// let [x, ..] = f32x4::load_gathered(Portable, &table, gather, 0, 1).unwrap();
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

    /// Some of the frames; none beyond the last.
    #[must_use]
    pub fn part(self, frames: core::ops::Range<usize>) -> Self {
        Self { frames: self.frames.get(frames).unwrap_or_default(), ..self }
    }
}
