//! Inverse kinematics of many configurations, from arrays to arrays.

use crate::argument::{Argument, Input};
use crate::broadcast::{Broadcast, misfit};
use crate::error::{misshapen, value_error};
use crate::links::Chosen;
use crate::number::Number;
use crate::output::Output;
use crate::precision::Precision;
use crate::reach_report::ReachReport;
use crate::threads::Threads;
use dq8::simd::MAX_LANES;
use dq8::{DualQuat, Real, ShapeError};
use dq8_robot::OwnedMechanism;
use dq8_robot::ik::{Freedom, Goal, Options, Reach, ReachError, Report};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::ops::RangeInclusive;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// What a call asks for.
#[derive(Debug)]
pub struct Search<'py> {
    /// One for each link.
    pub targets: Argument<'py>,
    /// Where to start.
    pub values: Argument<'py>,
    /// The links.
    pub chosen: Chosen,
    /// How much each component of an error counts.
    pub weights: Option<Argument<'py>>,
    /// Values to stay near.
    pub posture: Option<Argument<'py>>,
    /// How, and how far.
    pub options: Options<f64>,
}

/// How many configurations a piece has at least, which fill every register, and at most: lanes then
/// seldom wait for the last.
const PIECE: RangeInclusive<usize> = MAX_LANES..=256;

/// A piece that takes longer is too large. One configuration that is out of reach takes a thousand
/// times as long as one that is reached at once.
const LONG: Duration = Duration::from_millis(10);

/// How much work a configuration is, in poses of all its links.
pub(crate) const STEPS: usize = 8;

/// Values that bring links to their targets, and what was reached.
pub fn reach<'py>(
    mechanism: Precision<'_>,
    search: &Search<'py>,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, ReachReport)> {
    match mechanism {
        Precision::Single(mechanism) => typed(mechanism, search, out),
        Precision::Double(mechanism) => typed(mechanism, search, out),
    }
}

fn typed<'py, R: Number>(
    mechanism: &OwnedMechanism<R>,
    search: &Search<'py>,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, ReachReport)> {
    let view = mechanism.view();
    let (goal_count, value_count) = (search.chosen.links.len(), view.values());
    let targets = Input::<R>::of(&search.targets)?;
    let full = targets.full_leading().to_vec();
    let of_targets = match full.split_last() {
        _ if search.chosen.one => &full[..],
        Some((&count, leading)) if count == goal_count => leading,
        _ => {
            return Err(misshapen("targets", &format!("(..., {goal_count}, 8)"), &targets.shape()));
        }
    };
    let values = Input::<R>::of(&search.values)?;
    let of_values = configurations(&values, value_count)?.to_vec();
    let leading = [of_targets, &of_values, &[]];
    let Some(Broadcast { shape, .. }) = Broadcast::of(leading, leading) else {
        return Err(misfit([("targets", of_targets), ("values", &of_values)].into_iter()));
    };

    let goals = goals::<R>(&search.chosen, search.weights.as_ref())?;
    let posture = search.posture.as_ref().map(Input::<R>::of).transpose()?;
    let posture = posture.as_ref().map(|posture| match posture.full_leading() {
        [count] if *count == value_count => Ok(posture.records::<1>().as_flattened()),
        _ => Err(misshapen("posture", &format!("({value_count},)"), &posture.shape())),
    });
    let posture = posture.transpose()?;
    let options = options::<R>(&search.options)?;
    let mut freedoms = vec![Freedom::default(); view.rates()];
    let mut problem = Reach::new(view, &goals, &mut freedoms).map_err(named)?;
    if let Some(posture) = posture {
        problem = problem.with_posture(posture).map_err(named)?;
    }

    let py = targets.py();
    let each_goal: &[usize] = if search.chosen.one { &[] } else { &[goal_count] };
    let given = targets.filled(&[&shape[..], each_goal].concat())?;
    let targets: Vec<_> = given.records().iter().map(|&it| DualQuat::from_array(it)).collect();
    let values = values.filled(&[&shape[..], &[value_count]].concat())?;
    // Both are copied: `out` may be the same memory.
    let start = values.records::<1>().as_flattened().to_vec();
    drop((given, values));
    let output = Output::<R>::new(py, out, &shape, &[value_count])?;
    let mut reports = vec![Report::default(); shape.iter().product()];
    let threads = Threads::for_elements(reports.len() * view.links() * STEPS);
    let values = output.fill::<1>(&threads, |to| {
        let to = to.as_flattened_mut();
        to.copy_from_slice(&start);
        solve(&threads, &problem, &targets, to, &mut reports, &options).map_err(value_error)
    })?;
    Ok((values, ReachReport::new(py, &reports, &shape)?))
}

/// The leading dimensions of configurations of so many values.
pub(crate) fn configurations<'s, R: Number>(
    values: &'s Input<'_, R>,
    count: usize,
) -> PyResult<&'s [usize]> {
    match values.full_leading().split_last() {
        Some((&last, leading)) if last == count => Ok(leading),
        _ => Err(misshapen("values", &format!("(..., {count})"), &values.shape())),
    }
}

/// What is left to be computed, `[configuration]` and what it has of each.
struct Left<'s, R> {
    targets: &'s [DualQuat<R>],
    values: &'s mut [R],
    reports: &'s mut [Report<R>],
    /// How many configurations the next piece has.
    piece: usize,
    failure: Option<ShapeError>,
}

/// All configurations, by all threads. The result of one does not depend on others.
fn solve<R: Number>(
    threads: &Threads,
    problem: &Reach<'_, R>,
    targets: &[DualQuat<R>],
    values: &mut [R],
    reports: &mut [Report<R>],
    options: &Options<R>,
) -> Result<(), ShapeError> {
    let (goals, numbers) = (problem.goals().len(), problem.mechanism().values());
    let left = Left { targets, values, reports, piece: *PIECE.start(), failure: None };
    let left = Mutex::new(left);
    let lock = || left.lock().unwrap_or_else(PoisonError::into_inner);
    threads.all(usize::MAX, &|| {
        let mut scratch = vec![R::ZERO; problem.batch_scratch_len()];
        while !threads.interrupted() {
            let mut all = lock();
            let count = all.piece.min(all.reports.len());
            if count == 0 {
                return;
            }
            let targets = all.targets.split_off(..count * goals).unwrap_or_default();
            let values = all.values.split_off_mut(..count * numbers).unwrap_or_default();
            let reports = all.reports.split_off_mut(..count).unwrap_or_default();
            drop(all);
            let begin = Instant::now();
            let done = problem.job().solve_in(&mut scratch, targets, values, reports, options);
            let piece = if begin.elapsed() > LONG { count / 2 } else { count * 2 };
            let mut all = lock();
            all.piece = piece.clamp(*PIECE.start(), *PIECE.end());
            if let Err(error) = done {
                all.failure = Some(error);
                return;
            }
        }
    });
    left.into_inner().unwrap_or_else(PoisonError::into_inner).failure.map_or(Ok(()), Err)
}

/// A goal for each link.
fn goals<R: Number>(chosen: &Chosen, weights: Option<&Argument<'_>>) -> PyResult<Vec<Goal<R>>> {
    let goals = chosen.links.iter().map(|&link| Goal::pose(link));
    let Some(weights) = weights else { return Ok(goals.collect()) };
    let weights = Input::<R>::of(weights)?;
    let count = chosen.links.len();
    if !matches!(weights.full_leading(), []) && (chosen.one || weights.full_leading() != [count]) {
        let others = if chosen.one { String::new() } else { format!(" or ({count}, 6)") };
        return Err(misshapen("weights", &format!("(6,){others}"), &weights.shape()));
    }
    let all = [count];
    let weights = weights.filled(if chosen.one { &[] } else { &all })?;
    let weighted = goals
        .zip(weights.records::<6>())
        .map(|(goal, &[a, b, c, x, y, z])| goal.with_angular([a, b, c]).with_linear([x, y, z]));
    Ok(weighted.collect())
}

/// Options in the precision of the call.
fn options<R: Number>(options: &Options<f64>) -> PyResult<Options<R>> {
    // As the call will see it: what is tiny may be zero there, and what is huge infinite.
    let number = |name: &str, what: &str, value: f64, fits: fn(f64) -> bool| {
        let converted = <R as Real>::from_f64(value);
        if fits(converted.into()) {
            return Ok(converted);
        }
        Err(PyValueError::new_err(format!("Expected `{name}` to be {what}, got {value}.")))
    };
    let tolerance = |name, value| number(name, "at least 0", value, |value| value >= 0.0);
    let length_per_radian = options.length_per_radian.map(|length| {
        let fits = |length: f64| length > 0.0 && length.is_finite();
        number("length_per_radian", "finite and more than 0", length, fits)
    });
    let damping = |damping: f64| damping >= 0.0 && damping.is_finite();
    Ok(Options {
        angular_tolerance: tolerance("angular_tolerance", options.angular_tolerance)?,
        linear_tolerance: tolerance("linear_tolerance", options.linear_tolerance)?,
        max_iterations: options.max_iterations,
        length_per_radian: length_per_radian.transpose()?,
        max_step: number("max_step", "more than 0", options.max_step, |step| step > 0.0)?,
        damping: number("damping", "finite and at least 0", options.damping, damping)?,
        restarts: options.restarts,
        ..Options::default()
    })
}

/// With the name of the argument that it is about.
fn named(error: ReachError) -> PyErr {
    let argument = match error {
        ReachError::NoGoals | ReachError::Link { .. } | ReachError::Unmoved { .. } => "`links`: ",
        ReachError::Weight { .. } | ReachError::NoWeight { .. } => "`weights`: ",
        ReachError::PostureLength { .. } | ReachError::Posture { .. } => "`posture`: ",
        _ => "",
    };
    PyValueError::new_err(format!("{argument}{error}."))
}
