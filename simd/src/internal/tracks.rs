//! [`Tracks`]: keys of many clips, checked once; [`TrackPlace`]: between which two frames of a clip
//! something is; [`PlacedTracks`]: both, checked together. [`OwnedTracks`] owns its bytes.

use crate::index::saturated;
use crate::lanes::{Lanes, Level, MAX_LANES};
use crate::shorts::{Shorts, numbers};
#[cfg(feature = "alloc")]
use alloc::boxed::Box;
use bytemuck::{Pod, Zeroable};

/// A number of 32 bits, the lower byte first.
type Word = [u8; 4];
/// Where a column begins: a number of 16 bits, the lower byte first.
type Entry = [u8; 2];

/// Keys in a cache line.
const PER_LINE: usize = 8;
/// So many keys do not fit into the second cache.
const FAR: usize = 1 << 17;

/// Clips of the same columns: records of four short numbers, one for each frame where
/// a column moves in a clip, and one in all where it does not. Numbers are written with the lower
/// byte first, and nothing is aligned.
///
/// What says where columns begin counts from the clip's own first key: clips in which the same
/// columns move share a row of it, and it stays in the first cache where keys come from far away.
///
/// All keys that the table leads to are there: checked once, and not in the loop.
#[derive(Clone, Copy, Debug)]
pub struct Tracks<'a> {
    keys: &'a [Shorts],
    /// Of each clip: its first key, how many frames, how many keys from one frame to the next, and
    /// its row.
    clips: &'a [[Word; 4]],
    /// `[row][column]`: twice how far the first key is from the clip's, and one more if there is
    /// one for each frame.
    rows: &'a [Entry],
    columns: usize,
}

impl<'a> Tracks<'a> {
    /// Of bytes; what is left of the last number of each slice is not read.
    ///
    /// # Errors
    /// The first clip with an entry that leads beyond the keys, and which of all entries; none if
    /// it is the clip that has more frames, or keys from one to the next, than it can have, or no
    /// row.
    pub fn new(
        keys: &'a [u8],
        clips: &'a [u8],
        rows: &'a [u8],
        columns: usize,
    ) -> Result<Self, (usize, Option<usize>)> {
        let clips = clips.as_chunks::<4>().0.as_chunks().0;
        let tracks = Self { keys: keys.as_chunks().0, clips, rows: rows.as_chunks().0, columns };
        for clip in 0..clips.len() {
            let Clip { first, frames, step, row: number } =
                tracks.clip(clip).ok_or((clip, None))?;
            let row = tracks.row(number).ok_or((clip, None))?;
            // A clip of one frame has no next one; `TrackPlace` counts keys in 32 bits.
            let last = frames.checked_sub(1).filter(|_| frames > 1 || step == 0);
            let last = last.map(|last| u64::from(first) + u64::from(last) * u64::from(step));
            let last = last.and_then(|last| u32::try_from(last).ok()).ok_or((clip, None))?;
            let within = |&entry: &Entry| {
                let entry = u16::from_le_bytes(entry);
                let from = saturated::<usize>(if entry & 1 == 0 { first } else { last });
                // Without a step nothing moves: frames would be as many as 32 bits count, of one
                // key.
                (entry & 1 == 0 || step > 0)
                    && from.saturating_add((entry >> 1).into()) < tracks.keys.len()
            };
            if let Some(column) = row.iter().position(|entry| !within(entry)) {
                return Err((clip, Some(number as usize * columns + column)));
            }
        }
        Ok(tracks)
    }

    /// How many clips there are.
    #[must_use]
    pub fn clips(&self) -> usize {
        self.clips.len()
    }

    /// How many columns a clip has.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    fn row(&self, number: u32) -> Option<&'a [Entry]> {
        let from = saturated::<usize>(number).checked_mul(self.columns)?;
        u32::try_from(from).ok()?;
        self.rows.get(from..from.checked_add(self.columns)?)
    }

    fn clip(&self, clip: usize) -> Option<Clip> {
        let [first, frames, step, row] = self.clips.get(clip)?.map(u32::from_le_bytes);
        Some(Clip { first, frames, step, row })
    }

    /// How many frames a clip has. `None` if there is no such clip.
    #[must_use]
    pub fn frames(&self, clip: usize) -> Option<u32> {
        Some(self.clip(clip)?.frames)
    }

    /// Whether a column of a clip has a key for each frame. `None` if there is no such column.
    #[must_use]
    pub fn moves(&self, clip: usize, column: usize) -> Option<bool> {
        Some(u16::from_le_bytes(*self.row(self.clip(clip)?.row)?.get(column)?) & 1 == 1)
    }

    /// The number of a key, and the key. `None` if there is no such column or frame.
    #[must_use]
    pub fn key(&self, clip: usize, column: usize, frame: u32) -> Option<(usize, [i16; 4])> {
        let Clip { first, frames, step, row } = self.clip(clip)?;
        let entry = *self.row(row)?.get(column)?;
        let there = (frame < frames).then_some(frame)?;
        let own = TrackPlace { frames: [first, first + there * step], ..TrackPlace::default() };
        let [key, _] = own.keys(entry);
        Some((key, numbers(*self.keys.get(key)?)))
    }

    /// Between a frame of a clip and the next one; in a clip of one frame at that. `None` if there
    /// is no such clip, or no frame after it.
    #[must_use]
    #[inline]
    pub fn place(&self, clip: usize, frame: u32) -> Option<TrackPlace> {
        let Clip { first, frames, step, row } = self.clip(clip)?;
        (frame < frames.saturating_sub(1).max(1)).then_some(())?;
        let row = row * u32::try_from(self.columns).ok()?;
        let frames = [first, first + frame * step];
        Some(TrackPlace { clip: u32::try_from(clip).ok()?, row, frames, steps: [0, step] })
    }

    /// Many places in these clips.
    ///
    /// # Errors
    /// The number of the first that is not one of them.
    pub fn placed<'p>(self, places: &'p [TrackPlace]) -> Result<PlacedTracks<'a, 'p>, usize> {
        let there = |place: &TrackPlace| {
            let after = place.frames[1].wrapping_sub(place.frames[0]);
            // A clip of constants has no step, and so the same place for all frames.
            let frame = after.checked_div(place.steps[1]).unwrap_or(0);
            self.place(saturated(place.clip), frame).is_some_and(|own| own == *place)
        };
        match places.iter().position(|place| !there(place)) {
            Some(place) => Err(place),
            None => Ok(PlacedTracks { tracks: self, places }),
        }
    }
}

/// A clip, as the file has it.
struct Clip {
    first: u32,
    frames: u32,
    step: u32,
    row: u32,
}

/// A clip and a frame, as [`Tracks::place`] makes them: where they lie. Any bits are a place that
/// [`Tracks::placed`] accepts or refuses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct TrackPlace {
    clip: u32,
    /// Where the clip's row begins.
    row: u32,
    /// From which key a column counts, if it stays, and if it moves.
    frames: [u32; 2],
    /// How many keys later the next one is.
    steps: [u32; 2],
}
// SAFETY: six numbers of 32 bits, without padding.
unsafe impl Zeroable for TrackPlace {}
// SAFETY: as above; any bits are numbers.
unsafe impl Pod for TrackPlace {}

/// Places in clips that have them.
#[derive(Clone, Copy, Debug)]
pub struct PlacedTracks<'a, 'p> {
    tracks: Tracks<'a>,
    /// Invariant: each is one that `Tracks::place` made of these tracks.
    places: &'p [TrackPlace],
}

impl<'a> PlacedTracks<'a, '_> {
    /// Some of the places; none beyond the last.
    #[must_use]
    pub fn part(self, places: core::ops::Range<usize>) -> Self {
        Self { places: self.places.get(places).unwrap_or_default(), ..self }
    }

    /// [`Lanes::between_shorts`] of a column, lane `i` at place `first + i`; lanes beyond the last
    /// place are there too. `None` if there is no place, or no such column.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn between<L: Lanes>(
        self,
        level: L::Level,
        first: usize,
        column: usize,
        t: L,
    ) -> Option<[L; 4]> {
        let Self { tracks: Tracks { keys, rows, columns, .. }, places } = self;
        let padded;
        let mut lanes = places.get(first..).unwrap_or_default();
        if lanes.len() < L::LANES {
            lanes = if L::LANES == 1 {
                core::slice::from_ref(places.last()?)
            } else {
                padded = repeat(lanes, *places.last()?);
                &padded
            };
        }
        if column >= columns {
            return None;
        }
        // SAFETY: there are as many places as lanes, each with a row, which has the column; by the
        // check of the rows a key and the next one are there.
        Some(unsafe {
            L::between_shorts(
                level,
                keys.as_ptr(),
                #[cfg_attr(not(opt_level_0), inline(always))]
                |lane| {
                    let place = lanes.get_unchecked(lane);
                    place.keys(*rows.get_unchecked(place.row as usize + column))
                },
                t,
            )
        })
    }

    /// Asks for what the lanes from place `first` on will read of a column, where a cache line may
    /// begin with it, or if it is the `last` one, if the keys do not fit into the second cache.
    /// Rows are too short for the CPU to foresee where they go on.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn prefetch<V: Level>(
        self,
        level: V,
        first: usize,
        lanes: usize,
        column: usize,
        last: bool,
    ) {
        let Tracks { keys, rows, .. } = self.tracks;
        if !(column.is_multiple_of(PER_LINE) || last) || keys.len() < FAR {
            return;
        }
        // In line: for a call the loop around it would put its registers away.
        for place in self.places.get(first..).unwrap_or_default().iter().take(lanes) {
            let Some(&entry) = rows.get(place.row as usize + column) else { return };
            for key in place.keys(entry).into_iter().filter_map(|key| keys.get(key)) {
                level.prefetch(key);
            }
        }
    }

    /// [`between`](Self::between) of one place, lane `i` of column `first + i`; lanes beyond the
    /// last column are that.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn between_columns<L: Lanes>(
        self,
        level: L::Level,
        place: usize,
        first: usize,
        t: L,
    ) -> Option<[L; 4]> {
        let place = self.places.get(place)?;
        let row: &'a [Entry] = self.tracks.rows.get(place.row as usize..)?;
        let row = row.get(..self.tracks.columns)?;
        let padded;
        let mut lanes = row.get(first..).unwrap_or_default();
        if lanes.len() < L::LANES {
            lanes = if L::LANES == 1 {
                core::slice::from_ref(row.last()?)
            } else {
                padded = repeat(lanes, *row.last()?);
                &padded
            };
        }
        let from = self.tracks.keys.as_ptr();
        // SAFETY: there are as many entries as lanes, all of the row of the place; by the check of
        // the rows a key and the next one are there.
        unsafe {
            let first = *lanes.get_unchecked(0);
            let mut differ = [0; MAX_LANES];
            for (lane, differ) in differ.iter_mut().enumerate().take(L::LANES) {
                let beside = u16::from_le_bytes(first).wrapping_add(2 * lane as u16);
                *differ = u16::from_le_bytes(*lanes.get_unchecked(lane)) ^ beside;
            }
            // Side by side, most often: an address for all is quicker than one for each.
            if differ.iter().fold(0, |all, one| all | one) == 0 {
                let [key, next] = place.keys(first);
                return Some(L::between_shorts(
                    level,
                    from.add(key),
                    #[cfg_attr(not(opt_level_0), inline(always))]
                    |lane| [lane, next - key + lane],
                    t,
                ));
            }
            Some(L::between_shorts(
                level,
                from,
                #[cfg_attr(not(opt_level_0), inline(always))]
                |lane| place.keys(*lanes.get_unchecked(lane)),
                t,
            ))
        }
    }
}

impl TrackPlace {
    /// Which keys an entry of its row leads to.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn keys(&self, entry: Entry) -> [usize; 2] {
        let entry = u16::from_le_bytes(entry);
        let moves = (entry & 1) as usize;
        let key = (entry >> 1) as usize + self.frames[moves] as usize;
        [key, key + self.steps[moves] as usize]
    }
}

/// Some of them, and `last` in the places that are left.
#[cold]
#[inline(never)]
fn repeat<T: Copy>(some: &[T], last: T) -> [T; MAX_LANES] {
    let mut padded = [last; MAX_LANES];
    for (slot, &one) in padded.iter_mut().zip(some) {
        *slot = one;
    }
    padded
}

/// [`Tracks`] with bytes of their own.
#[cfg(feature = "alloc")]
#[derive(Clone, Debug)]
pub struct OwnedTracks {
    /// Invariant: checked.
    bytes: Box<[u8]>,
    /// Where keys, clips and rows lie.
    ranges: [core::ops::Range<usize>; 3],
    columns: usize,
}

#[cfg(feature = "alloc")]
impl OwnedTracks {
    /// The same checks, of three ranges of `bytes`.
    ///
    /// # Errors
    /// As for [`Tracks::new`]; clip 0 if a range is none of `bytes`.
    pub fn new(
        bytes: Box<[u8]>,
        ranges: [core::ops::Range<usize>; 3],
        columns: usize,
    ) -> Result<Self, (usize, Option<usize>)> {
        let [keys, clips, rows] = ranges.each_ref().map(|range| bytes.get(range.clone()));
        let (Some(keys), Some(clips), Some(rows)) = (keys, clips, rows) else {
            return Err((0, None));
        };
        Tracks::new(keys, clips, rows, columns)?;
        Ok(Self { bytes, ranges, columns })
    }

    /// All bytes.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The same tracks, not checked again.
    #[must_use]
    pub fn borrowed(&self) -> Tracks<'_> {
        let part = |range: &core::ops::Range<usize>| &self.bytes[range.clone()];
        let [keys, clips, rows] = self.ranges.each_ref().map(part);
        let clips = clips.as_chunks::<4>().0.as_chunks().0;
        Tracks { keys: keys.as_chunks().0, clips, rows: rows.as_chunks().0, columns: self.columns }
    }
}
