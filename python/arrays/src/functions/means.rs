//! Blends of any number of motions.

use crate::argument::{Argument, Input, common_dtype, is_single, iterations};
use crate::axis::Axis;
use crate::blend::{Influences, Mean};
use crate::call::Answer;
use crate::error::misshapen;
use crate::number::Number;
use crate::output::Output;
use crate::shape::{EIGHT, NUMBER, tuple};
use crate::threads::Threads;
use pyo3::prelude::*;

/// Dual quaternion linear blending: ``normalize(Σ ±wᵢσᵢ)``, each sign turned toward the
/// first.
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., n, 8)
///     Unit dual quaternions, n > 0 influences of each result.
/// weights : array_like, shape (..., n) or (n,), optional
///     Their weights, the same for all results or their own; equal ones by default.
/// axis : int, optional
///     The dimension of `motions` with the influences: the last but one, as vertices have them. Of
///     a clip ``(frames, joints, 8)`` it is 0 that blends frames; by default joints are blended
///     with each other.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
///
/// References
/// ----------
/// L. Kavan, S. Collins, J. Žára, C. O'Sullivan, "Skinning with Dual Quaternions", I3D 2007.
///
/// Examples
/// --------
/// >>> import dq8
/// >>> dq8.translation(dq8.dlb(dq8.from_translation([[0.0, 0, 0], [4, 0, 0]]), [3, 1]))
/// array([1., 0., 0.])
#[pyfunction]
#[pyo3(signature = (motions, weights=None, *, axis=-2, out=None))]
pub fn dlb<'py>(
    motions: &Bound<'py, PyAny>,
    weights: Option<&Bound<'py, PyAny>>,
    axis: isize,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    mean_of(Mean::Linear, motions, weights, axis, out)
}

/// Intrinsic means: the b with ``Σ wᵢ log(b*σᵢ) = 0``, found by iteration from the linear
/// blend.
///
/// The mean of moved motions is the moved mean, from the left and from the right.
/// (`RigidTransform.mean` is SciPy's: the mean of the rotations and that of the translations.)
///
/// Parameters
/// ----------
/// motions : array_like, shape (..., n, 8)
///     Unit dual quaternions, n > 0 influences of each result.
/// weights : array_like, shape (..., n) or (n,), optional
///     Their weights, the same for all results or their own; equal ones by default.
/// axis : int, optional
///     The dimension of `motions` with the influences: the last but one, as vertices have them. Of
///     a clip ``(frames, joints, 8)`` it is 0 that blends frames; by default joints are blended
///     with each other.
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
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
///
/// References
/// ----------
/// L. Kavan, S. Collins, C. O'Sullivan, J. Žára, "Dual Quaternions for Rigid Transformation
/// Blending", Trinity College Dublin, 2006, algorithm 3 (DIB).
///
/// Examples
/// --------
/// >>> import dq8
/// >>> dq8.translation(dq8.mean(dq8.from_translation([[0.0, 0, 0], [4, 0, 0]])))
/// array([2., 0., 0.])
#[pyfunction]
#[pyo3(signature = (motions, weights=None, *, axis=-2, tolerance=None, max_iterations=32, out=None))]
pub fn mean<'py>(
    motions: &Bound<'py, PyAny>,
    weights: Option<&Bound<'py, PyAny>>,
    axis: isize,
    tolerance: Option<f64>,
    #[pyo3(from_py_with = iterations)] max_iterations: u32,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let tolerance = tolerance.unwrap_or(f64::NAN);
    mean_of(Mean::Intrinsic { tolerance, max_iterations }, motions, weights, axis, out)
}

fn mean_of<'py>(
    mean: Mean,
    motions: &Bound<'py, PyAny>,
    weights: Option<&Bound<'py, PyAny>>,
    axis: isize,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let motions = Argument::new("motions", EIGHT, motions)?;
    let weights = weights.map(|value| Argument::new("weights", NUMBER, value)).transpose()?;
    let axis = Axis::of(&motions, axis, "(..., n, 8) with n > 0")?;
    // Weights of one dimension are the same for all results.
    let of_each = |it: &Argument<'_>| it.shape().len() > 1;
    let weights =
        weights.map(|it| if of_each(&it) { it.along(axis) } else { Ok(it) }).transpose()?;
    let motions = motions.along(axis)?;
    if is_single([&motions].into_iter().chain(&weights)) {
        typed::<f32>(mean, &motions, weights.as_ref(), out)
    } else {
        typed::<f64>(mean, &motions, weights.as_ref(), out)
    }
}

fn typed<'py, R: Number>(
    mean: Mean,
    motions: &Argument<'py>,
    weights: Option<&Argument<'py>>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let motions = Input::<R>::of(motions)?;
    let full = motions.full_leading().to_vec();
    let Some((&count, leading)) = full.split_last().filter(|(count, _)| **count > 0) else {
        return Err(misshapen("motions", "(..., n, 8) with n > 0", &motions.shape()));
    };
    let motions = motions.in_full()?;
    let weights = weights.map(Input::<R>::of).transpose()?;
    let own = match &weights {
        None => false,
        Some(weights) if weights.full_leading() == [count] => false,
        Some(weights) if weights.full_leading() == full => true,
        Some(weights) => {
            let expected = format!("{} or {}", tuple(&[count]), tuple(&full));
            return Err(misshapen("weights", &expected, &weights.shape()));
        }
    };
    let weights = weights.map(Input::in_full).transpose()?;
    let output = Output::<R>::new(motions.py(), out, leading, EIGHT)?;
    let motions = motions.apart_from(&output)?;
    let weights = weights.map(|weights| weights.apart_from(&output)).transpose()?;

    let influences = Influences {
        count,
        apart: count,
        motions: motions.records(),
        weights: weights.as_ref().map(|weights| weights.records()),
        own,
    };
    let threads = Threads::for_elements(influences.motions.len());
    output.fill(&threads, |to| {
        threads.split(influences.grain(mean), to, &|(first, to)| {
            influences.from(first).blend(&threads, mean, to);
            true
        });
        Ok(())
    })
}
