//! [`in_pieces`]: work that can fail, in pieces between which a call can be interrupted.

use crate::error::value_error;
use crate::threads::{GRAIN, Threads};
use dq8_trajectory::TrajectoryError;
use pyo3::prelude::*;
use std::sync::{Mutex, PoisonError};

/// The elements of a piece of work with so many stamps. Each piece makes the ways between the poses
/// again, which takes as long as some hundred elements for each.
pub(crate) fn size(stamps: usize) -> usize {
    GRAIN.max(512 * stamps)
}

/// What is done with a piece of the output, whose first element has this number.
pub(crate) type Piece<'f, T> = dyn Fn(usize, &mut [T]) -> Result<(), TrajectoryError> + Sync + 'f;

/// Hands pieces of `size` elements to `work`, whose errors come before it writes anything and are
/// the same for all pieces.
pub(crate) fn in_pieces<T: Send>(
    threads: &Threads,
    size: usize,
    to: &mut [T],
    work: &Piece<'_, T>,
) -> PyResult<()> {
    let failed = Mutex::new(None);
    threads.split(size, to, &|(first, to)| {
        let done = work(first, to);
        let error = done.err();
        let could = error.is_none();
        if !could {
            *failed.lock().unwrap_or_else(PoisonError::into_inner) = error;
        }
        could
    });
    match failed.into_inner().unwrap_or_else(PoisonError::into_inner) {
        Some(error) => Err(value_error(format!("{error}."))),
        None => Ok(()),
    }
}
