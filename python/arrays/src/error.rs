//! Errors that Python raises.

use crate::shape::tuple;
use pyo3::PyErr;
use pyo3::exceptions::PyValueError;

/// What the library or NumPy says.
pub fn value_error(error: impl ToString) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// An argument of another shape than expected.
pub fn misshapen(name: &str, expected: &str, given: &[usize]) -> PyErr {
    let given = tuple(given);
    PyValueError::new_err(format!("Expected `{name}` to have shape {expected}, got {given}."))
}
