//! How many threads compute.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::{Arc, Mutex, PoisonError};

/// How many elements a task has: some ten microseconds of work, where starting one takes about one.
pub(crate) const GRAIN: usize = 4096;

/// The threads of this process, if there is more than one.
static POOL: Mutex<Option<Arc<ThreadPool>>> = Mutex::new(None);

/// What is done with a piece of a slice, of which the number or the first index is told.
type Each<'f, T, O> = dyn Fn(usize, &mut [T]) -> O + Send + Sync + 'f;

/// The threads of one call.
#[derive(Debug)]
pub(crate) struct Threads(Option<Arc<ThreadPool>>);

impl Threads {
    /// Those for so many elements.
    pub(crate) fn for_elements(count: usize) -> Self {
        if count < 2 * GRAIN {
            return Self(None);
        }
        Self(POOL.lock().unwrap_or_else(PoisonError::into_inner).clone())
    }

    /// Whether there is more than this one.
    pub(crate) fn many(&self) -> bool {
        self.0.is_some()
    }

    /// Hands chunks of `to`, each with its number, to `each`.
    pub(crate) fn chunks<T: Send>(&self, size: usize, to: &mut [T], each: &Each<'_, T, ()>) {
        match &self.0 {
            Some(pool) => pool.install(|| {
                to.par_chunks_mut(size).enumerate().for_each(|(index, to)| each(index, to));
            }),
            None => to.chunks_mut(size).enumerate().for_each(|(index, to)| each(index, to)),
        }
    }

    /// Runs `job` in the pool of these threads.
    pub(crate) fn install<T: Send>(&self, job: impl FnOnce() -> T + Send) -> T {
        match &self.0 {
            Some(pool) => pool.install(job),
            None => job(),
        }
    }

    /// Hands pieces of `to`, each with the index of its first element, to `each`; whether all were done.
    ///
    /// (What is called is no type parameter: the pool is compiled once for each type of element, not for each
    /// function, which took a third of the time of compiling.)
    pub(crate) fn split<T: Send>(&self, to: &mut [T], each: &Each<'_, T, bool>) -> bool {
        match &self.0 {
            Some(pool) if to.len() >= 2 * GRAIN => pool.install(|| {
                to.par_chunks_mut(GRAIN).enumerate().all(|(i, piece)| each(i * GRAIN, piece))
            }),
            _ => each(0, to),
        }
    }
}

/// Let `count` threads compute calls of 8192 elements and more; 1, the default, starts none.
///
/// The environment variable ``DQ8_NUM_THREADS`` sets it at import. Results do not depend on it, to the
/// last bit. In a child made by ``fork`` it is 1 again: threads do not survive a fork.
#[pyfunction]
#[pyo3(signature = (count, /))]
pub(crate) fn set_num_threads(count: usize) -> PyResult<()> {
    let pool = match count {
        0 => return Err(PyValueError::new_err("Expected `count` to be at least 1, got 0.")),
        1 => None,
        _ => {
            let pool = ThreadPoolBuilder::new().num_threads(count).build();
            Some(Arc::new(
                pool.map_err(|error| PyValueError::new_err(format!("`count` = {count}: {error}")))?,
            ))
        }
    };
    *POOL.lock().unwrap_or_else(PoisonError::into_inner) = pool;
    Ok(())
}

/// How many threads compute large calls.
#[pyfunction]
pub(crate) fn get_num_threads() -> usize {
    let pool = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    pool.as_ref().map_or(1, |pool| pool.current_num_threads())
}

/// In a child process after a fork: the threads of the pool are gone, and waiting for them would never end.
#[pyfunction]
pub(crate) fn forget_threads() {
    std::mem::forget(POOL.lock().unwrap_or_else(PoisonError::into_inner).take());
}
