//! How many threads compute, in pieces between which a call can be interrupted.

use crate::interrupt::{Interrupt, PERIOD};
use pyo3::exceptions::{PyOverflowError, PyRuntimeError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use rayon_core::{ThreadPool, ThreadPoolBuilder};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::Builder;

/// How many elements a piece has: some ten microseconds of work, where starting one takes about
/// one.
pub const GRAIN: usize = 4096;

/// More than any machine has use for: threads beyond the cores wait for each other.
const MOST_THREADS: i64 = 256;

/// The threads of this process, if there is more than one.
static POOL: Mutex<Option<Arc<ThreadPool>>> = Mutex::new(None);

/// What is done with a piece of work; whether it could be.
type Each<'f, T> = dyn Fn(T) -> bool + Sync + 'f;

/// The threads of one call, and what interrupts them.
#[derive(Debug)]
pub struct Threads {
    pool: Option<Arc<ThreadPool>>,
    interrupt: Interrupt,
    /// `true` while a loop counts its pieces; loops inside of it do not count theirs.
    counted: AtomicBool,
}

impl Threads {
    /// Returns the threads for a call on `count` elements.
    pub fn for_elements(count: usize) -> Self {
        let large = count >= 2 * GRAIN;
        let pool = || POOL.lock().unwrap_or_else(PoisonError::into_inner).clone();
        Self { pool: large.then(pool).flatten(), ..Self::alone() }
    }

    /// Returns only the calling thread, for a call that cannot be split.
    pub fn alone() -> Self {
        Self { pool: None, interrupt: Interrupt::new(), counted: AtomicBool::new(false) }
    }

    /// Whether there is more than this one.
    pub fn many(&self) -> bool {
        self.pool.is_some()
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.pool.as_ref().map_or(1, |pool| pool.current_num_threads())
    }

    /// Runs `job` while other threads of Python run. Where it is interrupted, it may have left out
    /// pieces.
    pub fn run<T: Send>(
        &self,
        py: Python<'_>,
        job: impl FnOnce() -> PyResult<T> + Send,
    ) -> PyResult<T> {
        let (mut job, mut done) = (Some(job), None);
        py.detach(|| self.wait_for(&mut || done = job.take().map(|job| job())));
        // It was called, or has panicked, which has been passed on.
        let done = done.unwrap_or_else(|| Err(PyRuntimeError::new_err("nothing was computed")));
        self.interrupt.take().map_or(done, Err)
    }

    /// (Here and below, what is called is no type parameter: what rayon does is compiled once, not
    /// for each function.)
    fn wait_for(&self, job: &mut (dyn FnMut() + Send)) {
        let Some(pool) = &self.pool else { return job() };
        // This thread only waits: it is the one that Python tells of signals.
        pool.in_place_scope(|scope| {
            let (done, wait) = channel::<()>();
            scope.spawn(move |_| {
                job();
                drop(done);
            });
            while wait.recv_timeout(PERIOD) == Err(RecvTimeoutError::Timeout) {
                self.interrupt.ask();
            }
        });
    }

    /// Whether the call is to end early, asked from piece to piece of a job.
    pub fn interrupted(&self) -> bool {
        if self.pool.is_none() {
            self.interrupt.ask();
        }
        self.interrupt.came()
    }

    /// Hands `pieces` to `each`, until it cannot do one or the call is interrupted; whether it
    /// could.
    pub fn each<T: Send>(&self, mut pieces: impl Iterator<Item = T>, each: &Each<'_, T>) -> bool {
        let outermost = !self.counted.swap(true, Ordering::Relaxed);
        let done = AtomicUsize::new(0);
        let note = |all: usize| {
            let done = 1 + done.fetch_add(1, Ordering::Relaxed);
            if outermost {
                self.interrupt.note(done as f64 / all.max(done) as f64);
            }
        };
        if !self.many() {
            let all = pieces.size_hint().0;
            let could = pieces.all(|piece| {
                let could = self.interrupted() || each(piece);
                note(all);
                could
            });
            self.counted.fetch_and(!outermost, Ordering::Relaxed);
            return could;
        }
        let pieces: Vec<_> = pieces.collect();
        let (count, could) = (pieces.len(), AtomicBool::new(true));
        let pieces = Mutex::new(pieces.into_iter());
        let next = || pieces.lock().unwrap_or_else(PoisonError::into_inner).next();
        self.all(count, &|| {
            while could.load(Ordering::Relaxed)
                && !self.interrupted()
                && let Some(piece) = next()
            {
                could.fetch_and(each(piece), Ordering::Relaxed);
                note(count);
            }
        });
        self.counted.fetch_and(!outermost, Ordering::Relaxed);
        could.into_inner()
    }

    /// [`each`](Self::each) of the pieces of `to` that have `size` elements, with the index of its
    /// first one.
    pub fn split<'a, T: Send>(
        &self,
        size: usize,
        to: &'a mut [T],
        each: &Each<'_, (usize, &'a mut [T])>,
    ) -> bool {
        // A piece or two are not worth handing out.
        if to.len() < 2 * size {
            return each((0, to));
        }
        let pieces = to.chunks_mut(size).enumerate().map(|(index, piece)| (index * size, piece));
        self.each(pieces, each)
    }

    /// Runs `work` on each of the threads, at most `most`, to share out pieces of its own.
    pub fn all(&self, most: usize, work: &(dyn Fn() + Sync)) {
        if !self.many() {
            return work();
        }
        rayon_core::scope(|scope| {
            let others = 1..rayon_core::current_num_threads().min(most);
            others.for_each(|_| scope.spawn(|_| work()));
            work();
        });
    }
}

/// Runs a job that has no pieces between which it could be interrupted, and returns its result. The
/// job runs in a thread of its own, and the calling thread, which Python tells of signals, waits
/// for it. If a signal ends the call, the job goes on alone: it owns its input, and ends by itself.
pub fn whole<T: Send + 'static>(
    py: Python<'_>,
    job: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    watched(py, |_| job())
}

/// Runs a job as [`whole`] does. The job may ask whether it was interrupted, to end soon, and note
/// which part of it is done.
pub fn watched<T: Send + 'static>(
    py: Python<'_>,
    job: impl FnOnce(&Interrupt) -> T + Send + 'static,
) -> PyResult<T> {
    let made = Arc::new(Mutex::new(None));
    let to = Arc::clone(&made);
    apart(
        py,
        Box::new(move |interrupt| {
            let it = job(interrupt);
            *to.lock().unwrap_or_else(PoisonError::into_inner) = Some(it);
        }),
    )?;
    let made = made.lock().unwrap_or_else(PoisonError::into_inner).take();
    // It has panicked.
    made.ok_or_else(|| PyRuntimeError::new_err("nothing was computed"))
}

/// Runs a job in a thread of its own and waits for its end or for a signal. It is no type
/// parameter, so that threads and channels are compiled once.
fn apart(py: Python<'_>, job: Box<dyn FnOnce(&Interrupt) + Send>) -> PyResult<()> {
    let interrupt = &Arc::new(Interrupt::new());
    let (done, wait) = channel::<()>();
    let own = Arc::clone(interrupt);
    // As much stack as the first thread of a process has on most systems.
    let thread = Builder::new().stack_size(8 << 20).spawn(move || {
        job(&own);
        drop(done);
    });
    thread.map_err(|error| PyRuntimeError::new_err(format!("no thread: {error}")))?;
    py.detach(move || {
        while wait.recv_timeout(PERIOD) == Err(RecvTimeoutError::Timeout) {
            interrupt.ask();
            if interrupt.came() {
                return;
            }
        }
    });
    interrupt.take().map_or(Ok(()), Err)
}

/// Let `count` threads, 1 to 256, compute calls of 8192 elements and more; 1, the default, starts
/// none.
///
/// The environment variable ``DQ8_NUM_THREADS`` sets it at import. Results do not depend on it, to
/// the last bit. In a child made by ``fork`` it is 1 again: threads do not survive a fork.
#[pyfunction]
pub fn set_num_threads(count: &Bound<'_, PyAny>) -> PyResult<()> {
    let threads = count.extract::<i64>();
    if let Err(error) = &threads
        && !error.is_instance_of::<PyOverflowError>(count.py())
    {
        let kind = count.get_type().fully_qualified_name()?;
        let message = format!("Expected `count` to be a whole number, got {kind}.");
        return Err(PyTypeError::new_err(message));
    }
    let pool = match threads {
        Ok(1) => None,
        Ok(threads @ 2..=MOST_THREADS) => {
            let pool = ThreadPoolBuilder::new().num_threads(threads as usize).build();
            Some(Arc::new(
                pool.map_err(|error| PyValueError::new_err(format!("`count` = {count}: {error}")))?,
            ))
        }
        _ => {
            let message = format!("Expected `count` to be from 1 to {MOST_THREADS}, got {count}.");
            return Err(PyValueError::new_err(message));
        }
    };
    *POOL.lock().unwrap_or_else(PoisonError::into_inner) = pool;
    Ok(())
}

/// How many threads compute large calls.
#[pyfunction]
pub fn get_num_threads() -> usize {
    let pool = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    pool.as_ref().map_or(1, |pool| pool.current_num_threads())
}

/// In a child process after a fork: the threads of the pool are gone, and waiting for them would
/// never end.
#[pyfunction]
pub fn forget_threads() {
    std::mem::forget(POOL.lock().unwrap_or_else(PoisonError::into_inner).take());
}
