//! [`PackedClip`]: packed clips that own their bytes; how they are made of frames, and what they keep of them.

use super::locals::RotationsTranslations;
use super::packed_clips::{self as form, ONE, PackedClips, neighbours};
use super::{Hierarchy, PackedError, Sampled};
use crate::brief::brief;
use crate::law::NlerpLerp;
use crate::number::Real;
use crate::scalar::DualQuat;
use crate::storage::shape::{ShapeError, same_length, whole_instances};
use crate::storage::{Aos, Element};
use alloc::boxed::Box;
use alloc::collections::BTreeMap;
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;
use dq8_simd::OwnedTracks;

/// `[x, y, z, w, tx, ty, tz]`
type Key = [f32; 7];

/// Packed clips of one skeleton, with their bytes: [`PackedClips`] says what they are.
///
/// ```
/// use dq8::hierarchy::{PackedClip, Sampled, Tolerance};
/// use dq8::{DualQuat, Hierarchy, Quat, law::NlerpLerp, representation::RotationTranslation};
/// let parents = [Hierarchy::ROOT, 0];
/// let arm = Hierarchy::new(&parents)?;
/// // Three frames of two joints: the shoulder turns, the elbow stays one unit from it.
/// let about_z = |angle| Quat::from_axis_angle([0.0, 0.0, 1.0], angle);
/// let frames: Vec<_> = [0.0, 0.5, 1.0].into_iter().flat_map(|angle: f32| [
///     RotationTranslation { rotation: about_z(angle), translation: [0.0; 3] },
///     RotationTranslation { rotation: Quat::IDENTITY, translation: [1.0, 0.0, 0.0] },
/// ]).collect();
/// let wave = PackedClip::new(2, &frames, Tolerance::default())?;
/// assert_eq!((wave.clips().frames(0), wave.clips().moving(0)), (Some(3), Some(1)));
/// assert!(wave.deviation(&arm, 0, &frames, 0.1)?.worst < 1e-4);
///
/// // Two instances, at frames 0.5 and 2.
/// let clips = wave.clips();
/// let (places, t): (Vec<_>, Vec<_>) = [0.5_f32, 2.0].iter().filter_map(|&at| clips.place(0, at)).unzip();
/// let mut models = [DualQuat::IDENTITY; 2 * 2];
/// arm.job().locals_to_model(Sampled::new(NlerpLerp, clips, &places, &t)?, &mut models)?;
/// assert!((models[1].translation()[0] - 0.25_f32.cos()).abs() < 1e-4);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct PackedClip {
    tracks: OwnedTracks,
    rests: Range<usize>,
}

brief!([] PackedClip: PackedClip |it| {
    joints: it.clips().joints(), clips: it.clips().clips(), bytes: it.as_bytes().len(),
});

/// What a track may move in a clip and still be kept as one key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// In radians. 2·10⁻⁵ unless told otherwise: less than a key of 16 bits holds.
    pub angle: f32,
    /// In the unit of the translations. 10⁻⁵ unless told otherwise, a hundredth of a millimetre in metres.
    pub length: f32,
}

impl Default for Tolerance {
    fn default() -> Self {
        Self { angle: 2e-5, length: 1e-5 }
    }
}

/// How far points that hang from joints are from where they were before clips were packed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// The greatest distance.
    pub worst: f64,
    /// 99 of 100 are no greater.
    pub p99: f64,
}

impl PackedClip {
    /// One clip of frames at equal distances, `[frame][joint]`: rotations and translations,
    /// [`RotationTranslation`](crate::representation::RotationTranslation) or `[x, y, z, w, tx, ty, tz]`.
    ///
    /// # Errors
    /// If there are no whole frames, or rotations are not unit, or turn by 60° or more from one frame to the next, or
    /// translations are not finite: which joint in which frame.
    pub fn new<K: Element<7, Layout = Aos<f32>>>(
        joints: usize,
        frames: &[K],
        tolerance: Tolerance,
    ) -> Result<Self, PackedError> {
        Self::library(joints, &[frames], tolerance)
    }

    /// Many clips of one skeleton, which share the range of each joint's translations: 1/65534 of the longest side of the
    /// box that it moves in is a step. A root that walks far is better kept apart, and given as the root of a job.
    ///
    /// # Errors
    /// As for [`new`](Self::new), or if there are more keys or joints than the form counts.
    pub fn library<K: Element<7, Layout = Aos<f32>>>(
        joints: usize,
        clips: &[&[K]],
        tolerance: Tolerance,
    ) -> Result<Self, PackedError> {
        let clips: Vec<&[Key]> =
            clips.iter().map(|clip| K::plain(clip).unwrap_or_default()).collect();
        for clip in &clips {
            if whole_instances("frames", joints, clip.len())? == 0 {
                return Err(ShapeError::Empty { what: "frames" }.into());
            }
        }
        let rests: Vec<_> =
            (0..joints).map(|j| rest(&clips, joints, j, tolerance)).collect::<Result<_, _>>()?;
        let (mut keys, mut heads) = (Vec::<[i16; 4]>::new(), Vec::new());
        let (mut rows, mut known) = (Vec::<u8>::new(), BTreeMap::new());
        for (clip, frames) in clips.iter().enumerate() {
            let tracks = (0..2 * joints)
                .map(|column| track(clip, frames, joints, column, &rests, tolerance))
                .collect::<Result<Vec<_>, _>>()?;
            // Constants, then row by row what moves, joint after joint as they are sampled: a row is read from end to end.
            let ordered = || (0..joints).flat_map(|joint| [joint, joints + joint]);
            let long = |&column: &usize| tracks[column].len() > 1;
            let moving: Vec<_> = ordered().filter(long).collect();
            let still: Vec<_> = ordered().filter(|&column| tracks[column].len() == 1).collect();
            // A joint that no clip moves has no key; its step is 0, whatever is read.
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
        bytes.extend(rows);
        Self::from_bytes(bytes.into())
    }

    /// Of bytes that [`as_bytes`](Self::as_bytes) gave. Reads all of them once.
    ///
    /// # Errors
    /// If they are no packed clips: where.
    pub fn from_bytes(bytes: Box<[u8]>) -> Result<Self, PackedError> {
        PackedClips::from_bytes(&bytes)?;
        let (ranges, joints) = form::parts(&bytes)?;
        let [keys, rests, clips, rows] = ranges.clone();
        let tracks = OwnedTracks::new(bytes, [keys, clips, rows], 2 * joints);
        Ok(Self { tracks: tracks.map_err(|at| form::beyond(&ranges, at))?, rests })
    }

    /// The bytes, the same on every target.
    #[must_use]
    pub fn as_bytes(&self) -> &[u8] {
        self.tracks.bytes()
    }

    /// The clips, not checked again.
    #[must_use]
    pub fn clips(&self) -> PackedClips<'_> {
        let rests = self.as_bytes().get(self.rests.clone()).unwrap_or_default();
        PackedClips { tracks: self.tracks.borrowed(), rests: rests.as_chunks().0 }
    }

    /// What became of the frames of a clip: of the points `distance` from each joint along its three axes, in model space,
    /// in every frame.
    ///
    /// # Errors
    /// If there is no such clip, or it has other frames, or the hierarchy other joints.
    pub fn deviation<K: Element<7, Layout = Aos<f32>>>(
        &self,
        hierarchy: &Hierarchy<'_>,
        clip: usize,
        frames: &[K],
        distance: f64,
    ) -> Result<Deviation, ShapeError> {
        let (clips, frames) = (self.clips(), K::plain(frames).unwrap_or_default());
        let count = clips.frames(clip).unwrap_or(0);
        same_length("frames", frames.len(), count * clips.joints())?;
        let at = (0..count).filter_map(|frame| clips.place(clip, frame as f64));
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

/// Where a joint rests, and 2⁻¹⁴ of a step of its translations.
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
    Ok([x, y, z, if longest > tolerance.length { longest / (65534.0 * 16384.0) } else { 0.0 }])
}

/// The keys of a column: one for each frame, or one if it stays; none for translations of a joint that never moves.
fn track(
    clip: usize,
    frames: &[Key],
    joints: usize,
    column: usize,
    rests: &[[f32; 4]],
    tolerance: Tolerance,
) -> Result<Vec<[i16; 4]>, PackedError> {
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
        return Ok(keys.collect());
    }
    let mut keys: Vec<[i16; 4]> = Vec::new();
    let (mut before, mut still) = (None, true);
    for (frame, &[x, y, z, w, ..]) in own().enumerate() {
        let exact = [x, y, z, w].map(f64::from);
        let norm = Real::sqrt(dot(exact, exact));
        if norm.is_nan() || (norm - 1.0).abs() > 1e-3 {
            return Err(PackedError::NotUnit { clip, frame, joint, length: norm });
        }
        // In the hemisphere of the key before.
        let dots = keys.last().map_or(1.0, |last| dot(last.map(f64::from), exact));
        let unit = exact.map(|c| c.copysign(c * dots) / norm);
        let key = nearest(unit);
        if let Some(&last) = keys.last()
            && !neighbours(last, key)
        {
            let degrees = 2.0 * Real::acos((dots.abs() / (ONE * norm)).min(1.0)).to_degrees();
            return Err(PackedError::TooFar { clip, frame, joint, degrees });
        }
        // A chord of quaternions is half of the angle.
        let first = *before.get_or_insert(unit);
        let chord: [f64; 4] = core::array::from_fn(|i| unit[i] - first[i]);
        still &= 2.0 * Real::sqrt(dot(chord, chord)) <= f64::from(tolerance.angle);
        keys.push(key);
    }
    keys.truncate(if still { 1 } else { usize::MAX });
    Ok(keys)
}

/// The key whose direction is nearest to that of a unit quaternion, of lengths a little below 32767: the length means
/// nothing, and some are rounded with half of the error.
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
    // Half away from zero, without the standard library.
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
