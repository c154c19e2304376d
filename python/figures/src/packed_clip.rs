//! Packed clips.

use crate::argument::{Argument, Input, is_single};
use crate::call::Answer;
use crate::error::{misshapen, value_error};
use crate::hierarchy::Hierarchy;
use crate::number::Number;
use crate::output::Output;
use crate::shape::{EIGHT, NUMBER};
use crate::threads::Threads;
use dq8::hierarchy::{self, Sampled, Tolerance};
use dq8::{DualQuat, Real, law::NlerpLerp};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// An animation clip in 8 bytes for each track that moves, and frame: 16 bits for each number of a
/// rotation or a translation; what keeps still is kept once.
///
/// Parameters
/// ----------
/// frames : array_like, shape (frames, joints, 8)
///     Unit dual quaternions at equal distances in time: the pose of each joint in its parent.
///     Where a joint turns by 60° or more from one frame to the next, all joints get one to three
///     frames between.
/// rate : float, optional
///     Frames a second: times are seconds. Without, times are frames.
/// loops : bool
///     Whether the clip begins again where it ends: its last frame is the first one once more.
/// angle, length : float
///     What a rotation (in radians) and a translation may move and still be kept as one: they keep
///     still.
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
    packed: hierarchy::PackedClip,
}

#[pymethods]
impl PackedClip {
    #[new]
    #[pyo3(signature = (frames, *, rate=1.0, loops=false, angle=2e-5, length=1e-5))]
    fn new(
        frames: &Bound<'_, PyAny>,
        rate: f64,
        loops: bool,
        angle: f32,
        length: f32,
    ) -> PyResult<Self> {
        let (keys, joints) = keys(frames)?;
        let clip = hierarchy::Clip::new(joints, &keys).map_err(value_error)?.with_rate(rate);
        let clip = if loops { clip.looping() } else { clip };
        let packed = hierarchy::PackedClip::new(clip, Tolerance { angle, length });
        Ok(Self { packed: packed.map_err(value_error)? })
    }

    /// A clip of bytes that `to_bytes` gave, or the example mocap of the Rust crate wrote.
    #[staticmethod]
    fn from_bytes(data: &[u8]) -> PyResult<Self> {
        Ok(Self { packed: hierarchy::PackedClip::from_bytes(data.into()).map_err(value_error)? })
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
    fn rate(&self) -> f64 {
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
    ///     Beyond the clip are its ends, or other rounds if it loops; for NaN all numbers are NaN.
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
        let (keys, _) = keys(frames)?;
        let Some(skeleton) = hierarchy.in_order() else {
            let message = "Expected the parents of `hierarchy` to come before their children.";
            return Err(PyValueError::new_err(message));
        };
        let off = self
            .packed
            .deviation(&skeleton.hierarchy(), 0, &keys, distance)
            .map_err(value_error)?;
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
        let at = at.in_full()?;
        let places = at.records::<1>().iter().filter_map(|[at]| clips.place(0, *at));
        let (places, t): (Vec<_>, Vec<_>) = places.unzip();
        let output = Output::<R>::new(py, out, &full, EIGHT)?;
        let threads = Threads::for_elements(full.iter().product());
        output.fill(&threads, |to: &mut [[R; 8]]| {
            // Each joint a root: its model is its pose.
            let apart = vec![dq8::Hierarchy::ROOT; clips.joints()];
            let hierarchy = dq8::Hierarchy::new(&apart).map_err(value_error)?;
            // As motions, as `deviation` has them: one kernel for both.
            let to: &mut [DualQuat<R>] = bytemuck::must_cast_slice_mut(to);
            let done = Sampled::new(NlerpLerp, clips, &places, &t)
                .and_then(|sampled| hierarchy.job().locals_to_model(sampled, to));
            done.map_err(|error| PyRuntimeError::new_err(error.to_string()))
        })
    }
}

/// Rotations and translations of frames, and how many joints each has.
fn keys(frames: &Bound<'_, PyAny>) -> PyResult<(Vec<[f32; 7]>, usize)> {
    let frames = Input::<f64>::of(&Argument::new("frames", EIGHT, frames)?)?;
    let &[_, joints] = frames.full_leading() else {
        return Err(misshapen("frames", "(frames, joints, 8)", &frames.shape()));
    };
    let frames = frames.in_full()?;
    let key = |motion: &[f64; 8]| {
        let motion = DualQuat::from_array(*motion);
        let ([x, y, z, w], [a, b, c]) = (motion.rotation().to_array(), motion.translation());
        [x, y, z, w, a, b, c].map(<f32 as Real>::from_f64)
    };
    Ok((frames.records::<8>().iter().map(key).collect(), joints))
}
