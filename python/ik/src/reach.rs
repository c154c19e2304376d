//! Inverse kinematics of many configurations, from arrays to arrays.

use crate::argument::Input;
use crate::broadcast::{common, misfit};
use crate::error::value_error;
use crate::number::Number;
use crate::output::Output;
use crate::precision::Precision;
use crate::reach_report::{Columns, Part, ReachReport};
use crate::search::{Parts, Rows, Search, configurations, filled, of_goals, settings};
use crate::threads::Threads;
use dq8::ShapeError;
use dq8::simd::MAX_LANES;
use dq8_robot::OwnedMechanism;
use dq8_robot::ik::{Options, Reach, Report};
use pyo3::prelude::*;
use std::ops::RangeInclusive;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// The least and the greatest number of configurations of a piece. The least number fills every
/// register; with the greatest, lanes seldom wait for the last configuration.
const PIECE: RangeInclusive<usize> = MAX_LANES..=256;

/// A piece that takes longer is too large. One configuration that is out of reach takes a thousand
/// times as long as one that is reached at once.
pub(crate) const LONG: Duration = Duration::from_millis(10);

/// The work of one configuration, as a multiple of the work of computing the poses of all links.
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
    let value_count = view.values();
    let targets = Input::<R>::of(&search.targets)?;
    let of_targets = of_goals(&targets, &search.goals)?;
    let values = Input::<R>::of(&search.values)?;
    let of_values = configurations(&values, value_count)?;
    let Some(shape) = common([of_targets, of_values].into_iter()) else {
        return Err(misfit([("targets", of_targets), ("values", of_values)].into_iter()));
    };
    let mut parts = Parts::of(search, view)?;
    let settings = settings::<R>(&search.settings)?;
    let problem = parts.reach(view)?;

    let py = targets.py();
    let each_goal = search.goals.each();
    let output = Output::<R>::new(py, out, &shape, &[value_count])?;
    let targets = filled(targets, &shape, each_goal)?.apart_from(&output)?;
    let values = filled(values, &shape, &[value_count])?.apart_from(&output)?;
    let targets = (Rows::of(&targets, each_goal), targets.size());
    let start = Rows::of(&values, &[value_count]);
    let mut columns = Columns::new(shape.iter().product());
    let all = columns.all();
    let threads = Threads::for_elements(all.len() * view.links() * STEPS);
    let values = output.fill::<1>(&threads, |to| {
        let left = Left {
            first: 0,
            values: to.as_flattened_mut(),
            reports: all,
            piece: *PIECE.start(),
            failure: None,
        };
        solve(&threads, &problem, targets, start, left, &settings.options).map_err(value_error)
    })?;
    Ok((values, ReachReport::new(py, columns, &shape)?))
}

/// The configurations that no thread has begun, and the memory for their results.
struct Left<'s, R> {
    /// The first configuration of the next piece.
    first: usize,
    values: &'s mut [R],
    reports: Part<'s, R>,
    /// The number of configurations of the next piece.
    piece: usize,
    failure: Option<ShapeError>,
}

/// All configurations, by all threads. The result of one does not depend on others. Nothing is
/// copied but piece by piece: a call on much memory can be interrupted from its beginning.
fn solve<R: Number>(
    threads: &Threads,
    problem: &Reach<'_, R>,
    (targets, record): (Rows<'_, R>, usize),
    start: Rows<'_, R>,
    left: Left<'_, R>,
    options: &Options<R>,
) -> Result<(), ShapeError> {
    let numbers = problem.mechanism().values();
    let left = Mutex::new(left);
    let lock = || left.lock().unwrap_or_else(PoisonError::into_inner);
    threads.all(usize::MAX, &|| {
        let mut scratch = vec![R::ZERO; problem.batch_scratch_len()];
        let (mut wanted, mut made) = (Vec::new(), Vec::new());
        while !threads.interrupted() {
            let mut all = lock();
            let count = all.piece.min(all.reports.len());
            if count == 0 {
                return;
            }
            let each = all.first..all.first + count;
            all.first += count;
            let values = all.values.split_off_mut(..count * numbers).unwrap_or_default();
            let reports = all.reports.split_off(count);
            drop(all);
            let begin = Instant::now();
            wanted.clear();
            targets.targets(each.clone(), record, &mut wanted);
            for (index, values) in each.zip(values.chunks_exact_mut(numbers.max(1))) {
                values.copy_from_slice(start.at(index));
            }
            made.clear();
            made.resize(count, Report::default());
            let done = problem.job().solve_in(&mut scratch, &wanted, values, &mut made, options);
            reports.write(&made);
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
