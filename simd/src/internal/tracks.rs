//! Interpolation between the keys of packed clips. The keys are read in place, from the bytes of a
//! file.
//!
//! The crate `dq8` defines the file and parses its head. This module has the three tables of the
//! file that a loop reads without checks, so the module also makes the checks without which these
//! reads would be unsound:
//!
//! ```text
//! keys                 four 16-bit integers each
//! clips                first key, frames, step (keys from one frame to the next), row
//! rows[row][column]    an entry, 2 · offset + m: m is 1 if the column moves in the clip, else 0
//! ```
//!
//! A column is the rotation or the translation of one joint. A column that moves has a key for each
//! frame; a column that stays has a single key. So column `c` at frame `f` of a clip has this
//! key:
//!
//! ```text
//! keys[first + m · f · step + offset]       with the entry of rows[row][c]
//! ```
//!
//! Offsets count from the first key of a clip, so that clips in which the same columns move can
//! share one row. A shared row stays in the first-level cache, while keys are read from slower
//! memory.
//!
//! ```text
//! Tracks::new(keys, clips, rows)    checks the key of every column at the last frame of every clip
//! Tracks::place(clip, frame)        a TrackPlace, six plain integers that users may keep
//! Tracks::placed(places)            checks that `place` has made each: PlacedTracks
//! PlacedTracks::between(…)          reads two keys per lane and interpolates, without checks
//! ```

use super::gather::padded;
use crate::index::saturated;
use crate::lanes::{Lanes, Level, MAX_LANES};
use crate::shorts::{Shorts, numbers};
#[cfg(feature = "alloc")]
use alloc::boxed::Box;
use bytemuck::{Pod, Zeroable};

/// The bytes of a little-endian 32-bit integer.
type Word = [u8; 4];
/// The bytes of a column's entry in a row, a little-endian 16-bit integer.
type Entry = [u8; 2];

/// The count of keys in a cache line.
const KEYS_PER_LINE: usize = 8;
/// The least count of keys that are expected not to fit into the second-level cache. They take 1
/// MiB.
const BEYOND_CACHE: usize = 1 << 17;

/// The tables of clips that have the same columns. The constructor has checked that every key to
/// which a clip refers exists. All integers are little-endian, and the tables may begin at any
/// address.
#[derive(Clone, Copy, Debug)]
pub struct Tracks<'a> {
    keys: &'a [Shorts],
    /// For each clip: its first key, its count of frames, its step in keys, and its row.
    clips: &'a [[Word; 4]],
    /// The entries of all rows, row by row.
    rows: &'a [Entry],
    columns: usize,
}

/// The error of bytes that are not valid [`Tracks`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TrackError {
    /// The clip with this index has no frame, or one frame and a step that is not 0, or a key whose
    /// index exceeds 32 bits, or a row that does not exist.
    Clip(usize),
    /// The entry with this index, counted over all rows, refers to a key that does not exist in one
    /// of the clips that use its row.
    Entry(usize),
}

impl<'a> Tracks<'a> {
    /// Makes tracks of the bytes of the three tables, for clips of `columns` columns, and checks
    /// them. Bytes after the last whole record of a table are ignored.
    ///
    /// # Errors
    /// Returns the first clip that is not valid, or the first entry that refers to a key that does
    /// not exist.
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
            // A clip of one frame has no next frame, so its step must be 0. The index of the last
            // key must fit into 32 bits, because `TrackPlace` holds indices of keys in 32 bits.
            let last = frames.checked_sub(1).filter(|_| frames > 1 || step == 0);
            let last = last.map(|last| u64::from(first) + u64::from(last) * u64::from(step));
            let last =
                last.and_then(|last| u32::try_from(last).ok()).ok_or(TrackError::Clip(clip))?;
            let exists = |&entry: &Entry| {
                let entry = u16::from_le_bytes(entry);
                let from = saturated::<usize>(if entry & 1 == 0 { first } else { last });
                // In a clip whose step is 0 no column may move. Otherwise a small file could claim
                // four billion frames of one moving key.
                (entry & 1 == 0 || step > 0)
                    && from.saturating_add((entry >> 1).into()) < tracks.keys.len()
            };
            if let Some(column) = row.iter().position(|entry| !exists(entry)) {
                return Err(TrackError::Entry(number as usize * columns + column));
            }
        }
        Ok(tracks)
    }

    /// Returns the count of clips.
    #[must_use]
    pub fn clips(&self) -> usize {
        self.clips.len()
    }

    /// Returns the count of columns, which is the same for all clips.
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

    /// Returns the count of frames of a clip, or `None` if there is no such clip.
    #[must_use]
    pub fn frames(&self, clip: usize) -> Option<u32> {
        Some(self.clip(clip)?.frames)
    }

    /// Returns true if a column of a clip has a key for each frame, and false if it has a single
    /// key. Returns `None` if there is no such clip or column.
    #[must_use]
    pub fn moves(&self, clip: usize, column: usize) -> Option<bool> {
        Some(u16::from_le_bytes(*self.row(self.clip(clip)?.row)?.get(column)?) & 1 == 1)
    }

    /// Returns the key of a column at a frame: its index among all keys, and its four components.
    /// Returns `None` if there is no such clip, column or frame.
    #[must_use]
    pub fn key(&self, clip: usize, column: usize, frame: u32) -> Option<(usize, [i16; 4])> {
        let Clip { first, frames, step, row } = self.clip(clip)?;
        let entry = *self.row(row)?.get(column)?;
        let there = (frame < frames).then_some(frame)?;
        let own = TrackPlace { origins: [first, first + there * step], ..TrackPlace::default() };
        let [key, _] = own.keys(entry);
        Some((key, numbers(*self.keys.get(key)?)))
    }

    /// Returns the place between `frame` of a clip and the next frame. In a clip of one frame, it
    /// is the place at frame 0. Returns `None` if there is no such clip, or no next frame.
    #[must_use]
    #[inline]
    pub fn place(&self, clip: usize, frame: u32) -> Option<TrackPlace> {
        let Clip { first, frames, step, row } = self.clip(clip)?;
        (frame < frames.saturating_sub(1).max(1)).then_some(())?;
        let row = row * u32::try_from(self.columns).ok()?;
        let origins = [first, first + frame * step];
        Some(TrackPlace { clip: u32::try_from(clip).ok()?, row, origins, steps: [0, step] })
    }

    /// Checks that each element of `places` is a place that [`place`](Self::place) of these tracks
    /// returns. Then returns the tracks paired with the places. There is one place per lane or
    /// instance.
    ///
    /// # Errors
    /// Returns the index of the first place that [`place`](Self::place) of these tracks does not
    /// return.
    pub fn placed<'p>(self, places: &'p [TrackPlace]) -> Result<PlacedTracks<'a, 'p>, usize> {
        let there = |place: &TrackPlace| {
            let after = place.origins[1].wrapping_sub(place.origins[0]);
            // A clip in which no column moves may have the step 0. Then all its frames have the
            // same place.
            let frame = after.checked_div(place.steps[1]).unwrap_or(0);
            self.place(saturated(place.clip), frame).is_some_and(|own| own == *place)
        };
        match places.iter().position(|place| !there(place)) {
            Some(place) => Err(place),
            None => Ok(PlacedTracks { tracks: self, places }),
        }
    }
}

/// A record of the table of clips: its first key, its count of frames, its step in keys, and its
/// row.
struct Clip {
    first: u32,
    frames: u32,
    step: u32,
    row: u32,
}

/// A frame of a packed clip, with the indices from which its keys are found. `PackedClips::place`
/// makes it. It is plain data that users may keep or change, so it is checked again when it is
/// used. A place that [`Tracks::place`] of the clips does not return is then an error.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct TrackPlace {
    clip: u32,
    /// The index of the first entry of the clip's row, in the table of rows.
    row: u32,
    /// The indices of the keys from which the offsets of entries count: element 0 for columns that
    /// stay, element 1 for columns that move.
    origins: [u32; 2],
    /// The distances from a key to the key of the next frame: element 0, for columns that stay,
    /// is 0. Element 1, for columns that move, is the clip's step.
    steps: [u32; 2],
}
// SAFETY: the struct has only integer fields, for which zero bytes are valid.
unsafe impl Zeroable for TrackPlace {}
// SAFETY: the struct is six integers of 32 bits without padding, and any bits are valid integers.
unsafe impl Pod for TrackPlace {}

/// Tracks paired with places in their clips, one per lane or instance. All places have been
/// checked.
#[derive(Clone, Copy, Debug)]
pub struct PlacedTracks<'a, 'p> {
    tracks: Tracks<'a>,
    /// Invariant: each place was returned by `Tracks::place` of these tracks, or is equal to such a
    /// place.
    places: &'p [TrackPlace],
}

impl<'a> PlacedTracks<'a, '_> {
    /// Returns these tracks with a range of the places, which is empty if an end of the range is
    /// beyond the last place.
    #[must_use]
    pub fn part(self, places: core::ops::Range<usize>) -> Self {
        Self { places: self.places.get(places).unwrap_or_default(), ..self }
    }

    /// Interpolates a column of the tracks between two frames, and returns the four components of
    /// the key, each in a vector. Lane `i` goes from the frame at place `first + i`, if lane `i` of
    /// `t` is 0, to the next frame, if it is 1, as [`Lanes::between_shorts`] computes it. Lanes
    /// after the last place take the last place. Returns `None` if there is no place, or no such
    /// column.
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
        // SAFETY: `lanes` has at least as many places as there are lanes. By the invariant of
        // `places`, `place.row` is the first entry of a row, which has `columns` entries, and
        // `column` is less than `columns`. `Tracks::new` has checked that the entry leads to keys
        // that exist at every frame.
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
    /// are more keys than the second-level cache holds. The CPU does not prefetch them by itself,
    /// because each frame has few keys. A cache line has eight keys, so the call does nothing
    /// unless the column is a multiple of eight, or `last` says that it is the last column.
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
        // The function is inlined. If it were called, the loop that samples the clip would spill
        // its registers to the stack around the call.
        for place in self.places.get(first..).unwrap_or_default().iter().take(lanes) {
            let Some(&entry) = rows.get(place.row as usize + column) else { return };
            for key in place.keys(entry).into_iter().filter_map(|key| keys.get(key)) {
                level.prefetch(key);
            }
        }
    }

    /// Interpolates several columns at one place, as [`between`](Self::between) does one column:
    /// lane `i` interpolates column `first + i` by lane `i` of `t`. Lanes after the last column
    /// take the last column. Returns `None` if there is no such place, or if the clips have no
    /// columns.
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
        // SAFETY: `lanes` has at least as many entries as there are lanes, all from the row of the
        // place. `Tracks::new` has checked that each entry leads to keys that exist at every frame,
        // and by the invariant of `places` the place has this frame and the next.
        unsafe {
            let first = *lanes.get_unchecked(0);
            let mut differ = [0; MAX_LANES];
            for (lane, differ) in differ.iter_mut().enumerate().take(L::LANES) {
                let beside = u16::from_le_bytes(first).wrapping_add(2 * lane as u16);
                *differ = u16::from_le_bytes(*lanes.get_unchecked(lane)) ^ beside;
            }
            // In most clips the keys of the lanes adjoin. Then all loads use one base address,
            // which is quicker than an address for each lane.
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
    /// Returns the indices of a column's keys at the frame of this place and at the next frame.
    /// `entry` is the column's entry in the row.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn keys(&self, entry: Entry) -> [usize; 2] {
        let entry = u16::from_le_bytes(entry);
        let moves = (entry & 1) as usize;
        let key = (entry >> 1) as usize + self.origins[moves] as usize;
        [key, key + self.steps[moves] as usize]
    }
}

/// Tracks like [`Tracks`] that own their bytes.
#[cfg(feature = "alloc")]
#[derive(Clone, Debug)]
pub struct OwnedTracks {
    /// Invariant: `Tracks::new` accepts the tables in the three `ranges` of these bytes.
    bytes: Box<[u8]>,
    /// The ranges of the tables of keys, clips and rows in `bytes`.
    ranges: [core::ops::Range<usize>; 3],
    columns: usize,
}

#[cfg(feature = "alloc")]
impl OwnedTracks {
    /// Makes tracks of the tables of keys, clips and rows, which are three ranges of `bytes`, and
    /// checks them like [`Tracks::new`]. A range that is not inside of `bytes` is an empty table.
    ///
    /// # Errors
    /// Returns the first clip that is not valid, or the first entry that refers to a key that does
    /// not exist.
    pub fn new(
        bytes: Box<[u8]>,
        ranges: [core::ops::Range<usize>; 3],
        columns: usize,
    ) -> Result<Self, TrackError> {
        let [keys, clips, rows] = tables(&bytes, &ranges);
        Tracks::new(keys, clips, rows, columns)?;
        Ok(Self { bytes, ranges, columns })
    }

    /// Returns all bytes, including the bytes outside of the tables.
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

/// Returns the bytes of each range, which are none if the range is not inside of `bytes`.
#[cfg(feature = "alloc")]
fn tables<'a>(bytes: &'a [u8], ranges: &[core::ops::Range<usize>; 3]) -> [&'a [u8]; 3] {
    ranges.each_ref().map(|range| bytes.get(range.clone()).unwrap_or_default())
}
