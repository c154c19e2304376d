//! [`PackedClip`]: packed clips that own their bytes, the packing of frames, and the measurement of
//! the error that packing causes.

use super::clip::{Clip, Timing};
use super::locals::RotationsTranslations;
use super::packed_clips::{self as form, ONE, PackedClips, PackedTiming};
use super::{Hierarchy, PackedError, Sampled};
use crate::law::{Law, NlerpLerp};
use crate::macros::brief;
use crate::number::Real;
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, same_length};
use crate::storage::{Aos, Element};
use alloc::borrow::Cow;
use alloc::boxed::Box;
use alloc::collections::BTreeMap;
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;
use dq8_simd::internal::OwnedTracks;

/// A rotation and a translation: `[x, y, z, w, tx, ty, tz]`.
type Key = [f32; 7];

/// Packed clips of one skeleton, with their bytes: the owned form of [`PackedClips`].
///
/// ```
/// use dq8::hierarchy::{Clip, PackedClip, Sampled, Tolerance};
/// use dq8::{DualQuat, Hierarchy, Quat, law::NlerpLerp, representation::RotationTranslation};
/// let parents = [Hierarchy::ROOT, 0];
/// let arm = Hierarchy::new(&parents)?;
/// // Three frames of two joints: the shoulder turns, the elbow stays one unit from it.
/// let about_z = |angle| Quat::from_axis_angle([0.0, 0.0, 1.0], angle);
/// let frames: Vec<_> = [0.0, 0.5, 1.0].into_iter().flat_map(|angle: f32| [
///     RotationTranslation { rotation: about_z(angle), translation: [0.0; 3] },
///     RotationTranslation { rotation: Quat::IDENTITY, translation: [1.0, 0.0, 0.0] },
/// ]).collect();
/// let wave = PackedClip::new(Clip::new(2, &frames)?.with_rate(10.0), Tolerance::default())?;
/// let clips = wave.clips();
/// assert_eq!((clips.frames(0), clips.moving(0)), (Some(3), Some(1)));
/// assert_eq!(clips.duration(0), Some(0.2));
/// assert!(wave.deviation(&arm, 0, &frames, 0.1)?.worst < 1e-4);
///
/// // Two instances, 0.05 and 0.2 seconds after the first frame.
/// let placed = [0.05_f32, 0.2].iter().filter_map(|&at| clips.place(0, at));
/// let (places, t): (Vec<_>, Vec<_>) = placed.unzip();
/// let mut models = [DualQuat::IDENTITY; 2 * 2];
/// arm.job().locals_to_model(Sampled::new(NlerpLerp, clips, &places, &t)?, &mut models)?;
/// assert!((models[1].translation()[0] - 0.25_f32.cos()).abs() < 1e-4);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct PackedClip {
    tracks: OwnedTracks,
    rests: Range<usize>,
    timings: Range<usize>,
}

brief!([] PackedClip: PackedClip |it| {
    joints: it.clips().joints(), clips: it.clips().clips(), bytes: it.as_bytes().len(),
});

/// The limits of packing: a track of a clip whose frames all lie within its limit of the first
/// frame is kept as a single key, that of the first frame.
///
/// A frame of such a track is off by at most its limit plus the error of a key, which
/// [`PackedClip::library`] states. A joint that moves along no axis by more than `length` in all
/// clips has no key for its translation, but the middle of its box, and is off by half of `length`
/// along each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// The limit for a rotation track, an angle in radians. The default is 2·10⁻⁵, which is
    /// less than the error of a key of 16 bits. An angle a is measured as 4 sin(a/4), which is
    /// 0.1 % less than 0.3 radians.
    pub angle: f32,
    /// The limit for a translation track, a length along each axis in the unit of translations. The
    /// default is 10⁻⁵; in metres this is a hundredth of a millimetre.
    pub length: f32,
}

impl Default for Tolerance {
    fn default() -> Self {
        Self { angle: 2e-5, length: 1e-5 }
    }
}

/// The error of packing: statistics of the distances by which packing displaces points that are
/// fixed to joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// The greatest distance of all points.
    pub worst: f64,
    /// The distance that 99 of 100 points do not exceed (the 99th percentile).
    pub p99: f64,
}

impl PackedClip {
    /// Packs one clip of rotations and translations, which are
    /// [`RotationTranslation`](crate::representation::RotationTranslation) or
    /// `[x, y, z, w, tx, ty, tz]`, and keeps the clip's rate and its looping. If a joint turns
    /// by 60° or more from one frame to the next, each step of the clip is divided by inserted
    /// frames, at most three, so that no joint turns by 60° in one step. The inserted frames are
    /// those that [`NlerpLerp`] plays.
    ///
    /// # Errors
    /// If a rotation is not unit or a translation is not finite; the error has the joint and the
    /// frame. Also if the rate is not positive.
    pub fn new<K: Element<7, Layout = Aos<f32>>>(
        clip: Clip<'_, K>,
        tolerance: Tolerance,
    ) -> Result<Self, PackedError> {
        Self::library(&[clip], tolerance)
    }

    /// Packs many clips of one skeleton. The clips share one scale of translations for each joint,
    /// whose step is 1/65534 of the longest side of the box in which the joint moves in all clips.
    /// A root that walks far is better left out of the clips and given as the root of a job.
    ///
    /// At frames, a rotation is off by at most 5.4·10⁻⁵ radians, and a translation along each
    /// axis by half a step and the rounding of `f32`. Tracks that are kept as a single key are off
    /// by up to the limit of their [`Tolerance`] more.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new); if `clips` is empty, or a clip has another number of
    /// joints than the first; or if there are more keys or joints than the format can count.
    pub fn library<K: Element<7, Layout = Aos<f32>>>(
        clips: &[Clip<'_, K>],
        tolerance: Tolerance,
    ) -> Result<Self, PackedError> {
        let joints = clips.first().ok_or(ShapeError::Empty { what: "clips" })?.joints;
        let given: Vec<&[Key]> =
            clips.iter().map(|clip| K::plain(clip.keys).unwrap_or_default()).collect();
        let mut timings = Vec::new();
        let mut finer = Vec::new();
        for (number, (clip, keys)) in clips.iter().zip(&given).enumerate() {
            same_length("each frame of a clip", clip.joints, joints)?;
            let Timing { rate, loops, .. } = clip.timing;
            if !form::is_rate(Real::from_f64(rate)) {
                return Err(PackedError::Rate { clip: number, rate });
            }
            let pieces = pieces(number, keys, joints)?;
            finer.push(finer_frames(keys, joints, pieces));
            timings.extend(packed_timing(rate, loops, pieces));
        }
        let rests: Vec<_> =
            (0..joints).map(|j| rest(&given, joints, j, tolerance)).collect::<Result<_, _>>()?;
        let (mut keys, mut heads) = (Vec::<[i16; 4]>::new(), Vec::new());
        let (mut rows, mut known) = (Vec::<u8>::new(), BTreeMap::new());
        for frames in &finer {
            let tracks = (0..2 * joints)
                .map(|column| track(frames, joints, column, &rests, tolerance))
                .collect::<Vec<_>>();
            // The tracks with one key come first. Then, frame by frame, come the keys of the moving
            // tracks, joint by joint as the sampler reads them, so that it reads each frame from
            // end to end.
            let ordered = || (0..joints).flat_map(|joint| [joint, joints + joint]);
            let long = |&column: &usize| tracks[column].len() > 1;
            let moving: Vec<_> = ordered().filter(long).collect();
            let still: Vec<_> = ordered().filter(|&column| tracks[column].len() == 1).collect();
            // A joint that no clip translates has no key for its translation, and its entry
            // stays 0. The sampler reads some key by this entry, and multiplies it by the joint's
            // step, which is 0.
            let mut row = vec![0; 2 * joints];
            for (place, &column) in still.iter().chain(&moving).enumerate() {
                let entry = u16::try_from(2 * place + usize::from(long(&column)));
                row[column] = entry.map_err(|_| PackedError::TooLarge)?;
            }
            let (next, count) = (known.len(), frames.len() / joints);
            let number = *known.entry(row).or_insert_with_key(|row| {
                rows.extend(row.iter().flat_map(|entry| entry.to_le_bytes()));
                next
            });
            heads.extend([keys.len(), count, moving.len(), number]);
            keys.extend(still.iter().map(|&column| tracks[column][0]));
            keys.extend(
                (0..count)
                    .flat_map(|frame| moving.iter().map(move |&c| (frame, c)))
                    .map(|(frame, c)| tracks[c][frame]),
            );
        }
        let words = |numbers: &[usize]| -> Result<Vec<u8>, PackedError> {
            let word = |&number| u32::try_from(number).map(u32::to_le_bytes);
            let words: Result<Vec<_>, _> = numbers.iter().map(word).collect();
            Ok(words.map_err(|_| PackedError::TooLarge)?.concat())
        };
        let mut bytes = form::MAGIC.to_vec();
        bytes.extend(words(&[
            form::VERSION as usize,
            joints,
            clips.len(),
            keys.len(),
            known.len(),
            0,
        ])?);
        bytes.extend(keys.iter().flatten().flat_map(|number: &i16| number.to_le_bytes()));
        bytes.extend(rests.iter().flatten().flat_map(|number| number.to_le_bytes()));
        bytes.extend(words(&heads)?);
        bytes.extend(timings);
        bytes.extend(rows);
        Self::from_bytes(bytes.into())
    }

    /// Returns a number of bytes that the file of these clips does not exceed: the length of the
    /// file if every joint moved in every clip. This is far quicker than packing, because it only
    /// looks for steps that must be divided.
    ///
    /// # Errors
    /// If a rotation is not unit, a rate is not finite and more than zero, a clip has another
    /// number of joints than the first, there is no clip, or the number does not fit into a
    /// `usize`.
    pub fn bound<K: Element<7, Layout = Aos<f32>>>(
        clips: &[Clip<'_, K>],
    ) -> Result<usize, PackedError> {
        let joints = clips.first().ok_or(ShapeError::Empty { what: "clips" })?.joints;
        // In 64 bits: on a smaller machine the bound may not fit, even where the file does.
        let (tracks, mut keys) = (2 * joints as u64, 0);
        for (number, clip) in clips.iter().enumerate() {
            same_length("each frame of a clip", clip.joints, joints)?;
            let rate = clip.timing.rate;
            if !form::is_rate(Real::from_f64(rate)) {
                return Err(PackedError::Rate { clip: number, rate });
            }
            let given: &[Key] = K::plain(clip.keys).unwrap_or_default();
            let steps = (given.len() / joints).saturating_sub(1);
            keys += (steps as u64 * u64::from(pieces(number, given, joints)?) + 1) * tracks;
        }
        let each = 4 * size_of::<u32>() + size_of::<PackedTiming>() + 2 * joints * size_of::<u16>();
        let head = form::MAGIC.len() + 6 * size_of::<u32>() + joints * size_of::<[f32; 4]>();
        let bytes = keys * size_of::<[i16; 4]>() as u64 + (head + clips.len() * each) as u64;
        usize::try_from(bytes).map_err(|_| PackedError::TooLarge)
    }

    /// Takes packed clips from the bytes of [`as_bytes`](Self::as_bytes). All bytes are read once,
    /// to check them.
    ///
    /// # Errors
    /// If the bytes are not a packed clip file; the error has the first offset of a fault.
    pub fn from_bytes(bytes: Box<[u8]>) -> Result<Self, PackedError> {
        PackedClips::from_bytes(&bytes)?;
        let (ranges, joints) = form::parts(&bytes)?;
        let [keys, rests, clips, timings, rows] = ranges.clone();
        let tracks = OwnedTracks::new(bytes, [keys, clips, rows], 2 * joints);
        Ok(Self { tracks: tracks.map_err(|at| form::beyond(&ranges, at))?, rests, timings })
    }

    /// The bytes of the packed clip file, which are the same on every target.
    #[must_use]
    pub fn as_bytes(&self) -> &[u8] {
        self.tracks.bytes()
    }

    /// Borrows the clips; their bytes were checked when `self` was made.
    #[must_use]
    pub fn clips(&self) -> PackedClips<'_> {
        let part = |range: &Range<usize>| self.as_bytes().get(range.clone()).unwrap_or_default();
        PackedClips {
            tracks: self.tracks.borrowed(),
            rests: part(&self.rests).as_chunks().0,
            timings: part(&self.timings).as_chunks().0,
        }
    }

    /// Measures the error of packing a clip. Three points are fixed to each joint, one on each axis
    /// at the distance `distance` from the joint. The function compares the positions in model
    /// space that the packed clip gives to these points with those that `frames` gives, at the
    /// frames but not between them.
    ///
    /// # Errors
    /// If there is no such clip, or it was packed from another number of frames, or the hierarchy
    /// has another number of joints.
    pub fn deviation<K: Element<7, Layout = Aos<f32>>>(
        &self,
        hierarchy: &Hierarchy<'_>,
        clip: usize,
        frames: &[K],
        distance: f64,
    ) -> Result<Deviation, ShapeError> {
        let (clips, frames) = (self.clips(), K::plain(frames).unwrap_or_default());
        let (count, pieces) = (clips.frames(clip).unwrap_or(0), clips.pieces(clip).unwrap_or(1));
        same_length("frames", frames.len(), count * clips.joints())?;
        let timing = Timing { frames: (count.max(1) - 1) * pieces + 1, rate: 1.0, loops: false };
        let at = (0..count).filter_map(|frame| {
            let (frame, t) = timing.place((frame * pieces) as f64);
            Some((clips.tracks.place(clip, frame)?, t))
        });
        let (places, t): (Vec<_>, Vec<_>) = at.unzip();
        let exact: Vec<_> = frames.iter().map(|key| key.map(f64::from)).collect();
        let mut models = vec![DualQuat::<f64>::IDENTITY; frames.len()];
        let mut wanted = models.clone();
        hierarchy.job().locals_to_model(RotationsTranslations(&exact), &mut wanted)?;
        hierarchy
            .job()
            .locals_to_model(Sampled::new(NlerpLerp, clips, &places, &t)?, &mut models)?;
        let points =
            [0, 1, 2].map(|axis| core::array::from_fn(|i| if i == axis { distance } else { 0.0 }));
        let moved = |(a, b): (&DualQuat<f64>, &DualQuat<f64>)| {
            points
                .map(|point| length(difference(a.transform_point(point), b.transform_point(point))))
        };
        let mut distances: Vec<_> = models.iter().zip(&wanted).flat_map(moved).collect();
        distances.sort_unstable_by(f64::total_cmp);
        let at = |share| {
            distances
                .get(distances.len() * share / 100)
                .or(distances.last())
                .copied()
                .unwrap_or(0.0)
        };
        Ok(Deviation { worst: at(100), p99: at(99) })
    }
}

/// Encodes the timing of a clip for [`PackedClips`]: its rate in frames a second, whether it loops,
/// and the number of pieces into which each of its steps is divided.
fn packed_timing(rate: f64, loops: bool, pieces: u16) -> PackedTiming {
    let single = <f32 as Real>::from_f64(rate);
    let rest = <f32 as Real>::from_f64(rate - f64::from(single));
    let words = [single.to_bits(), rest.to_bits(), u32::from(loops) | u32::from(pieces) << 16];
    bytemuck::must_cast(words.map(u32::to_le_bytes))
}

/// The numbers of pieces into which packing divides a turn, each with the least cosine of half the
/// turn's angle: one piece up to 59.8°, two up to 119.6°, three up to 154.6°, otherwise four. So
/// each piece turns by less than 60°. Normalized means turn fastest in the middle, so a middle
/// piece is the longest of n pieces. If φ is the angle between the quaternions, this piece has the
/// angle 2 atan(tan(φ/2)/n) if n is odd, and atan(2 tan(φ/2)/n) if n is even.
const PIECES: [(u16, f64); 3] = [(1, 0.8669), (2, 0.5031), (3, 0.2199)];

/// Returns the number of pieces into which every step of a clip must be divided so that no joint
/// turns by 60° or more in one piece.
fn pieces(clip: usize, frames: &[Key], joints: usize) -> Result<u16, PackedError> {
    let mut most = 1;
    for joint in 0..joints {
        let mut before = None;
        for (frame, &[x, y, z, w, ..]) in frames.iter().skip(joint).step_by(joints).enumerate() {
            let turn = [x, y, z, w].map(f64::from);
            let length = Real::sqrt(dot(turn, turn));
            if length.is_nan() || (length - 1.0).abs() > 1e-3 {
                return Err(PackedError::NotUnit { clip, frame, joint, length });
            }
            let unit = turn.map(|c| c / length);
            let cosine = before.map_or(1.0, |before| dot(before, unit).abs());
            let enough = PIECES.iter().find(|(_, least)| cosine >= *least);
            most = most.max(enough.map_or(4, |&(pieces, _)| pieces));
            before = Some(unit);
        }
    }
    Ok(most)
}

/// Divides each step between frames into `pieces` pieces, by inserting frames that [`NlerpLerp`]
/// interpolates.
fn finer_frames(frames: &[Key], joints: usize, pieces: u16) -> Cow<'_, [Key]> {
    if pieces == 1 {
        return frames.into();
    }
    let last = frames.get(frames.len() - joints..).unwrap_or_default();
    let finer = frames.chunks(joints).zip(frames.chunks(joints).skip(1)).flat_map(|(a, b)| {
        (0..pieces).flat_map(move |piece| {
            let t = f64::from(piece) / f64::from(pieces);
            let exact = |key: &Key| key.map(f64::from);
            let between = move |(a, b)| NlerpLerp.between(exact(a), exact(b), t);
            a.iter().zip(b).map(move |keys| between(keys).map(<f32 as Real>::from_f64))
        })
    });
    finer.chain(last.iter().copied()).collect()
}

/// Returns the middle of the box in which a joint moves in all clips, and 2⁻¹⁴ times the step
/// of its translations (the step is the length that 1 in a key stands for). The step is 0 if no
/// side of the box is longer than the tolerance.
fn rest(
    clips: &[&[Key]],
    joints: usize,
    joint: usize,
    tolerance: Tolerance,
) -> Result<[f32; 4], PackedError> {
    let (mut least, mut most) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for (clip, frames) in clips.iter().enumerate() {
        for (frame, [.., x, y, z]) in frames.iter().skip(joint).step_by(joints).enumerate() {
            for (axis, &value) in [x, y, z].into_iter().enumerate() {
                (least[axis], most[axis]) = (least[axis].min(value), most[axis].max(value));
                if !(value.is_finite() && (most[axis] - least[axis]).is_finite()) {
                    return Err(PackedError::Beyond { clip, frame, joint, value });
                }
            }
        }
    }
    let sides: [f32; 3] = core::array::from_fn(|axis| most[axis] - least[axis]);
    let [x, y, z] = core::array::from_fn(|axis| least[axis] + sides[axis] / 2.0);
    let longest = sides.into_iter().fold(0.0, f32::max);
    // No side is within a limit that is NaN.
    Ok([x, y, z, if longest <= tolerance.length { 0.0 } else { longest / (65534.0 * 16384.0) }])
}

/// Returns the keys of a column (the rotation or the translation of a joint): a key for each frame,
/// a single key if the track stays within the tolerance, or no key for the translation of a joint
/// that no clip translates.
fn track(
    frames: &[Key],
    joints: usize,
    column: usize,
    rests: &[[f32; 4]],
    tolerance: Tolerance,
) -> Vec<[i16; 4]> {
    let joint = column % joints;
    let own = || frames.iter().skip(joint).step_by(joints);
    if column >= joints {
        let [x, y, z, step] = rests[joint];
        let first = own().next().map_or([0.0; 3], translation);
        let still = own().all(|key| {
            (0..3).all(|i| (translation(key)[i] - first[i]).abs() <= f64::from(tolerance.length))
        });
        let keys = own()
            .take(if step == 0.0 {
                0
            } else if still {
                1
            } else {
                usize::MAX
            })
            .map(|key| {
                let steps = difference(translation(key), [x, y, z].map(f64::from))
                    .map(|c| c / (f64::from(step) * 16384.0));
                let [x, y, z] = steps.map(round);
                [x, y, z, 0]
            });
        return keys.collect();
    }
    let mut keys: Vec<[i16; 4]> = Vec::new();
    let (mut before, mut still) = (None, true);
    for &[x, y, z, w, ..] in own() {
        let exact = [x, y, z, w].map(f64::from);
        let norm = Real::sqrt(dot(exact, exact));
        // The sign is chosen so that the key has no negative scalar product with the key before it.
        let dots = keys.last().map_or(1.0, |last| dot(last.map(f64::from), exact));
        let unit = exact.map(|c| c.copysign(c * dots) / norm);
        // The distance between two unit quaternions is about half of the angle between their
        // rotations.
        let first = *before.get_or_insert(unit);
        let chord: [f64; 4] = core::array::from_fn(|i| unit[i] - first[i]);
        still &= 2.0 * Real::sqrt(dot(chord, chord)) <= f64::from(tolerance.angle);
        keys.push(nearest(unit));
    }
    keys.truncate(if still { 1 } else { usize::MAX });
    keys
}

/// Returns the key whose direction is nearest to that of a unit quaternion. The length of a key has
/// no meaning, so the function tries several lengths a little below 32767, from which the direction
/// is rounded best.
///
/// The bound of the error: lengths differ by 0.1875, and the largest number by no more, so that one
/// of the lengths brings this number within 3/32 of an integer. The other three are off by at most
/// 1/2. So the angle of the rotation is off by at most 2 √(3/4 + 9/1024) / 32764.19 =
/// 5.32·10⁻⁵.
fn nearest(unit: [f64; 4]) -> [i16; 4] {
    let key = |turn: u8| unit.map(|c| round((ONE - 0.1875 * f64::from(turn)) * c));
    let off = |key: [i16; 4]| {
        let key = key.map(f64::from);
        let along = dot(key, unit);
        dot(key, key) - along * along
    };
    let better = |a, b| if off(b) < off(a) { b } else { a };
    (1..16).map(key).fold(key(0), better)
}

#[allow(clippy::cast_possible_truncation, reason = "saturates")]
fn round(number: f64) -> i16 {
    // The conversion truncates, so adding a half rounds to the nearest integer, and ties away from
    // zero. The method `round` would need std.
    (number + 0.5_f64.copysign(number)) as i16
}

fn translation(&[.., x, y, z]: &Key) -> [f64; 3] {
    [x, y, z].map(f64::from)
}

fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|i| a[i] - b[i])
}

fn length(a: [f64; 3]) -> f64 {
    Real::sqrt(dot(a, a))
}
