//! Motions that bring points to points.

use crate::argument::{Argument, Input, is_single};
use crate::call::Answer;
use crate::error::value_error;
use crate::number::Number;
use crate::output::Output;
use crate::shape::NUMBER;
use crate::threads::Threads;
use dq8::fit::{FitError, PointPairs};
use dq8::{DualQuat, Real};
use pyo3::prelude::*;

/// For each problem a motion, the scale, rms, rank and condition, as `dq8.fit` has them.
const NUMBERS: usize = 12;

/// The best maps of `points` to `moved`, both (..., n, 3), with `weights` (..., n): twelve numbers
/// for each problem. NaN where there is no best one.
#[pyfunction]
#[pyo3(signature = (points, moved, weights, about, scale))]
pub fn fit_pairs<'py>(
    points: &Bound<'py, PyAny>,
    moved: &Bound<'py, PyAny>,
    weights: &Bound<'py, PyAny>,
    about: Option<[f64; 3]>,
    scale: bool,
) -> Answer<'py> {
    let points = Argument::new("points", &[3], points)?;
    let arguments =
        [points, Argument::new("moved", &[3], moved)?, Argument::new("weights", NUMBER, weights)?];
    if is_single(&arguments) {
        typed::<f32>(&arguments, about, scale)
    } else {
        typed::<f64>(&arguments, about, scale)
    }
}

fn typed<'py, R: Number>(
    [points, moved, weights]: &[Argument<'py>; 3],
    about: Option<[f64; 3]>,
    scale: bool,
) -> Answer<'py> {
    let [points, moved] = [Input::<R>::of(points)?, Input::<R>::of(moved)?];
    let weights = Input::<R>::of(weights)?;
    let (points, moved, weights) = (points.in_full()?, moved.in_full()?, weights.in_full()?);
    let (Some((&count, leading)), py) = (points.full_leading().split_last(), points.py()) else {
        return Err(value_error("Expected points."));
    };
    let output = Output::<R>::new(py, None, leading, &[NUMBERS])?;
    let count = count.max(1);
    let [x, y] = [points.records::<3>(), moved.records::<3>()];
    let (w, about) = (weights.numbers(), about.map(|axis| axis.map(<R as Real>::from_f64)));
    let threads = Threads::for_elements(x.len());
    output.fill(&threads, |to: &mut [[R; NUMBERS]]| {
        threads.split(4096_usize.div_ceil(count), to, &|(first, to)| {
            for (index, to) in to.iter_mut().enumerate() {
                let own = (first + index) * count..(first + index + 1) * count;
                *to = one(&x[own.clone()], &y[own.clone()], &w[own], about, scale);
            }
            true
        });
        Ok(())
    })
}

fn one<R: Number>(
    points: &[[R; 3]],
    moved: &[[R; 3]],
    weights: &[R],
    about: Option<[R; 3]>,
    scale: bool,
) -> [R; NUMBERS] {
    let nan = <R as Real>::from_f64(f64::NAN);
    let mut numbers = [nan; NUMBERS];
    let Ok(pairs) = PointPairs::weighted(points, moved, weights) else { return numbers };
    let fit = match about {
        Some(axis) => pairs.about(axis),
        None if scale => pairs.similarity(),
        None => pairs.rigid(),
    };
    match fit {
        Ok(fit) => {
            let quality = pairs.quality(&fit);
            numbers[..8].copy_from_slice(&DualQuat::to_array(fit.motion));
            let rest = [
                fit.scale,
                quality.rms,
                <R as Real>::from_f64(quality.rank as f64),
                quality.condition,
            ];
            numbers[8..].copy_from_slice(&rest);
        }
        Err(FitError::Ambiguous { rank, .. }) => {
            (numbers[10], numbers[11]) =
                (<R as Real>::from_f64(rank as f64), <R as Real>::from_f64(f64::INFINITY));
        }
        Err(_) => {}
    }
    numbers
}
