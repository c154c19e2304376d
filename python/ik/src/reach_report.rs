//! What searches of inverse kinematics reached.

use crate::call::Answer;
use crate::number::Number;
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
    pub fn new<R: Number>(
        py: Python<'_>,
        reports: &[Report<R>],
        shape: &[usize],
    ) -> PyResult<Self> {
        Ok(Self {
            converged: array(py, reports, shape, |it| it.outcome == Outcome::Converged)?,
            outcome: array(py, reports, shape, |it| it.outcome as u8)?,
            iterations: array(py, reports, shape, |it| it.iterations)?,
            restarts: array(py, reports, shape, |it| it.restarts)?,
            angular_error: array(py, reports, shape, |it| it.angular_error)?,
            linear_error: array(py, reports, shape, |it| it.linear_error)?,
        })
    }
}

/// One thing of each of `all`; a scalar where there are no dimensions.
pub(crate) fn array<S, T: numpy::Element>(
    py: Python<'_>,
    all: &[S],
    shape: &[usize],
    of: impl Fn(&S) -> T,
) -> PyResult<Py<PyAny>> {
    let flat = PyArray1::from_iter(py, all.iter().map(of));
    let array: Answer<'_> = if shape.is_empty() {
        flat.get_item(0)
    } else {
        flat.call_method1("reshape", (PyTuple::new(py, shape)?,))
    };
    Ok(array?.unbind())
}
