//! Interpolation between the keys of packed clips, which are read from the bytes of a file in
//! place.
//!
//! `dq8` describes the file and parses its head. This file has the three tables of the format that
//! a loop reads without checks, and therefore also the checks that make these reads sound:
//!
//! ```text
//! keys                 four 16-bit numbers each
//! clips                first key, frames, step (keys from one frame to the next), row
//! rows[row][column]    an entry, 2 · offset + m: m is 1 if the column moves in the clip, else 0
//! ```
//!
//! A column is the rotation or the translation of one joint. A column that moves has a key for each
//! frame; a column that stays has one key in all. So column `c` at frame `f` of a clip has this
//! key:
//!
//! ```text
//! keys[first + m · f · step + offset]       with the entry of rows[row][c]
//! ```
//!
//! Offsets count from the first key of a clip, so that clips in which the same columns move share a
//! row. The row then stays in the first-level cache, while keys come from far away.
//!
//! ```text
//! Tracks::new(keys, clips, rows)    checks the key of every column at the last frame of every clip
//! Tracks::place(clip, frame)        a TrackPlace, which users may keep: it is six plain numbers
//! Tracks::placed(places)            checks that each is what `place` makes: PlacedTracks
//! PlacedTracks::between(…)          reads two keys per lane and interpolates, without checks
//! ```

use super::gather::padded;
use crate::index::saturated;
use crate::lanes::{Lanes, Level, MAX_LANES};
use crate::shorts::{Shorts, numbers};
#[cfg(feature = "alloc")]
use alloc::boxed::Box;
use bytemuck::{Pod, Zeroable};

/// A little-endian number of 32 bits.
type Word = [u8; 4];
/// The little-endian entry of a column in a row.
type Entry = [u8; 2];

/// The number of keys in a cache line.
const KEYS_PER_LINE: usize = 8;
/// The number of keys above which the keys do not fit into the second-level cache.
const BEYOND_CACHE: usize = 1 << 17;

/// The keys of clips that have the same columns. Every key that a clip refers to exists: the
/// constructor has checked it. All integers are little-endian, and no table is aligned.
#[derive(Clone, Copy, Debug)]
pub struct Tracks<'a> {
    keys: &'a [Shorts],
    /// The first key of each clip, its number of frames, its step and its row.
    clips: &'a [[Word; 4]],
    /// The entries of all rows, row by row.
    rows: &'a [Entry],
    columns: usize,
}

/// The error of bytes that are not valid [`Tracks`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TrackError {
    /// This clip has no frame, a step without a second frame, more keys than 32 bits count, or a
    /// row that does not exist.
    Clip(usize),
    /// The entry at this index, counted over all rows, refers a clip to a key that does not exist.
    Entry(usize),
}

impl<'a> Tracks<'a> {
    /// Reads the bytes of the three tables. Bytes after the last whole record of a table are
    /// ignored.
    ///
    /// # Errors
    /// Returns the first clip that is wrong, or the first entry that refers to a key that does not
    /// exist.
    pub fn new(
        keys: &'a [u8],
        clips: &'a [u8],
        rows: &'a [u8],
        columns: usize,
    ) -> Result<Self, TrackError> {
        let clips = clips.as_chunks::<4>().0.as_chunks().0;
        let tracks = Self { keys: keys.as_chunks().0, clips, rows: rows.as_chunks().0, columns };
        for clip in 0..clips.len() {
            let Clip { first, frames, step, row: number } =
                tracks.clip(clip).ok_or(TrackError::Clip(clip))?;
            let row = tracks.row(number).ok_or(TrackError::Clip(clip))?;
            // A clip of one frame has no next frame, so its step must be 0. `TrackPlace` has keys
            // in 32 bits.
            let last = frames.checked_sub(1).filter(|_| frames > 1 || step == 0);
            let last = last.map(|last| u64::from(first) + u64::from(last) * u64::from(step));
            let last =
                last.and_then(|last| u32::try_from(last).ok()).ok_or(TrackError::Clip(clip))?;
            let exists = |&entry: &Entry| {
                let entry = u16::from_le_bytes(entry);
                let from = saturated::<usize>(if entry & 1 == 0 { first } else { last });
                // In a clip whose step is 0 no column may move. Otherwise, one key could stand for
                // four billion frames.
                (entry & 1 == 0 || step > 0)
                    && from.saturating_add((entry >> 1).into()) < tracks.keys.len()
            };
            if let Some(column) = row.iter().position(|entry| !exists(entry)) {
                return Err(TrackError::Entry(number as usize * columns + column));
            }
        }
        Ok(tracks)
    }

    /// The number of clips.
    #[must_use]
    pub fn clips(&self) -> usize {
        self.clips.len()
    }

    /// The number of columns, which all clips have.
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

    /// The number of frames of a clip. `None` if there is no such clip.
    #[must_use]
    pub fn frames(&self, clip: usize) -> Option<u32> {
        Some(self.clip(clip)?.frames)
    }

    /// True if a column of a clip has a key for each frame. `None` if there is no such column.
    #[must_use]
    pub fn moves(&self, clip: usize, column: usize) -> Option<bool> {
        Some(u16::from_le_bytes(*self.row(self.clip(clip)?.row)?.get(column)?) & 1 == 1)
    }

    /// Returns the key of a column at a frame: its index among all keys, and its four components.
    /// `None` if there is no such clip, column or frame.
    #[must_use]
    pub fn key(&self, clip: usize, column: usize, frame: u32) -> Option<(usize, [i16; 4])> {
        let Clip { first, frames, step, row } = self.clip(clip)?;
        let entry = *self.row(row)?.get(column)?;
        let there = (frame < frames).then_some(frame)?;
        let own = TrackPlace { origins: [first, first + there * step], ..TrackPlace::default() };
        let [key, _] = own.keys(entry);
        Some((key, numbers(*self.keys.get(key)?)))
    }

    /// Returns the place between a frame of a clip and the next frame; in a clip of one frame, the
    /// place at that frame. `None` if there is no such clip, or no next frame.
    #[must_use]
    #[inline]
    pub fn place(&self, clip: usize, frame: u32) -> Option<TrackPlace> {
        let Clip { first, frames, step, row } = self.clip(clip)?;
        (frame < frames.saturating_sub(1).max(1)).then_some(())?;
        let row = row * u32::try_from(self.columns).ok()?;
        let origins = [first, first + frame * step];
        Some(TrackPlace { clip: u32::try_from(clip).ok()?, row, origins, steps: [0, step] })
    }

    /// Combines these clips with a place in them for each lane.
    ///
    /// # Errors
    /// Returns the index of the first place that does not belong to these clips.
    pub fn placed<'p>(self, places: &'p [TrackPlace]) -> Result<PlacedTracks<'a, 'p>, usize> {
        let there = |place: &TrackPlace| {
            let after = place.origins[1].wrapping_sub(place.origins[0]);
            // A clip in which no column moves has the step 0, so all its frames are the same place.
            let frame = after.checked_div(place.steps[1]).unwrap_or(0);
            self.place(saturated(place.clip), frame).is_some_and(|own| own == *place)
        };
        match places.iter().position(|place| !there(place)) {
            Some(place) => Err(place),
            None => Ok(PlacedTracks { tracks: self, places }),
        }
    }
}

/// A record of the table of clips.
struct Clip {
    first: u32,
    frames: u32,
    step: u32,
    row: u32,
}

/// A frame of a packed clip, and where its keys are. `PackedClips::place` makes one. It is plain
/// data, and checked again when it is used: with other clips, or other bits, it is an error.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct TrackPlace {
    clip: u32,
    /// The index of the row's first entry.
    row: u32,
    /// The index of the key from which offsets count: first for a column that stays, then for a
    /// column that moves.
    origins: [u32; 2],
    /// The distance to the key of the next frame: 0 for a column that stays, and the clip's step
    /// for one that moves.
    steps: [u32; 2],
}
// SAFETY: the struct is six numbers of 32 bits, without padding.
unsafe impl Zeroable for TrackPlace {}
// SAFETY: the struct is six integers of 32 bits without padding, and any bits are valid integers.
unsafe impl Pod for TrackPlace {}

/// Clips, with a place in them for each lane.
#[derive(Clone, Copy, Debug)]
pub struct PlacedTracks<'a, 'p> {
    tracks: Tracks<'a>,
    /// Invariant: `Tracks::place` of these tracks makes each of them.
    places: &'p [TrackPlace],
}

impl<'a> PlacedTracks<'a, '_> {
    /// A range of these places. It is empty if one of its ends is beyond the last place.
    #[must_use]
    pub fn part(self, places: core::ops::Range<usize>) -> Self {
        Self { places: self.places.get(places).unwrap_or_default(), ..self }
    }

    /// Interpolates a column ([`Lanes::between_shorts`]), lane `i` at place `first + i` and
    /// parameter `t`. Lanes after the last place are at the last one. `None` if there is no place,
    /// or no such column.
    #[cfg_attr(not(opt_level_0), inline(always))]
    pub fn between<L: Lanes>(
        self,
        level: L::Level,
        first: usize,
        column: usize,
        t: L,
    ) -> Option<[L; 4]> {
        let Self { tracks: Tracks { keys, rows, columns, .. }, places } = self;
        let copied;
        let mut lanes = places.get(first..).unwrap_or_default();
        if lanes.len() < L::LANES {
            lanes = if L::LANES == 1 {
                core::slice::from_ref(places.last()?)
            } else {
                copied = padded(lanes, *places.last()?);
                &copied
            };
        }
        if column >= columns {
            return None;
        }
        // SAFETY: there are as many places as lanes. Each has a row, which has the column, and
        // `Tracks::new` has checked that the entry leads to a key at this frame and at the next.
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

    /// Prefetches the keys of a column that `lanes` lanes from place `first` on will read, if there
    /// are more keys than the second-level cache holds. The CPU does not foresee these reads,
    /// because each frame's keys are few. Only every eighth column, and the `last`, reaches another
    /// cache line, so other columns do nothing.
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
        if !(column.is_multiple_of(KEYS_PER_LINE) || last) || keys.len() < BEYOND_CACHE {
            return;
        }
        // This loop is inlined, because around a call the loop that samples would spill its
        // registers to the stack.
        for place in self.places.get(first..).unwrap_or_default().iter().take(lanes) {
            let Some(&entry) = rows.get(place.row as usize + column) else { return };
            for key in place.keys(entry).into_iter().filter_map(|key| keys.get(key)) {
                level.prefetch(key);
            }
        }
    }

    /// Interpolates columns of one place ([`Lanes::between_shorts`]), lane `i` column `first + i`
    /// at parameter `t`. Lanes after the last column take the last one. `None` if there is no such
    /// place, or there are no columns.
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
        let copied;
        let mut lanes = row.get(first..).unwrap_or_default();
        if lanes.len() < L::LANES {
            lanes = if L::LANES == 1 {
                core::slice::from_ref(row.last()?)
            } else {
                copied = padded(lanes, *row.last()?);
                &copied
            };
        }
        let from = self.tracks.keys.as_ptr();
        // SAFETY: there are as many entries as lanes, all of them of the row of the place, and
        // `Tracks::new` has checked that each leads to a key at this frame and at the next.
        unsafe {
            let first = *lanes.get_unchecked(0);
            let mut differ = [0; MAX_LANES];
            for (lane, differ) in differ.iter_mut().enumerate().take(L::LANES) {
                let beside = u16::from_le_bytes(first).wrapping_add(2 * lane as u16);
                *differ = u16::from_le_bytes(*lanes.get_unchecked(lane)) ^ beside;
            }
            // In most clips the keys of the lanes adjoin. Then all loads use one address, which is
            // quicker than an address for each lane.
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
    /// Returns the indices of a column's keys at the frame and at the next frame; `entry` is the
    /// column's entry.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn keys(&self, entry: Entry) -> [usize; 2] {
        let entry = u16::from_le_bytes(entry);
        let moves = (entry & 1) as usize;
        let key = (entry >> 1) as usize + self.origins[moves] as usize;
        [key, key + self.steps[moves] as usize]
    }
}

/// [`Tracks`] that own their bytes.
#[cfg(feature = "alloc")]
#[derive(Clone, Debug)]
pub struct OwnedTracks {
    /// Invariant: `Tracks::new` accepts the three ranges.
    bytes: Box<[u8]>,
    /// The ranges of keys, clips and rows.
    ranges: [core::ops::Range<usize>; 3],
    columns: usize,
}

#[cfg(feature = "alloc")]
impl OwnedTracks {
    /// Checks like [`Tracks::new`], with the tables as three ranges of `bytes`: of keys, clips and
    /// rows. A range that is not inside of `bytes` is an empty table.
    ///
    /// # Errors
    /// The same as for [`Tracks::new`].
    pub fn new(
        bytes: Box<[u8]>,
        ranges: [core::ops::Range<usize>; 3],
        columns: usize,
    ) -> Result<Self, TrackError> {
        let [keys, clips, rows] = tables(&bytes, &ranges);
        Tracks::new(keys, clips, rows, columns)?;
        Ok(Self { bytes, ranges, columns })
    }

    /// All bytes.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Returns these tracks borrowed, without checking them again.
    #[must_use]
    pub fn borrowed(&self) -> Tracks<'_> {
        let [keys, clips, rows] = tables(&self.bytes, &self.ranges);
        let clips = clips.as_chunks::<4>().0.as_chunks().0;
        Tracks { keys: keys.as_chunks().0, clips, rows: rows.as_chunks().0, columns: self.columns }
    }
}

/// Returns the bytes of each range; a range beyond the end gives no bytes.
#[cfg(feature = "alloc")]
fn tables<'a>(bytes: &'a [u8], ranges: &[core::ops::Range<usize>; 3]) -> [&'a [u8]; 3] {
    ranges.each_ref().map(|range| bytes.get(range.clone()).unwrap_or_default())
}
