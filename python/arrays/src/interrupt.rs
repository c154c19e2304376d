//! [`Interrupt`]: Ctrl-C while a call computes.

use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// How often Python is asked for signals: a person does not notice the wait, and a call does not
/// notice the asking.
pub(crate) const PERIOD: Duration = Duration::from_millis(50);

/// Whether a signal's handler has raised an exception. The thread of the call asks, all of its
/// threads look.
#[derive(Debug)]
pub struct Interrupt {
    began: Instant,
    /// How many periods have been asked for.
    asked: AtomicU64,
    came: AtomicBool,
    raised: Mutex<Option<PyErr>>,
    /// The bits of the part of the call that is done, from 0 to 1.
    part: AtomicU64,
}

/// The function of Python that is told how much of a call is done.
static LISTENER: Mutex<Option<Py<PyAny>>> = Mutex::new(None);

/// `true` while the listener runs. Only the main thread runs it.
static TELLING: AtomicBool = AtomicBool::new(false);

/// The listener. Nothing is held while it runs, so it may call what is here.
fn listener(py: Python<'_>) -> Option<Py<PyAny>> {
    // A call that the listener makes does not tell it: it would never end.
    if TELLING.load(Ordering::Relaxed) {
        return None;
    }
    let listener = LISTENER.lock().unwrap_or_else(PoisonError::into_inner);
    listener.as_ref().map(|listener| listener.clone_ref(py))
}

/// Tell `callback` how much of each long call is done, a number from 0 to 1; None ends it. Returns
/// the callback that was told before.
#[pyfunction]
pub fn tell_progress(callback: Option<Py<PyAny>>) -> Option<Py<PyAny>> {
    std::mem::replace(&mut *LISTENER.lock().unwrap_or_else(PoisonError::into_inner), callback)
}

impl Interrupt {
    pub(crate) fn new() -> Self {
        Self {
            began: Instant::now(),
            asked: AtomicU64::new(0),
            came: AtomicBool::new(false),
            raised: Mutex::new(None),
            part: AtomicU64::new(0),
        }
    }

    /// Whether one came, as far as is known.
    pub fn came(&self) -> bool {
        self.came.load(Ordering::Relaxed)
    }

    /// Notes which part of the call is done.
    pub fn note(&self, part: f64) {
        self.part.store(part.to_bits(), Ordering::Relaxed);
    }

    /// Asks Python, if it is time. In the thread of the call, detached.
    pub(crate) fn ask(&self) {
        // What has been raised first ends the call.
        if self.came() {
            return;
        }
        let period = self.began.elapsed().as_millis() as u64 / PERIOD.as_millis() as u64;
        if period <= self.asked.load(Ordering::Relaxed) {
            return;
        }
        self.asked.store(period, Ordering::Relaxed);
        let signals = Python::attach(|py| {
            let threading = py.import("threading")?;
            let main = threading.call_method0("main_thread")?.getattr("ident")?;
            if main.eq(threading.call_method0("get_ident")?)? {
                py.check_signals()?;
                if let Some(listener) = listener(py) {
                    TELLING.store(true, Ordering::Relaxed);
                    let part = f64::from_bits(self.part.load(Ordering::Relaxed));
                    let told = listener.call1(py, (part,));
                    TELLING.store(false, Ordering::Relaxed);
                    told?;
                }
                return Ok(());
            }
            // Python handles signals in its main thread; another one would wait for the interpreter
            // in vain.
            self.asked.store(u64::MAX, Ordering::Relaxed);
            Ok(())
        });
        if let Err(error) = signals {
            *self.raised.lock().unwrap_or_else(PoisonError::into_inner) = Some(error);
            self.came.store(true, Ordering::Relaxed);
        }
    }

    /// What was raised.
    pub(crate) fn take(&self) -> Option<PyErr> {
        self.raised.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}
