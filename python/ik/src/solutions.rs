//! All solutions of arms of six hinges, from arrays to arrays.

use crate::argument::{Argument, Input};
use crate::broadcast::{common, misfit};
use crate::error::value_error;
use crate::number::Number;
use crate::precision::Precision;
use crate::reach::{STEPS, configurations};
use crate::reach_report::array;
use crate::threads::Threads;
use dq8::{DualQuat, Real};
use dq8_robot::OwnedMechanism;
use dq8_robot::ik::{
    Family, Freedom, Goal, Reach, SixAxisArm, Solution, Solutions, SolutionsError,
};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::sync::{Mutex, PoisonError};

/// How many solutions of a target have a place.
const PLACES: usize = 8;

/// How many targets a piece has: some tenths of a millisecond by formula, as many as one of other
/// arms takes.
const PIECE: usize = 256;

/// What `Mechanism.solutions` returns, in the order of `Solutions`.
pub fn solutions<'py>(
    mechanism: Precision<'_>,
    targets: &Argument<'py>,
    values: &Argument<'py>,
    link: usize,
) -> PyResult<Bound<'py, PyTuple>> {
    match mechanism {
        Precision::Single(mechanism) => typed(mechanism, targets, values, link),
        Precision::Double(mechanism) => typed(mechanism, targets, values, link),
    }
}

fn typed<'py, R: Number>(
    mechanism: &OwnedMechanism<R>,
    targets: &Argument<'py>,
    values: &Argument<'py>,
    link: usize,
) -> PyResult<Bound<'py, PyTuple>> {
    let view = mechanism.view();
    let (goals, count) = ([Goal::pose(link)], view.values());
    let mut freedoms = vec![Freedom::default(); view.rates()];
    let reach = Reach::new(view, &goals, &mut freedoms);
    let of_link = |error| value_error(format!("`link`: {error}."));
    let arm = SixAxisArm::new(reach.map_err(value_error)?).map_err(of_link)?;

    let (targets, values) = (Input::<R>::of(targets)?, Input::<R>::of(values)?);
    let (of_targets, of_values) = (targets.full_leading(), configurations(&values, count)?);
    let Some(shape) = common([of_targets, of_values].into_iter()) else {
        return Err(misfit([("targets", of_targets), ("values", of_values)].into_iter()));
    };
    let py = targets.py();
    let values = values.filled(&[&shape[..], &[count]].concat())?;
    let targets = targets.filled(&shape)?;
    let targets: Vec<_> = targets.records().iter().map(|&it| DualQuat::from_array(it)).collect();
    let start = values.records::<1>().as_flattened().to_vec();
    drop(values);
    let hinges = arm.values();
    let of_hinges = |start: &[R]| hinges.map(|hinge| start[hinge]);
    let starts: Vec<_> = start.chunks_exact(count).map(of_hinges).collect();

    let searched = arm.family() == Family::Other;
    let (piece, steps) = if searched { (1, PIECE) } else { (PIECE, STEPS) };
    let threads = Threads::for_elements(starts.len() * view.links() * steps);
    let found = threads.run(py, || {
        let mut found = vec![Solutions::default(); starts.len()];
        let failure = Mutex::new(None);
        threads.split(piece, &mut found, &|(first, found)| {
            let all = first..first + found.len();
            let mut scratch = vec![R::ZERO; arm.batch_scratch_len()];
            let (targets, starts) = (&targets[all.clone()], &starts[all]);
            let done = arm.job().solutions_in(&mut scratch, targets, starts, found);
            let Err(error) = done else { return true };
            *failure.lock().unwrap_or_else(PoisonError::into_inner) = Some(of_all(error, first));
            false
        });
        let failure = failure.into_inner().unwrap_or_else(PoisonError::into_inner);
        failure.map_or(Ok(found), |error| Err(value_error(error)))
    })?;

    let nothing = <R as Real>::from_f64(f64::NAN);
    let mut values = vec![nothing; found.len() * PLACES * count];
    for ((values, start), found) in
        values.chunks_exact_mut(PLACES * count).zip(start.chunks_exact(count)).zip(&found)
    {
        for (values, solution) in values.chunks_exact_mut(count).zip(found.iter()) {
            values.copy_from_slice(start);
            for (hinge, value) in hinges.into_iter().zip(solution.values) {
                values[hinge] = value;
            }
        }
    }
    let places: Vec<_> = found.iter().flat_map(|it| (0..PLACES).map(|i| it.get(i))).collect();
    let each = [&shape[..], &[PLACES]].concat();
    let singular: Vec<_> =
        places.iter().flat_map(|it| it.map_or([false; 3], singular_of)).collect();
    (
        array(py, &values, &[&each[..], &[count]].concat(), |it| *it)?,
        array(py, &found, &shape, |it| it.len() as u8)?,
        array(py, &places, &each, |it| it.map_or(nothing, |it| it.distance))?,
        array(py, &singular, &[&each[..], &[3]].concat(), |it| *it)?,
        array(py, &found, &shape, |it| it.is_complete)?,
    )
        .into_pyobject(py)
}

fn singular_of<R>(solution: &Solution<R>) -> [bool; 3] {
    [solution.singular.shoulder, solution.singular.elbow, solution.singular.wrist]
}

/// The error of a piece, with the index among all.
fn of_all(error: SolutionsError, first: usize) -> SolutionsError {
    use SolutionsError::{NotUnit, Start, Target};
    match error {
        Target { index, value } => Target { index: first + index, value },
        NotUnit { index, norm } => NotUnit { index: first + index, norm },
        Start { index, hinge, value } => Start { index: first + index, hinge, value },
        other => other,
    }
}
