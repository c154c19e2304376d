//! `resample`: many trajectories at the same times.

use crate::argument::{Argument, Input, common_dtype, is_single};
use crate::axis::Axis;
use crate::call::Answer;
use crate::error::misshapen;
use crate::number::Number;
use crate::output::Output;
use crate::shape::{EIGHT, NUMBER};
use crate::threads::{GRAIN, Threads};
use dq8::DualQuat;
use dq8_trajectory::{Trajectory, TrajectoryError};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::ops::Range;

/// The poses at other times of the trajectory through `poses` at `times`.
///
/// Screw motion between neighbours, ``sclerp(poses[k], poses[k + 1], t)`` by the shorter way with
/// ``t = (at − times[k])/(times[k + 1] − times[k])``; before the first and after the last pose,
/// that pose. One thread computes.
///
/// Parameters
/// ----------
/// times : array_like, shape (n,)
///     Finite times that rise, n > 0.
/// poses : array_like, shape (n, ..., 8)
///     Unit dual quaternions at these times; of a clip ``(frames, joints, 8)`` each joint is a
///     trajectory.
/// at : array_like, shape (...)
///     When to sample, in any order; rising times are found fastest.
/// axis : int, optional
///     The dimension of `poses` that is time: the first.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
///     That of `at` stands where time was.
#[doc = common_dtype!()]
///
/// Examples
/// --------
/// >>> import dq8, numpy as np
/// >>> poses = dq8.from_translation(np.array([0.0, 2, 8])[:, None] * [1.0, 0, 0])
/// >>> dq8.translation(dq8.resample([0.0, 1, 3], poses, [0.5, 2, 9]))[:, 0]
/// array([1., 5., 8.])
#[pyfunction]
#[pyo3(signature = (times, poses, at, *, axis=0, out=None))]
pub fn resample<'py>(
    times: &Bound<'py, PyAny>,
    poses: &Bound<'py, PyAny>,
    at: &Bound<'py, PyAny>,
    axis: isize,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let times = Argument::new("times", NUMBER, times)?;
    let poses = Argument::new("poses", EIGHT, poses)?;
    let at = Argument::new("at", NUMBER, at)?;
    let axis = Axis::of(&poses, axis, "(n, ..., 8)")?;
    let arguments = [times, poses.along(axis)?, at];
    if is_single(&arguments) {
        typed::<f32>(&arguments, axis, out)
    } else {
        typed::<f64>(&arguments, axis, out)
    }
}

fn typed<'py, R: Number>(
    [times, poses, at]: &[Argument<'py>; 3],
    axis: Axis,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let times = Input::<R>::of(times)?;
    let &[count] = times.full_leading() else {
        return Err(misshapen("times", "(n,)", &times.shape()));
    };
    let poses = Input::<R>::of(poses)?;
    let full = poses.full_leading().to_vec();
    let Some((_, rows)) = full.split_last().filter(|&(&length, _)| length == count) else {
        return Err(misshapen("poses", &format!("({count}, ..., 8)"), &poses.shape()));
    };
    let at = Input::<R>::of(at)?;
    let leading = [rows, at.full_leading()].concat();
    let made = [&leading[..], EIGHT].concat();
    axis.written(out, &made, at.full_leading().len(), |out| {
        let output = Output::<R>::new(at.py(), out, &leading, EIGHT)?;
        let times = times.in_full()?.apart_from(&output)?;
        let poses = poses.in_full()?.apart_from(&output)?;
        let at = at.in_full()?.apart_from(&output)?;

        let doubles = |numbers: &[R]| numbers.iter().map(|&number| number.into()).collect();
        let (stamps, samples): (Vec<f64>, Vec<f64>) =
            (doubles(times.numbers()), doubles(at.numbers()));
        let poses: Vec<_> = { poses.records::<8>().iter() }
            .map(|pose| DualQuat::<f64>::from_array(pose.map(Into::into)))
            .collect();
        let threads = Threads::alone();
        output.fill(&threads, |to: &mut [[R; 8]]| {
            let to: &mut [DualQuat<R>] = bytemuck::must_cast_slice_mut(to);
            // Everything is checked before something is written.
            if let Some(first) = poses.get(..count) {
                Trajectory::new(&stamps, first).map_err(named)?;
            }
            if let Some(index) = samples.iter().position(|time| time.is_nan()) {
                let message = format!("`at`: sample {index} is asked for at NaN.");
                return Err(PyValueError::new_err(message));
            }
            // Each piece finds the ways between the poses again: of rising times those that it
            // needs, of others all, which takes as long as some samples.
            let rises = samples.is_sorted();
            let size = if rises { GRAIN } else { GRAIN.max(2 * stamps.len()) };
            let rows = poses.chunks_exact(count).zip(to.chunks_mut(samples.len().max(1)));
            let pieces = rows.flat_map(|(poses, to)| {
                samples.chunks(size).zip(to.chunks_mut(size)).map(move |piece| (poses, piece))
            });
            threads.each(pieces, &|(poses, (samples, to))| {
                let ways = if rises { between(&stamps, samples) } else { 0..stamps.len() };
                Trajectory::new(&stamps[ways.clone()], &poses[ways])
                    .is_ok_and(|path| path.job().sample(samples, to).is_ok())
            });
            Ok(())
        })
    })
}

/// The stamps that rising samples lie between, with one more on either side: the ends of a path
/// hold.
fn between(stamps: &[f64], samples: &[f64]) -> Range<usize> {
    let (Some(first), Some(last)) = (samples.first(), samples.last()) else { return 0..0 };
    let begin = stamps.partition_point(|stamp| stamp <= first).saturating_sub(2);
    let end = stamps.partition_point(|stamp| stamp <= last) + 2;
    begin..end.min(stamps.len())
}

/// With the name of the argument that it is about.
fn named(error: TrajectoryError) -> PyErr {
    let argument = match error {
        TrajectoryError::Empty => "`poses`: ",
        TrajectoryError::NotRising { .. } => "`times`: ",
        _ => "",
    };
    PyValueError::new_err(format!("{argument}{error}."))
}
