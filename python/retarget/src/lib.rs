//! The motion of a person on a humanoid robot. What users import is in `package/dq8/retarget.py`.

pub mod humanoid;
pub mod motion;
pub mod person;

use dq8_python_arrays::error::value_error;
use dq8_python_arrays::{argument, interrupt, links, shape, threads};
use dq8_retarget::RetargetError;
use interrupt::Interrupt;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::sync::{Arc, Mutex, PoisonError};

/// Returns the exception that an error becomes, with the keyword that mends it.
fn raised(error: &RetargetError) -> PyErr {
    let keyword = match error {
        RetargetError::NoRest => " (`rest=`)",
        RetargetError::NoLegs { .. } => " (`table=`)",
        RetargetError::TooLittle { .. } => " (`table=` of the robot, or of the clip)",
        _ => "",
    };
    value_error(format!("{error}{keyword}"))
}

/// What is done in another thread.
type Job = Box<dyn FnOnce(&Interrupt) + Send>;

/// Runs a job as [`watched`](threads::watched) does, which is compiled once for all results.
fn run<T: Send + 'static>(
    py: Python<'_>,
    job: impl FnOnce(&Interrupt) -> T + Send + 'static,
) -> PyResult<T> {
    let made = Arc::new(Mutex::new(None));
    let to = made.clone();
    let job: Job = Box::new(move |interrupt| {
        let done = Some(job(interrupt));
        *to.lock().unwrap_or_else(PoisonError::into_inner) = done;
    });
    threads::watched(py, job)?;
    let made = made.lock().unwrap_or_else(PoisonError::into_inner).take();
    made.ok_or_else(|| PyRuntimeError::new_err("nothing was computed"))
}
