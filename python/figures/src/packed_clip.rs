//! Packed clips.

use crate::argument::{Argument, Input, is_single};
use crate::call::Answer;
use crate::error::{misshapen, value_error};
use crate::hierarchy::Hierarchy;
use crate::number::Number;
use crate::output::Output;
use crate::shape::{EIGHT, NUMBER};
use crate::threads::{GRAIN, Threads, whole};
use dq8::hierarchy::{self, PackedClips, Sampled, Tolerance};
use dq8::simd::MAX_LANES;
use dq8::{DualQuat, Real, ShapeError, law::NlerpLerp};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::Arc;

/// An animation clip in 8 bytes for each track that moves, and frame: 16 bits for each number of a
/// rotation or a translation; what keeps still is kept once.
///
/// Translations of a joint are steps of 2⁻¹⁶ of the longest side of the box in which it moves,
/// and off by half of that along each axis: a walk of a kilometre is kept to 8 mm, which
/// `max_error` refuses where it is too much. Rotations are off by 5.4·10⁻⁵ radians at most.
/// A rotation or a translation that is kept once is off by up to its limit more: `angle`, or
/// `length` along each axis.
///
/// Parameters
/// ----------
/// frames : array_like, shape (frames, joints, 8)
///     Unit dual quaternions at equal distances in time: the pose of each joint in its parent.
///     Where a joint turns by 60° or more from one frame to the next, all joints get one to three
///     frames between.
/// fps : float, optional
///     Frames a second: times are seconds. Without, times are frames.
/// loops : bool
///     Whether the clip begins again where it ends: its last frame is the first one once more.
/// angle, length : float
///     How far the rotations of a joint (in radians), or its translations along each axis, may be
///     from the first one and still be kept as one: they keep still, and are off by up to this
///     limit more. They bound nothing else.
/// max_error : float, optional
///     How far packing may move a joint in its parent at a frame, a length. ValueError names the
///     joint that is moved farthest, where that is farther: leave the way of a root out of
///     `frames`, and multiply it to what is sampled.
///
/// Raises
/// ------
/// ValueError
///     Where a rotation is not unit, or a number is not finite.
///
/// Examples
/// --------
/// >>> import dq8, numpy as np
/// >>> turns = dq8.from_twist(np.outer(np.arange(5), [0.3, 0, 0, 0, 0, 0]))[:, np.newaxis]
/// >>> clip = dq8.PackedClip(turns)
/// >>> clip.frames, clip.joints, clip.moving
/// (5, 1, 1)
/// >>> bool(dq8.angle_to(clip.sample(1.5)[0], dq8.from_twist([0.45, 0, 0, 0, 0, 0])) < 1e-4)
/// True
#[pyclass(frozen, module = "dq8")]
#[derive(Debug)]
pub struct PackedClip {
    packed: Arc<hierarchy::PackedClip>,
}

#[pymethods]
impl PackedClip {
    #[new]
    #[pyo3(signature = (frames, *, fps=1.0, loops=false, angle=2e-5, length=1e-5, max_error=None))]
    fn new(
        frames: &Bound<'_, PyAny>,
        fps: f64,
        loops: bool,
        angle: f32,
        length: f32,
        max_error: Option<f64>,
    ) -> PyResult<Self> {
        let limits = [("angle", "an angle", angle.into()), ("length", "a length", length.into())];
        let most = max_error.map(|most| ("max_error", "a length", most));
        for (name, kind, limit) in limits.into_iter().chain(most) {
            if limit.is_nan() || limit < 0.0 {
                let message = format!("Expected `{name}` to be {kind}, got {limit}.");
                return Err(PyValueError::new_err(message));
            }
        }
        let py = frames.py();
        let (keys, joints) = keys(frames)?;
        let packed = whole(py, move || {
            let clip = hierarchy::Clip::new(joints, &keys).map_err(|error| error.to_string())?;
            let clip = clip.with_rate(fps);
            let clip = if loops { clip.looping() } else { clip };
            let packed = hierarchy::PackedClip::new(clip, Tolerance { angle, length });
            let packed = packed.map_err(|error| error.to_string())?;
            max_error.map_or(Ok(()), |most| check_error(&packed, &keys, joints, fps, most))?;
            Ok::<_, String>(packed)
        })?;
        Ok(Self { packed: Arc::new(packed.map_err(value_error)?) })
    }

    /// A clip of bytes that `to_bytes` gave, or the example mocap of the Rust crate wrote.
    #[staticmethod]
    fn from_bytes(data: &[u8]) -> PyResult<Self> {
        let packed = hierarchy::PackedClip::from_bytes(data.into()).map_err(value_error)?;
        Ok(Self { packed: Arc::new(packed) })
    }

    /// The bytes of the clip, the same on every machine.
    fn to_bytes<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, self.packed.as_bytes())
    }

    /// The time from the first frame to the last, in seconds if the clip has a rate.
    #[getter]
    fn duration(&self) -> f64 {
        self.packed.clips().duration(0).unwrap_or(0.0)
    }

    /// True if the clip begins again where it ends.
    #[getter]
    fn loops(&self) -> bool {
        self.packed.clips().loops(0) == Some(true)
    }

    /// Frames a second; 1 if times are frames.
    #[getter]
    fn fps(&self) -> f64 {
        self.packed.clips().rate(0).unwrap_or(1.0)
    }

    /// How many frames there are.
    #[getter]
    fn frames(&self) -> usize {
        self.packed.clips().frames(0).unwrap_or(0)
    }

    /// How many joints there are.
    #[getter]
    fn joints(&self) -> usize {
        self.packed.clips().joints()
    }

    /// How many rotations and translations move; the others are kept once.
    #[getter]
    fn moving(&self) -> usize {
        self.packed.clips().moving(0).unwrap_or(0)
    }

    fn __repr__(&self) -> String {
        let bytes = self.packed.as_bytes().len();
        format!(
            "<PackedClip of {} frames of {} joints, {bytes} bytes>",
            self.frames(),
            self.joints()
        )
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyBytes>,))> {
        Ok((slf.get_type().getattr("from_bytes")?, (slf.get().to_bytes(slf.py()),)))
    }

    /// Poses of the joints in their parents at any times.
    ///
    /// Parameters
    /// ----------
    /// at : array_like, shape (...)
    ///     Times from the first frame, in seconds if the clip has a rate, otherwise in frames.
    ///     Beyond the clip are its ends, or other rounds if it loops. NaN is a ValueError.
    /// out : ndarray, optional
    ///     Where to write the result.
    ///
    /// Returns
    /// -------
    /// ndarray, shape (..., joints, 8)
    ///     Unit dual quaternions, float32 if `at` is float32, otherwise float64.
    #[pyo3(signature = (at, *, out=None))]
    fn sample<'py>(&self, at: &Bound<'py, PyAny>, out: Option<&Bound<'py, PyAny>>) -> Answer<'py> {
        let at = Argument::new("at", NUMBER, at)?;
        if is_single([&at]) { self.typed::<f32>(&at, out) } else { self.typed::<f64>(&at, out) }
    }

    /// How far points that hang from joints are from where they were, in model space: the greatest
    /// distance, and that which 99 of 100 do not pass.
    ///
    /// Parameters
    /// ----------
    /// hierarchy : Hierarchy
    ///     The skeleton.
    /// frames : array_like, shape (frames, joints, 8)
    ///     What was packed.
    /// distance : float
    ///     How far the points are from their joints, along each axis.
    ///
    /// Returns
    /// -------
    /// tuple of float
    fn deviation(
        &self,
        hierarchy: &Hierarchy,
        frames: &Bound<'_, PyAny>,
        distance: f64,
    ) -> PyResult<(f64, f64)> {
        let py = frames.py();
        let (keys, _) = keys(frames)?;
        let Some(skeleton) = hierarchy.in_order() else {
            let message = "Expected the parents of `hierarchy` to come before their children.";
            return Err(PyValueError::new_err(message));
        };
        let (packed, skeleton) = (Arc::clone(&self.packed), skeleton.clone());
        let off = whole(py, move || packed.deviation(&skeleton.hierarchy(), 0, &keys, distance))?;
        let off = off.map_err(value_error)?;
        Ok((off.worst, off.p99))
    }
}

impl PackedClip {
    fn typed<'py, R: Number>(
        &self,
        at: &Argument<'py>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> Answer<'py> {
        let at = Input::<R>::of(at)?;
        let (py, clips) = (at.py(), self.packed.clips());
        let full = [at.full_leading(), &[clips.joints()]].concat();
        let output = Output::<R>::new(py, out, &full, EIGHT)?;
        let at = at.in_full()?.apart_from(&output)?;
        let (times, joints) = (at.numbers(), clips.joints());
        // Infinite times are in no round of a clip that loops.
        let is_nowhere = |&at: &R| clips.place(0, at).is_none_or(|(_, t)| t.is_nan());
        let threads = Threads::for_elements(full.iter().product());
        output.fill(&threads, |to: &mut [[R; 8]]| {
            if let Some(index) = times.iter().position(is_nowhere) {
                let message = format!("`at`: sample {index} is asked for at {}.", times[index]);
                return Err(PyValueError::new_err(message));
            }
            let size = joints * GRAIN.div_ceil(joints.max(1)).next_multiple_of(MAX_LANES);
            let done = threads.split(size.max(1), to, &|(first, to)| {
                let first = first / joints.max(1);
                let times = times.get(first..first + to.len() / joints.max(1));
                sampled(clips, times.unwrap_or_default(), to).is_ok()
            });
            if done { Ok(()) } else { Err(PyRuntimeError::new_err("nothing was sampled")) }
        })
    }
}

/// The poses of all joints in their parents at some times.
fn sampled<R: Number>(
    clips: PackedClips<'_>,
    times: &[R],
    to: &mut [[R; 8]],
) -> Result<(), ShapeError> {
    // Each joint a root: its model is its pose.
    let apart = vec![dq8::Hierarchy::ROOT; clips.joints()];
    let Ok(hierarchy) = dq8::Hierarchy::new(&apart) else { return Ok(()) };
    let (places, t): (Vec<_>, Vec<_>) = times.iter().filter_map(|&at| clips.place(0, at)).unzip();
    // As motions, as `deviation` has them: one kernel for both.
    let to: &mut [DualQuat<R>] = bytemuck::must_cast_slice_mut(to);
    hierarchy.job().locals_to_model(Sampled::new(NlerpLerp, clips, &places, &t)?, to)
}

/// An error about the joint that packing moves farthest, where that is farther than `most`.
fn check_error(
    packed: &hierarchy::PackedClip,
    keys: &[[f32; 7]],
    joints: usize,
    fps: f64,
    most: f64,
) -> Result<(), String> {
    let mut worst = (0.0, 0);
    let mut poses = vec![[0.0; 8]; joints];
    let all = keys.chunks_exact(joints.max(1));
    // The last frame of a clip that loops is the first one.
    let count = all.len() - usize::from(packed.clips().loops(0) == Some(true));
    for (frame, keys) in all.take(count).enumerate() {
        sampled(packed.clips(), &[frame as f64 / fps], &mut poses).map_err(|it| it.to_string())?;
        for (joint, (pose, [.., x, y, z])) in poses.iter().zip(keys).enumerate() {
            let [a, b, c] = DualQuat::from_array(*pose).translation();
            let off = [a - f64::from(*x), b - f64::from(*y), c - f64::from(*z)];
            let off = <f64 as Real>::sqrt(off.iter().map(|off| off * off).sum());
            if off > worst.0 {
                worst = (off, joint);
            }
        }
    }
    let (off, joint) = worst;
    if off <= most {
        return Ok(());
    }
    Err(format!(
        "`max_error`: packing moves joint {joint} by up to {off:.2e}, more than {most:.2e}, because it goes far: leave \
         its way out of `frames` and multiply it to what is sampled"
    ))
}

/// Rotations and translations of frames, and how many joints each has.
fn keys(frames: &Bound<'_, PyAny>) -> PyResult<(Vec<[f32; 7]>, usize)> {
    let frames = Input::<f64>::of(&Argument::new("frames", EIGHT, frames)?)?;
    let joints = match *frames.full_leading() {
        [frames, joints] if frames > 0 && joints > 0 => joints,
        [_, _] => {
            let expected = "(frames, joints, 8) with a frame and a joint at least";
            return Err(misshapen("frames", expected, &frames.shape()));
        }
        _ => return Err(misshapen("frames", "(frames, joints, 8)", &frames.shape())),
    };
    let frames = frames.in_full()?;
    let key = |motion: &[f64; 8]| {
        let motion = DualQuat::from_array(*motion);
        let ([x, y, z, w], [a, b, c]) = (motion.rotation().to_array(), motion.translation());
        [x, y, z, w, a, b, c].map(<f32 as Real>::from_f64)
    };
    let (motions, threads) = (frames.records::<8>(), Threads::alone());
    let keys = threads.run(frames.py(), || {
        let mut keys = vec![[0.0; 7]; motions.len()];
        threads.split(GRAIN, &mut keys, &|(first, keys)| {
            keys.iter_mut().zip(&motions[first..]).for_each(|(to, motion)| *to = key(motion));
            true
        });
        Ok(keys)
    })?;
    Ok((keys, joints))
}
