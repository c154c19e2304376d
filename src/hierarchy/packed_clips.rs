//! [`PackedClips`]: clips of a skeleton in 8 bytes for each frame of each moving track, decoded in
//! registers.

use super::clip::{Keys, KeysAt, SINGLE, Single, Timing, first};
use super::locals::sealed::Sealed;
use super::run::JointSlot;
use crate::batch::vector;
use crate::law::{Law, NlerpLerp};
use crate::macros::{brief, errors};
use crate::number::Scalar;
use crate::scalar::DualQuat;
use crate::storage::shape::ShapeError;
use crate::storage::{Aos, Layout};
use core::ops::Range;
use dq8_simd::internal::{PlacedTracks, TrackError, TrackPlace, Tracks};
use dq8_simd::{Lanes, MAX_LANES, Mask, Records};

/// The integer that stands for the value 1 in a key of a rotation.
pub(super) const ONE: f64 = 32767.0;
/// 32767² cos 30°, the least dot product of the rotation keys of neighbouring frames: rotations
/// less than 60° apart have quaternions less than 30° apart.
const NEAREST: i64 = 929_830_942;

/// The rest record of a joint: the position x, y, z in its parent to which keys of translations are
/// added, and 2⁻¹⁴ times the step, which is the length of one unit of these keys. The step is
/// 0 if no clip translates the joint. The record is four `f32` with the lowest byte first.
pub(super) type Rest = [u8; 16];

/// The timing of a clip as bytes: its rate in frames a second as a sum of two `f32`; then 1 if the
/// clip loops, otherwise 0; and the number of pieces, 1 to 4, into which packing has divided each
/// step between its frames.
pub(super) type PackedTiming = [u8; 12];

/// Clips of one skeleton, borrowed from their bytes, for instance those of a mapped file or of
/// flash memory. The bytes are checked once. Each clip has any number of frames at equal distances
/// in time. [`Sampled`](super::Sampled) plays them, and each instance may play a clip of its own.
///
/// A key is four integers of 16 bits. A track is the rotation or the translation of one joint in
/// one clip. A track that does not change has one key; any other track has a key for each frame.
/// The translation of a joint that no clip translates has no key. [The guide](crate::guide::clips)
/// tells the cost of packed clips in memory and time, and their errors.
/// [`PackedClip`](super::PackedClip) packs clips.
///
/// # Bytes
///
/// All numbers have the lowest byte first. The bytes need no alignment, but loads are faster if
/// they begin at a cache line.
///
/// | bytes | contents |
/// |---|---|
/// | 8 | `dq8clips` |
/// | 6 · `u32` | version 3, joints J, clips N, keys K, rows R, 0 |
/// | K · 4 · `i16` | keys: rotations x, y, z, w, 32767 for 1; translations x, y, z, 0 in steps |
/// | J · 4 · `f32` | rests: x, y, z, and 2⁻¹⁴ times the step |
/// | N · 4 · `u32` | the first key, the number of frames, the keys per frame, and the row |
/// | N · (`f32`, `f32`, `u16`, `u16`) | the rate, its rounding error, loops, pieces |
/// | R · 2J · `u16` | places of keys: J rotations, then J translations |
///
/// The rest of a joint is a position. The keys of its translations are displacements from this
/// position, in units of the step. The rate of a clip is the sum of two `f32`, the rounded rate in
/// frames a second and its rounding error; it is 1 if times are in frames. The first `u16` after
/// the rate is 1 for a clip that loops, otherwise 0. The second `u16` is the number of pieces, 1 to
/// 4, into which packing has divided each step between frames of the clip. A place of keys is twice
/// the distance from the first key of the clip to the first key of the track, plus 1 if the track
/// has a key for each frame. Clips in which the same tracks move share one row of places.
#[derive(Clone, Copy)]
pub struct PackedClips<'a> {
    pub(super) tracks: Tracks<'a>,
    pub(super) rests: &'a [Rest],
    pub(super) timings: &'a [PackedTiming],
}

brief!([] PackedClips<'_>: PackedClips |it| { joints: it.joints(), clips: it.clips() });

pub(super) const MAGIC: &[u8; 8] = b"dq8clips";
pub(super) const VERSION: u32 = 3;
const HEAD: usize = 32;

/// Returns the byte ranges of the tables of keys, rests, clips, timings and rows, and the number of
/// joints.
pub(super) fn parts(bytes: &[u8]) -> Result<([Range<usize>; 5], usize), PackedError> {
    let wrong = |offset, what| PackedError::Bytes { offset, what };
    if bytes.first_chunk() != Some(MAGIC) {
        return Err(wrong(0, "bad magic"));
    }
    let words = bytes.get(8..HEAD).ok_or(wrong(bytes.len(), "unexpected end"))?;
    let [version, joints, clips, keys, rows] =
        core::array::from_fn(|i| word(words, i).map_or(0, |word| word as usize));
    if version != VERSION as usize {
        return Err(wrong(8, "unsupported version"));
    }
    let lengths = [
        Some((keys, 8)),
        Some((joints, 16)),
        Some((clips, 16)),
        Some((clips, 12)),
        rows.checked_mul(joints).map(|all| (all, 4)),
    ];
    let mut end = HEAD;
    let mut ranges = [const { 0..0 }; 5];
    for (range, length) in ranges.iter_mut().zip(lengths) {
        let start = end;
        end = length
            .and_then(|(count, size): (usize, usize)| count.checked_mul(size)?.checked_add(start))
            .filter(|&end| end <= bytes.len())
            .ok_or(wrong(bytes.len(), "unexpected end"))?;
        *range = start..end;
    }
    if end == bytes.len() { Ok((ranges, joints)) } else { Err(wrong(end, "bytes after the end")) }
}

fn word(bytes: &[u8], index: usize) -> Option<u32> {
    bytes.as_chunks().0.get(index).map(|&word| u32::from_le_bytes(word))
}

/// Returns `true` if both keys are unit rotations less than 60° apart. Then the polynomial of
/// [`unit()`] normalizes their mean with an error of the order of rounding to `f32`.
pub(super) fn neighbours(a: [i16; 4], b: [i16; 4]) -> bool {
    let dot = |a: [i16; 4], b: [i16; 4]| -> i64 {
        a.iter().zip(b).map(|(&a, b)| i64::from(a) * i64::from(b)).sum()
    };
    // The bounds of the squared length are (32767 − 4)² and (32767 + 4)². Rounding a unit
    // rotation to integers changes its length by at most 1.
    let unit = |key| (1_073_414_169..=1_073_938_441).contains(&dot(key, key));
    unit(a) && unit(b) && dot(a, b) >= NEAREST
}

/// The error text for bytes with too few keys, in which several tracks would have to share keys.
const SHARED: &str = "clips have more tracks and frames than there are keys";

impl<'a> PackedClips<'a> {
    /// Borrows packed clips from the bytes of
    /// [`PackedClip::as_bytes`](super::PackedClip::as_bytes), without a copy. All bytes are read
    /// once, to check them.
    ///
    /// # Errors
    /// If the bytes are not a packed clip file; the error has the first offset of a fault.
    pub fn from_bytes(bytes: &'a [u8]) -> Result<Self, PackedError> {
        let (ranges, joints) = parts(bytes)?;
        let [keys, rests, clips, timings, rows] =
            ranges.clone().map(|range| bytes.get(range).unwrap_or_default());
        // Each rotation has at least one key of its own in each clip. So the number of keys limits
        // the number of clips times joints, and the checks of hostile bytes cannot take long.
        let own = (clips.len() / 16).saturating_mul(joints);
        if own > keys.len() / 8 {
            return Err(PackedError::Bytes { offset: ranges[2].start, what: SHARED });
        }
        let tracks =
            Tracks::new(keys, clips, rows, 2 * joints).map_err(|at| beyond(&ranges, at))?;
        let packed = Self { tracks, rests: rests.as_chunks().0, timings: timings.as_chunks().0 };
        packed.check_counts(&ranges, keys.len() / 8)?;
        packed.check(&ranges)?;
        Ok(packed)
    }

    /// Checks that the file has enough keys for each clip to have keys of its own. Then the later
    /// checks, which read the keys of every clip, read no more keys than the file has.
    fn check_counts(&self, ranges: &[Range<usize>; 5], keys: usize) -> Result<(), PackedError> {
        let mut left = keys;
        for clip in 0..self.clips() {
            let frames = self.own_frames(clip).unwrap_or(1);
            let moves = |&joint: &usize| self.tracks.moves(clip, joint) == Some(true);
            let moving = (0..self.joints()).filter(moves).count();
            let own = frames.saturating_mul(moving).saturating_add(self.joints() - moving);
            left = left
                .checked_sub(own)
                .ok_or(PackedError::Bytes { offset: ranges[2].start + 16 * clip, what: SHARED })?;
        }
        Ok(())
    }

    /// Checks that rotations are unit and near their neighbours, rests are finite, and rates are
    /// positive.
    fn check(&self, [keys, rests, _, timings, _]: &[Range<usize>; 5]) -> Result<(), PackedError> {
        if let Some(joint) =
            self.rests.iter().position(|rest| floats(rest).iter().any(|c| !c.is_finite()))
        {
            return Err(PackedError::Bytes {
                offset: rests.start + 16 * joint,
                what: "a rest is not finite",
            });
        }
        let frames = |clip| self.tracks.frames(clip).unwrap_or(1);
        let mut timings_of_clips = self.timings.iter().enumerate();
        if let Some(clip) =
            timings_of_clips.position(|(clip, timing)| !is_timing(timing, frames(clip)))
        {
            return Err(PackedError::Bytes {
                offset: timings.start + 12 * clip,
                what: "the rate of a clip is not positive, it neither loops nor ends, or it has no whole number of frames",
            });
        }
        for (clip, joint) in
            (0..self.clips()).flat_map(|clip| (0..self.joints()).map(move |joint| (clip, joint)))
        {
            let moves = self.tracks.moves(clip, joint) == Some(true);
            let last = if moves { self.own_frames(clip).unwrap_or(1) - 1 } else { 0 };
            let key = |frame| self.tracks.key(clip, joint, frame as u32).unwrap_or_default();
            let far = |&frame: &usize| !neighbours(key(frame).1, key((frame + 1).min(last)).1);
            if let Some(frame) = (0..=last).find(far) {
                let offset = keys.start + 8 * key(frame).0;
                let what = "rotations of a joint are not unit, or 60° apart";
                return Err(PackedError::Bytes { offset, what });
            }
        }
        Ok(())
    }

    /// The number of joints of the skeleton.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.rests.len()
    }

    /// The number of clips.
    #[must_use]
    pub fn clips(&self) -> usize {
        self.tracks.clips()
    }

    /// The number of frames of a clip, without the frames that
    /// [`PackedClip::new`](super::PackedClip::new) inserts between them. `None` if there is no such
    /// clip.
    #[must_use]
    pub fn frames(&self, clip: usize) -> Option<usize> {
        Some((self.own_frames(clip)? - 1) / self.pieces(clip)? + 1)
    }

    /// The number of frames of a clip in the file, including the inserted frames.
    fn own_frames(&self, clip: usize) -> Option<usize> {
        self.tracks.frames(clip).map(|frames| frames as usize)
    }

    /// The number of pieces into which packing has divided each step between frames of the clip.
    pub(super) fn pieces(&self, clip: usize) -> Option<usize> {
        let [_, pieces] = loops_and_pieces(self.timings.get(clip)?);
        // The number of pieces was checked to be at least 1. `max` shows this to the compiler,
        // which then compiles no code for a division by zero.
        Some(pieces.max(1) as usize)
    }

    /// The number of tracks of a clip that have a key for each frame. A track is the rotation or
    /// the translation of one joint; the other tracks have one key or none. `None` if there is no
    /// such clip.
    #[must_use]
    pub fn moving(&self, clip: usize) -> Option<usize> {
        self.own_frames(clip)?;
        Some(
            (0..self.tracks.columns())
                .filter(|&c| self.tracks.moves(clip, c) == Some(true))
                .count(),
        )
    }

    /// The rate of a clip in frames a second, or 1 if its times are in frames. `None` if there is
    /// no such clip.
    #[must_use]
    pub fn rate(&self, clip: usize) -> Option<f64> {
        let [rate, rest] = rate(self.timings.get(clip)?).map(f64::from);
        Some(rate + rest)
    }

    /// Returns `Some(true)` if a clip begins again after its end, `Some(false)` if it stops there,
    /// and `None` if there is no such clip.
    #[must_use]
    pub fn loops(&self, clip: usize) -> Option<bool> {
        Some(self.timing::<f32>(clip)?.loops)
    }

    /// The time from the first frame of a clip to the last, in seconds if it has a rate: see
    /// [`Clip::duration`](super::Clip::duration). `None` if there is no such clip.
    #[must_use]
    pub fn duration(&self, clip: usize) -> Option<f64> {
        Some(self.timing::<f64>(clip)?.duration())
    }

    /// Returns the frame of a clip before the time `at`, and the part of the way to the next frame,
    /// from 0 to 1, like [`Clip::place`](super::Clip::place). Times are in seconds if the clip has
    /// a rate; in a clip that loops, `at` may lie in any round. The place is computed in the type
    /// `R`: with `f32` and a time of one hour, it is wrong by half a hundredth of a frame. For NaN
    /// the part is NaN. `None` if there is no such clip.
    #[must_use]
    pub fn place<R: Scalar>(&self, clip: usize, at: R) -> Option<(TrackPlace, R)> {
        let (frame, t) = self.timing::<R>(clip)?.place(at);
        Some((self.tracks.place(clip, frame)?, t))
    }

    /// Returns the timing of a clip, which counts the frames in the file, including the inserted
    /// frames.
    pub(super) fn timing<T: Scalar>(&self, clip: usize) -> Option<Timing<T>> {
        let timing = self.timings.get(clip)?;
        let [rate, rest] = rate(timing).map(T::from);
        let [loops, pieces] = loops_and_pieces(timing);
        let rate = (rate + rest) * T::from_i32(pieces.cast_signed());
        Some(Timing { frames: self.own_frames(clip)?, rate, loops: loops == 1 })
    }
}

impl PackedClips<'_> {
    /// Returns the local pose of a joint of a clip at the time `at` (in the unit of
    /// [`place`](Self::place)), or `None` if there is no such clip or joint. See
    /// [`Clip::pose`](super::Clip::pose).
    #[must_use]
    pub fn pose<R: Scalar>(&self, clip: usize, joint: usize, at: R) -> Option<DualQuat<R>> {
        self.pose_at(clip, joint, self.timing::<R>(clip)?.place(at))
    }

    /// Returns the motion of a joint of a clip from one time to another, in the joint's frame at
    /// the first time; for the root of a character this is its root motion. See
    /// [`Clip::between`](super::Clip::between). `None` if there is no such clip or joint.
    ///
    /// ```
    /// use dq8::hierarchy::{Clip, PackedClip, Tolerance};
    /// // A step of one length in two frames, at 30 frames a second.
    /// let keys = [0.0_f32, 0.25, 1.0].map(|z| [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, z]);
    /// let walk = Clip::new(1, &keys)?.with_rate(30.0).looping();
    /// let packed = PackedClip::new(walk, Tolerance::default())?;
    /// let second = packed.clips().between(0, 0, 0.25_f32, 1.25).unwrap();
    /// assert!((second.translation()[2] - 15.0).abs() < 1e-3);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[must_use]
    pub fn between<R: Scalar>(
        &self,
        clip: usize,
        joint: usize,
        from: R,
        to: R,
    ) -> Option<DualQuat<R>> {
        self.timing::<R>(clip)?.between(from, to, |place| self.pose_at(clip, joint, place))
    }

    /// Returns the pose of a joint at a place of a clip.
    fn pose_at<R: Scalar>(
        &self,
        clip: usize,
        joint: usize,
        (frame, t): (u32, R),
    ) -> Option<DualQuat<R>> {
        let joints = self.joints();
        (joint < joints).then_some(())?;
        let places = [self.tracks.place(clip, frame)?];
        let playback = Keys::<R, 7>::placed(*self, &places).ok()?;
        let slot = JointSlot::of_joints(joint, 0, joints, joint + 1);
        let t: <Aos<R> as Layout>::Register<Single> = Lanes::splat(SINGLE, t);
        Some(first(NlerpLerp, KeysAt::pose(playback, SINGLE, NlerpLerp, slot, t)?))
    }
}

fn rate(timing: &PackedTiming) -> [f32; 2] {
    [0, 1].map(|i| word(timing, i).map_or(0.0, f32::from_bits))
}

/// Converts the error of a track to an error with the offset of its bytes.
pub(super) fn beyond([_, _, clips, _, rows]: &[Range<usize>; 5], error: TrackError) -> PackedError {
    let (offset, what) = match error {
        TrackError::Entry(entry) => (rows.start + 2 * entry, "a track has keys that are not there"),
        TrackError::Clip(clip) => {
            (clips.start + 16 * clip, "a clip has no such frames, keys or row")
        }
    };
    PackedError::Bytes { offset, what }
}

/// Returns 1 if the clip loops, otherwise 0; and the number of pieces into which packing has
/// divided each step between its frames.
fn loops_and_pieces(timing: &PackedTiming) -> [u32; 2] {
    let both = word(timing, 2).unwrap_or_default();
    [both & 0xffff, both >> 16]
}

/// Returns `true` if these bytes can be the timing of a clip with `frames` frames in the file.
fn is_timing(timing: &PackedTiming, frames: u32) -> bool {
    let ([rate, rest], [loops, pieces]) = (rate(timing), loops_and_pieces(timing));
    let whole = matches!(pieces, 1..=4) && frames.wrapping_sub(1).is_multiple_of(pieces);
    // In a valid file the rounding error is so small that adding it to the rounded rate changes
    // nothing.
    is_rate(rate) && rate + rest == rate && loops < 2 && whole
}

/// Returns `true` if a clip can be played at this rate in frames a second.
pub(super) fn is_rate(rate: f32) -> bool {
    rate.is_finite() && rate > 0.0
}

fn floats(rest: &Rest) -> [f32; 4] {
    core::array::from_fn(|i| word(rest, i).map_or(0.0, f32::from_bits))
}

impl Sealed for PackedClips<'_> {}
impl<'s, R: Scalar> Keys<'s, R, 7> for PackedClips<'s> {
    type Place = TrackPlace;
    type Placed = Playback<'s>;
    fn placed(self, places: &'s [TrackPlace]) -> Result<Playback<'s>, ShapeError> {
        let placed = self.tracks.placed(places);
        let tracks = placed.map_err(|instance| ShapeError::NoPlace { instance })?;
        Ok(Playback { tracks, rests: self.rests })
    }
}

/// Packed clips, with a place for each instance.
#[derive(Clone, Copy)]
pub struct Playback<'s> {
    tracks: PlacedTracks<'s, 's>,
    rests: &'s [Rest],
}

brief!([] Playback<'_>: Playback |it| { joints: it.rests.len() });

impl Playback<'_> {
    /// Interpolates a column for the lanes of a slot. Column j is the rotation of joint j, and
    /// column J + j its translation, where J is the number of joints.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn between<L: Lanes>(
        self,
        level: L::Level,
        slot: JointSlot,
        column: usize,
        t: L,
    ) -> Option<[L; 4]> {
        if slot.lanes_are_joints() {
            self.tracks.between_columns(level, slot.instance(), column, t)
        } else {
            self.tracks.between(level, slot.instance(), column, t)
        }
    }

    /// Loads the rest positions and steps of the joints in the lanes. The second result is `true`
    /// if a clip translates any of these joints.
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn rest<L: Lanes<Real: Scalar>>(
        self,
        level: L::Level,
        slot: JointSlot,
    ) -> Option<([L; 4], bool)> {
        let rests = self.rests.get(slot.joint()..)?;
        if !slot.lanes_are_joints() {
            let rest = floats(rests.first()?);
            return Some((vector::splat(level, rest.map(Into::into)), rest[3] != 0.0));
        }
        let copied;
        let records = match as_they_lie(rests) {
            Some(records) => records,
            None => {
                copied = copy(rests);
                &copied
            }
        };
        let rest = L::load_records(level, records, [L::Real::default(); 4]);
        Some((rest, !rest[3].eq(L::splat(level, L::Real::default())).all()))
    }
}

/// Returns rest records (x, y, z and a step) as arrays of `R` without a copy. Returns `None` if `R`
/// is not `f32`, the target is not little-endian, or the bytes are not aligned.
#[cfg_attr(not(opt_level_0), inline(always))]
fn as_they_lie<R: Scalar>(rests: &[Rest]) -> Option<&[[R; 4]]> {
    let same = R::SINGLE && cfg!(target_endian = "little");
    if same { bytemuck::try_cast_slice(rests).ok() } else { None }
}

/// Converts rest records to arrays of `R`, for at most as many joints as there are lanes.
#[cold]
#[inline(never)]
fn copy<R: Scalar>(rests: &[Rest]) -> [[R; 4]; MAX_LANES] {
    let mut numbers = [[R::default(); 4]; MAX_LANES];
    for (numbers, rest) in numbers.iter_mut().zip(rests) {
        *numbers = floats(rest).map(Into::into);
    }
    numbers
}

impl<R: Scalar> KeysAt<R, 7> for Playback<'_> {
    fn joints(self) -> usize {
        self.rests.len()
    }
    #[cfg_attr(not(opt_level_0), inline(always))]
    fn pose<L: Lanes<Real = R>, W: Law<7>>(
        self,
        level: L::Level,
        _: W,
        slot: JointSlot,
        t: L,
    ) -> Option<[L; 7]> {
        if !slot.lanes_are_joints() {
            // The keys of the next instances are prefetched.
            let last = slot.joint() + 1 == self.rests.len();
            self.tracks.prefetch(level, slot.instance() + L::LANES, L::LANES, slot.joint(), last);
        }
        // The rest position is loaded first. If it were loaded after the interpolation, the
        // compiler would spill the interpolated rotation to the stack.
        let ([mut i, mut j, mut k, step], moves) = self.rest(level, slot)?;
        let [x, y, z, w] = unit(self.between(level, slot, slot.joint(), t)?, t);
        if moves {
            let [a, b, c, _] = self.between(level, slot, self.rests.len() + slot.joint(), t)?;
            [i, j, k] = [a.mul_add(step, i), b.mul_add(step, j), c.mul_add(step, k)];
        }
        Some([x, y, z, w, i, j, k])
    }
    fn part(self, instances: Range<usize>) -> Self {
        Self { tracks: self.tracks.part(instances), ..self }
    }
}

/// Normalizes the mean of two keys of rotations. Neighbouring keys are less than 60° apart, so the
/// squared length 1 − e of the mean is near 1, and a polynomial of e gives (1 − e)^(−½)
/// without root and division, with a relative error of 5.5·10⁻⁸ (minimax of degree 3 on
/// [−0.0005, 0.068]). The result is NaN if `t` is NaN. The other interpolations cannot share this
/// code, because here the weights of the mean are integers.
#[cfg_attr(not(opt_level_0), inline(always))]
fn unit<L: Lanes>([x, y, z, w]: [L; 4], t: L) -> [L; 4] {
    const SCALE: f64 = 1.0 / (ONE * 16384.0);
    let squares = w.mul_add(w, z * z) + y.mul_add(y, x * x);
    let e = squares.neg_mul_add(x.constant(SCALE * SCALE), x.constant(1.0));
    let s = e.mul_add(
        x.constant(0.352_827_324_646_670_27 * SCALE),
        x.constant(0.373_259_541_391_523_73 * SCALE),
    );
    let s = e.mul_add(s, x.constant(0.500_023_260_882_921 * SCALE));
    let s = e.mul_add(s, x.constant(0.999_999_958_052_565_9 * SCALE));
    let s = L::select(t.eq(t), s, t);
    [x * s, y * s, z * s, w * s]
}

errors! {
    /// Frames that cannot be packed, or bytes that are not a packed clip file.
    #[derive(Clone, Debug, PartialEq)]
    #[cfg_attr(feature = "defmt", derive(defmt::Format))]
    PackedError {
        /// The number of keys is not a multiple of the number of joints.
        Shape(error: ShapeError) => "{error}";
        /// A rotation is not unit, or not finite.
        NotUnit {
            clip: usize = "The clip.",
            frame: usize = "The frame.",
            joint: usize = "The joint.",
            length: f64 = "The length of its quaternion."
        }
            => "joint {joint} in frame {frame} of clip {clip} has a rotation of length {length}, not 1";
        /// The rate of a clip in frames a second is not a positive number.
        Rate { clip: usize = "The clip.", rate: f64 = "Its frames a second." }
            => "clip {clip} has {rate} frames a second, which must be a positive number that `f32` holds";
        /// A component of a translation is not finite, or differs from that of another frame by
        /// more than `f32` holds.
        Beyond {
            clip: usize = "The clip.",
            frame: usize = "The frame.",
            joint: usize = "The joint.",
            value: f32 = "The number."
        }
            => "joint {joint} in frame {frame} of clip {clip} is at {value}, which no range of translations holds";
        /// There are more keys than 32 bits count, or more tracks than 15 bits count.
        TooLarge => "the clips have more keys than 32 bits count, or more tracks than 15 bits count";
        /// The bytes are not a packed clip file of this version.
        Bytes { offset: usize = "The first byte that is wrong.", what: &'static str = "A phrase that says what is wrong there." }
            => "not a packed clip file: {what} at byte {offset}";
    }
}
