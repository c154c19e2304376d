//! All solutions of arms of six hinges, from arrays to arrays.

use crate::argument::{Argument, Input};
use crate::broadcast::{common, misfit};
use crate::error::value_error;
use crate::number::Number;
use crate::precision::Precision;
use crate::reach::STEPS;
use crate::reach_report::shaped;
use crate::search::configurations;
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
    let (poses, start) = (targets.records::<8>(), values.numbers());
    let hinges = arm.values();

    let searched = arm.family() == Family::Other;
    let (piece, steps) = if searched { (1, PIECE) } else { (PIECE, STEPS) };
    let threads = Threads::for_elements(poses.len() * view.links() * steps);
    let failure = Mutex::new(None);
    let all = threads.run(py, || {
        let mut all = Parts::new(poses.len(), count);
        let pieces = all.pieces(piece).zip(poses.chunks(piece)).zip(start.chunks(piece * count));
        threads.each(pieces.enumerate(), &|(index, ((parts, poses), start))| {
            let done = parts.solve(&arm, &hinges, poses, start);
            let Err(error) = done else { return true };
            let mut failure = failure.lock().unwrap_or_else(PoisonError::into_inner);
            // The first one, whichever thread finds its own sooner.
            if failure.as_ref().is_none_or(|&(first, _)| index < first) {
                *failure = Some((index, of_all(error, index * piece)));
            }
            false
        });
        Ok(all)
    })?;
    if let Some((_, error)) = failure.into_inner().unwrap_or_else(PoisonError::into_inner) {
        return Err(value_error(error));
    }
    let each = [&shape[..], &[PLACES]].concat();
    (
        shaped(py, all.values, &[&each[..], &[count]].concat())?,
        shaped(py, all.counts, &shape)?,
        shaped(py, all.distances, &each)?,
        shaped(py, all.singular, &[&each[..], &[3]].concat())?,
        shaped(py, all.complete, &shape)?,
    )
        .into_pyobject(py)
}

/// The solutions of all targets, or of a piece of them.
struct Parts<V, C, D, S, B> {
    values: V,
    counts: C,
    distances: D,
    singular: S,
    complete: B,
}

type AllParts<R> = Parts<Vec<R>, Vec<u8>, Vec<R>, Vec<bool>, Vec<bool>>;
type SomeParts<'s, R> =
    Parts<&'s mut [R], &'s mut [u8], &'s mut [R], &'s mut [bool], &'s mut [bool]>;

impl<R: Number> AllParts<R> {
    /// Makes room for the solutions of `targets` targets, in configurations of `count` values. It
    /// is zero, because the system has memory of zeros ready.
    fn new(targets: usize, count: usize) -> Self {
        Self {
            values: vec![R::ZERO; targets * PLACES * count],
            counts: vec![0; targets],
            distances: vec![R::ZERO; targets * PLACES],
            singular: vec![false; targets * PLACES * 3],
            complete: vec![false; targets],
        }
    }

    /// Those of `size` targets each.
    fn pieces(&mut self, size: usize) -> impl Iterator<Item = SomeParts<'_, R>> {
        let count = self.values.len() / self.distances.len().max(1);
        let values = self.values.chunks_mut((size * PLACES * count).max(1));
        let parts = values.zip(self.counts.chunks_mut(size));
        let parts = parts.zip(self.distances.chunks_mut(size * PLACES));
        let parts = parts.zip(self.singular.chunks_mut(size * PLACES * 3));
        parts.zip(self.complete.chunks_mut(size)).map(
            |((((values, counts), distances), singular), complete)| Parts {
                values,
                counts,
                distances,
                singular,
                complete,
            },
        )
    }
}

impl<R: Number> SomeParts<'_, R> {
    /// Solves some targets. One that is not finite, or begins at what is not, has no solution.
    fn solve(
        self,
        arm: &SixAxisArm<'_, R>,
        hinges: &[usize; 6],
        targets: &[[R; 8]],
        start: &[R],
    ) -> Result<(), SolutionsError> {
        let nothing = <R as Real>::from_f64(f64::NAN);
        let count = start.len() / targets.len();
        let of_hinges = |start: &[R]| hinges.map(|hinge| start[hinge]);
        let mut starts: Vec<_> = start.chunks_exact(count).map(of_hinges).collect();
        let mut goals: Vec<_> = targets.iter().map(|&it| DualQuat::from_array(it)).collect();
        let mut is_known = vec![true; goals.len()];
        for ((goal, start), is_known) in goals.iter_mut().zip(&mut starts).zip(&mut is_known) {
            let numbers = goal.to_array();
            *is_known = numbers.iter().chain(&*start).all(|number| number.is_finite());
            if !*is_known {
                (*goal, *start) = (DualQuat::IDENTITY, [R::ZERO; 6]);
            }
        }
        let mut scratch = vec![R::ZERO; arm.batch_scratch_len()];
        let mut found = vec![Solutions::default(); goals.len()];
        arm.job().solutions_in(&mut scratch, &goals, &starts, &mut found)?;
        let of_start = start.chunks_exact(count);
        let values = self.values.chunks_exact_mut(PLACES * count).zip(of_start);
        for (index, (values, start)) in values.enumerate() {
            let all = &found[index];
            let all = if is_known[index] { &all[..] } else { &[] };
            self.counts[index] = all.len() as u8;
            self.complete[index] = is_known[index] && found[index].is_complete;
            for (place, values) in values.chunks_exact_mut(count).enumerate() {
                let at = index * PLACES + place;
                let Some(solution) = all.get(place) else {
                    values.fill(nothing);
                    self.distances[at] = nothing;
                    continue;
                };
                values.copy_from_slice(start);
                for (&hinge, value) in hinges.iter().zip(solution.values) {
                    values[hinge] = value;
                }
                self.distances[at] = solution.distance;
                self.singular[3 * at..3 * at + 3].copy_from_slice(&singular_of(solution));
            }
        }
        Ok(())
    }
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
