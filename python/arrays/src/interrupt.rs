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
pub(crate) struct Interrupt {
    began: Instant,
    /// How many periods have been asked for.
    asked: AtomicU64,
    came: AtomicBool,
    raised: Mutex<Option<PyErr>>,
}

impl Interrupt {
    pub(crate) fn new() -> Self {
        Self {
            began: Instant::now(),
            asked: AtomicU64::new(0),
            came: AtomicBool::new(false),
            raised: Mutex::new(None),
        }
    }

    /// Whether one came, as far as is known.
    pub(crate) fn came(&self) -> bool {
        self.came.load(Ordering::Relaxed)
    }

    /// Asks Python, if it is time. In the thread of the call, detached.
    pub(crate) fn ask(&self) {
        let period = self.began.elapsed().as_millis() as u64 / PERIOD.as_millis() as u64;
        if period <= self.asked.load(Ordering::Relaxed) {
            return;
        }
        self.asked.store(period, Ordering::Relaxed);
        let signals = Python::attach(|py| {
            let threading = py.import("threading")?;
            let main = threading.call_method0("main_thread")?.getattr("ident")?;
            if main.eq(threading.call_method0("get_ident")?)? {
                return py.check_signals();
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
