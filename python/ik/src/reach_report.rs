//! What searches of inverse kinematics reached.

use crate::call::Answer;
use crate::number::Number;
use dq8::Real;
use dq8_robot::ik::{Outcome, Report};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict, PyTuple};

/// What `Mechanism.reach` reached: arrays of one shape, that of the targets and starts.
#[pyclass(frozen, module = "dq8")]
#[derive(Debug)]
pub struct ReachReport {
    /// Whether the errors are within the tolerances; bool.
    #[pyo3(get)]
    converged: Py<PyAny>,
    /// How searches ended, as numbers of `Outcome`; uint8.
    #[pyo3(get)]
    outcome: Py<PyAny>,
    /// Steps and restarts together; uint32.
    #[pyo3(get)]
    iterations: Py<PyAny>,
    /// How many of them were restarts; uint32.
    #[pyo3(get)]
    restarts: Py<PyAny>,
    /// The rotation that is left, radians; of several links the largest. NaN where the input is
    /// invalid. The dtype is that of the values, float32 or float64.
    #[pyo3(get)]
    angular_error: Py<PyAny>,
    /// The distance that is left, a length; of several links the largest. NaN where the input is
    /// invalid. The dtype is that of the values, float32 or float64.
    #[pyo3(get)]
    linear_error: Py<PyAny>,
}

#[pymethods]
impl ReachReport {
    /// Of the arrays that `to_dict` names, in their order.
    #[new]
    fn from_parts(
        converged: Py<PyAny>,
        outcome: Py<PyAny>,
        iterations: Py<PyAny>,
        restarts: Py<PyAny>,
        angular_error: Py<PyAny>,
        linear_error: Py<PyAny>,
    ) -> Self {
        Self { converged, outcome, iterations, restarts, angular_error, linear_error }
    }

    /// The arrays by their names, as columns of a table: ``pandas.DataFrame(report.to_dict())``
    /// where the shape is (n,).
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        NAMES.into_iter().zip(self.parts()).into_py_dict(py)
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        Ok((slf.get_type().into_any(), PyTuple::new(slf.py(), slf.get().parts())?))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let converged = self.converged.bind(py);
        let (reached, all) = (converged.call_method0("sum")?, converged.getattr("size")?);
        Ok(format!("<dq8.ReachReport: {reached} of {all} converged>"))
    }
}

/// Of the arrays of a report.
const NAMES: [&str; 6] =
    ["converged", "outcome", "iterations", "restarts", "angular_error", "linear_error"];

impl ReachReport {
    /// All arrays.
    fn parts(&self) -> [&Py<PyAny>; 6] {
        let Self { converged, outcome, iterations, restarts, angular_error, linear_error } = self;
        [converged, outcome, iterations, restarts, angular_error, linear_error]
    }

    /// Arrays of this shape.
    pub(crate) fn new<R: Number>(
        py: Python<'_>,
        columns: Columns<R>,
        shape: &[usize],
    ) -> PyResult<Self> {
        Ok(Self {
            converged: shaped(py, columns.converged, shape)?.unbind(),
            outcome: shaped(py, columns.outcome, shape)?.unbind(),
            iterations: shaped(py, columns.iterations, shape)?.unbind(),
            restarts: shaped(py, columns.restarts, shape)?.unbind(),
            angular_error: shaped(py, columns.angular_error, shape)?.unbind(),
            linear_error: shaped(py, columns.linear_error, shape)?.unbind(),
        })
    }
}

/// The reports of many searches, with one array for each field.
pub(crate) struct Columns<R> {
    converged: Vec<bool>,
    outcome: Vec<u8>,
    iterations: Vec<u32>,
    restarts: Vec<u32>,
    angular_error: Vec<R>,
    linear_error: Vec<R>,
}

impl<R: Number> Columns<R> {
    /// Makes room for `count` reports. The memory is zeroed, because the system hands out zeroed
    /// memory without touching it before a report is written.
    pub(crate) fn new(count: usize) -> Self {
        Self {
            converged: vec![false; count],
            outcome: vec![0; count],
            iterations: vec![0; count],
            restarts: vec![0; count],
            angular_error: vec![R::ZERO; count],
            linear_error: vec![R::ZERO; count],
        }
    }

    pub(crate) fn all(&mut self) -> Part<'_, R> {
        Part {
            converged: &mut self.converged,
            outcome: &mut self.outcome,
            iterations: &mut self.iterations,
            restarts: &mut self.restarts,
            angular_error: &mut self.angular_error,
            linear_error: &mut self.linear_error,
        }
    }
}

/// The room for a run of reports.
#[derive(Default)]
pub(crate) struct Part<'s, R> {
    converged: &'s mut [bool],
    outcome: &'s mut [u8],
    iterations: &'s mut [u32],
    restarts: &'s mut [u32],
    angular_error: &'s mut [R],
    linear_error: &'s mut [R],
}

impl<R: Real> Part<'_, R> {
    pub(crate) fn len(&self) -> usize {
        self.outcome.len()
    }

    /// Takes the room for the first `count` reports away.
    pub(crate) fn split_off(&mut self, count: usize) -> Self {
        Self {
            converged: self.converged.split_off_mut(..count).unwrap_or_default(),
            outcome: self.outcome.split_off_mut(..count).unwrap_or_default(),
            iterations: self.iterations.split_off_mut(..count).unwrap_or_default(),
            restarts: self.restarts.split_off_mut(..count).unwrap_or_default(),
            angular_error: self.angular_error.split_off_mut(..count).unwrap_or_default(),
            linear_error: self.linear_error.split_off_mut(..count).unwrap_or_default(),
        }
    }

    /// Writes reports, which may have another precision.
    pub(crate) fn write<S: Real>(self, reports: &[Report<S>]) {
        for (index, report) in reports.iter().enumerate() {
            self.converged[index] = report.outcome == Outcome::Converged;
            self.outcome[index] = report.outcome as u8;
            self.iterations[index] = report.iterations;
            self.restarts[index] = report.restarts;
            self.angular_error[index] = R::from_f64(report.angular_error.into());
            self.linear_error[index] = R::from_f64(report.linear_error.into());
        }
    }
}

/// Makes an array of this shape without copying the numbers; a scalar if there are no dimensions.
pub(crate) fn shaped<'py, T: numpy::Element>(
    py: Python<'py>,
    numbers: Vec<T>,
    shape: &[usize],
) -> Answer<'py> {
    let flat = PyArray1::from_vec(py, numbers);
    if shape.is_empty() {
        return flat.get_item(0);
    }
    flat.call_method1("reshape", (PyTuple::new(py, shape)?,))
}
