//! Means along a trajectory.

use crate::argument::{Argument, Input, common_dtype, is_single, iterations};
use crate::axis::Axis;
use crate::blend::{Influences, Mean};
use crate::call::Answer;
use crate::error::misshapen;
use crate::number::Number;
use crate::output::Output;
use crate::shape::{EIGHT, NUMBER};
use crate::threads::Threads;
use pyo3::prelude::*;

/// Intrinsic means of whole windows of motions that follow each other: a trajectory, smoothed.
///
/// Result i is ``mean(motions[i:i + w], weights, axis=0)``, the b with ``Σ wⱼ
/// log(b*σᵢ₊ⱼ) = 0``. The weights are the same for all windows; [1, 2, 1] counts the pose in
/// the middle twice.
///
/// Parameters
/// ----------
/// motions : array_like, shape (n, ..., 8)
///     Unit dual quaternions, one after the other.
/// weights : array_like, shape (w,)
///     The weights of a window of w > 0 motions.
/// axis : int, optional
///     The dimension of time: the first, as in a clip ``(frames, joints, 8)``.
/// tolerance : float, optional
///     The largest step that counts as none: radians, and lengths relative to the longest dual
///     part. By default 1e-14, of float32 1e-6.
/// max_iterations : int, optional
///     The most steps.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (n + 1 - w, ..., 8)
#[doc = common_dtype!()]
///     One for each whole window; none where n < w.
///
/// References
/// ----------
/// L. Kavan, S. Collins, C. O'Sullivan, J. Žára, "Dual Quaternions for Rigid Transformation
/// Blending", Trinity College Dublin, 2006, algorithm 3 (DIB).
///
/// Examples
/// --------
/// >>> import dq8, numpy as np
/// >>> path = dq8.from_translation(np.array([0.0, 1, 5, 6])[:, None] * [1.0, 0, 0])
/// >>> dq8.translation(dq8.dib_windows(path, [1, 1, 1]))[:, 0]
/// array([2., 4.])
#[pyfunction]
#[pyo3(signature = (motions, weights, *, axis=0, tolerance=None, max_iterations=32, out=None))]
pub fn dib_windows<'py>(
    motions: &Bound<'py, PyAny>,
    weights: &Bound<'py, PyAny>,
    axis: isize,
    tolerance: Option<f64>,
    #[pyo3(from_py_with = iterations)] max_iterations: u32,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let mean = Mean::Intrinsic { tolerance: tolerance.unwrap_or(f64::NAN), max_iterations };
    let motions = Argument::new("motions", EIGHT, motions)?;
    let weights = Argument::new("weights", NUMBER, weights)?;
    let axis = Axis::of(&motions, axis, "(n, ..., 8)")?;
    let motions = motions.along(axis)?;
    if is_single([&motions, &weights]) {
        typed::<f32>(mean, &motions, &weights, axis, out)
    } else {
        typed::<f64>(mean, &motions, &weights, axis, out)
    }
}

fn typed<'py, R: Number>(
    mean: Mean,
    motions: &Argument<'py>,
    weights: &Argument<'py>,
    axis: Axis,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let motions = Input::<R>::of(motions)?;
    let full = motions.full_leading().to_vec();
    let Some((&length, rows)) = full.split_last() else {
        return Err(misshapen("motions", "(..., n, 8)", &motions.shape()));
    };
    let weights = Input::<R>::of(weights)?;
    let count = match *weights.full_leading() {
        [count] if count > 0 => count,
        _ => return Err(misshapen("weights", "(w,) with w > 0", &weights.shape())),
    };
    let windows = (length + 1).saturating_sub(count);
    let leading = [rows, &[windows]].concat();
    let made = [&leading[..], EIGHT].concat();
    axis.written(out, &made, 1, |out| {
        let output = Output::<R>::new(motions.py(), out, &leading, EIGHT)?;
        let motions = motions.in_full()?.apart_from(&output)?;
        let weights = weights.in_full()?.apart_from(&output)?;

        let influences = Influences {
            count,
            apart: 1,
            motions: motions.records(),
            weights: Some(weights.records()),
            own: false,
        };
        let threads = Threads::for_elements(leading.iter().product());
        output.fill(&threads, |to| {
            // Windows do not reach from one row into the next.
            for (row, to) in to.chunks_mut(windows.max(1)).enumerate() {
                threads.split(influences.grain(mean), to, &|(first, to)| {
                    influences.from(row * length + first).blend(&threads, mean, to);
                    true
                });
            }
            Ok(())
        })
    })
}
