//! All solutions of arms of six hinges.

use crate::argument::{Argument, is_single};
use crate::columns::in_order;
use crate::links::link_of;
use crate::mechanism::Mechanism;
use crate::shape::{EIGHT, NUMBER};
use dq8_python_ik::solutions::solutions as all;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

/// What `Mechanism.solutions` returns, in the order of `Solutions`.
#[pyfunction]
pub fn solutions<'py>(
    mechanism: &Bound<'py, Mechanism>,
    targets: &Bound<'py, PyAny>,
    values: &Bound<'py, PyAny>,
    link: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyTuple>> {
    let mechanism = mechanism.get();
    let targets = Argument::new("targets", EIGHT, targets)?;
    let values = in_order("values", values, &|| mechanism.values())?;
    let values = Argument::new("values", NUMBER, &values)?;
    let link = link_of(&mechanism.links, "link", link)?;
    let precision = mechanism.precision(is_single([&targets, &values]))?;
    all(precision, &targets, &values, link)
}
