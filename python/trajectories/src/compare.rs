//! Comparisons of trajectories.

use crate::error::value_error;
use crate::trajectory::Trajectory;
use dq8_trajectory::compare::{Align, Errors, Statistics, Step};
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

type Array<'py> = Bound<'py, PyArray1<f64>>;

/// Stamps, and the errors of translations and rotations with their figures; then the motion and the
/// scale that laid the estimate over its reference.
type Found<'py> = ([Array<'py>; 3], [[f64; 7]; 2], Array<'py>, f64);

/// The errors of an estimate against its reference, as `dq8.compare` has them.
#[pyfunction]
#[pyo3(signature = (reference, estimate, align, tolerance, interpolated, frames, metres, seconds))]
#[allow(clippy::too_many_arguments, reason = "those of the function in Python")]
pub fn compare<'py>(
    py: Python<'py>,
    reference: &Bound<'py, Trajectory>,
    estimate: &Bound<'py, Trajectory>,
    align: Option<&str>,
    tolerance: f64,
    interpolated: bool,
    frames: Option<usize>,
    metres: Option<f64>,
    seconds: Option<f64>,
) -> PyResult<Found<'py>> {
    let align = match align {
        None => Align::None,
        Some("origin") => Align::Origin,
        Some("yaw") => Align::Yaw,
        Some("rigid") => Align::Rigid,
        Some("similarity") => Align::Similarity,
        Some(other) => {
            return Err(PyValueError::new_err(format!(
                "Expected `align` to be None, 'origin', 'yaw', 'rigid' or 'similarity', got \
                 '{other}'."
            )));
        }
    };
    let step = match (frames, metres, seconds) {
        (None, None, None) => None,
        (Some(frames), None, None) => Some(Step::Frames(frames)),
        (None, Some(metres), None) => Some(Step::Metres(metres)),
        (None, None, Some(seconds)) => Some(Step::Seconds(seconds)),
        _ => {
            let message = "Expected at most one of `frames`, `metres` and `seconds`.";
            return Err(PyValueError::new_err(message));
        }
    };
    let (reference, estimate) = (&reference.get().path, &estimate.get().path);
    let compared = py.detach(|| {
        let pairs = if interpolated {
            reference.interpolated(estimate)?
        } else {
            reference.pair(estimate, tolerance)?
        };
        let pairs = pairs.align(align)?;
        let errors = step.map_or_else(|| Ok(pairs.absolute()), |step| pairs.relative(step))?;
        Ok((errors, pairs.alignment()))
    });
    let (errors, alignment): (Errors, _) = compared
        .map_err(|error: dq8_trajectory::compare::CompareError| value_error(format!("{error}.")))?;
    let arrays = [errors.stamps(), errors.translations(), errors.rotations()];
    let figures = [errors.translation(), errors.rotation()].map(|figures| {
        let Statistics { rmse, mean, median, std, min, max, sse, .. } = figures;
        [rmse, mean, median, std, min, max, sse]
    });
    let motion = PyArray1::from_slice(py, &alignment.motion.to_array());
    Ok((arrays.map(|of| PyArray1::from_slice(py, of)), figures, motion, alignment.scale))
}
