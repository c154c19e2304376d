//! Values with names, as tables, records and dicts have them, in the order of a mechanism.

use crate::plain::{is_arrow, is_number, real};
use crate::shape::NUMBER;
use numpy::PyUntypedArray;
use pyo3::exceptions::PyValueError;
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyList, PyTuple};

/// Values as they were given: one array of all, or a column for each name, in order.
pub enum Named<'py> {
    Rows(Bound<'py, PyAny>),
    Columns(Vec<Bound<'py, PyAny>>),
}

/// The columns of `value` in the order of `names`, side by side in the last dimension; itself, if
/// its columns have no names or stand in that order.
pub fn in_order<'py>(
    name: &'static str,
    value: &Bound<'py, PyAny>,
    names: &dyn Fn() -> Vec<String>,
) -> PyResult<Bound<'py, PyAny>> {
    match named(name, value, names)? {
        Named::Rows(rows) => Ok(rows),
        Named::Columns(columns) => {
            side_by_side(value.py(), &columns).map_err(|error| misfit(name, &error))
        }
    }
}

/// [`in_order`], with the columns as they are.
pub fn named<'py>(
    name: &'static str,
    value: &Bound<'py, PyAny>,
    names: &dyn Fn() -> Vec<String>,
) -> PyResult<Named<'py>> {
    // Rows with names each.
    if let Ok(rows) = value.cast::<PyList>()
        && rows.get_item(0).is_ok_and(|row| matches!(labels(&row), Ok(Some(_))))
    {
        let rows =
            rows.iter().map(|row| in_order(name, &row, names)).collect::<PyResult<Vec<_>>>()?;
        return Ok(Named::Rows(PyList::new(value.py(), rows)?.into_any()));
    }
    let columns = columns_of_arrow(value)?;
    let value = columns.as_ref().unwrap_or(value);
    let Some(labels) = labels(value)? else { return Ok(Named::Rows(value.clone())) };
    let names = names();
    let given: Vec<_> = labels.iter().map(|label| label.extract::<String>().ok()).collect();
    let is_array = value.hasattr(intern!(value.py(), "__array__"))? && !has_fields(value)?;
    if is_array && given.iter().flatten().eq(&names) && given.len() == names.len() {
        return Ok(Named::Rows(value.clone()));
    }
    // Numbers in order are positions: a table without names has them.
    let positions: Result<Vec<i64>, _> = labels.iter().map(|label| label.extract()).collect();
    if let (true, Ok(positions)) = (is_array, positions)
        && positions.is_sorted()
    {
        return Ok(Named::Rows(value.clone()));
    }
    for (index, (label, own)) in labels.iter().zip(&given).enumerate() {
        let wrong = match own {
            Some(own) if !names.contains(own) => {
                format!("is not a {} of this mechanism", one(name))
            }
            Some(_) if given[..index].contains(own) => "is there twice".to_owned(),
            Some(_) => continue,
            None => format!("is no name of a {}", one(name)),
        };
        return Err(mismatch(name, &format!("the column {} {wrong}", label.repr()?), &names));
    }
    if let Some(missing) = names.iter().find(|&name| !given.iter().flatten().any(|it| it == name)) {
        return Err(mismatch(name, &format!("there is no column {missing:?}"), &names));
    }
    let columns = names.iter().map(|column| {
        let own = if value.is_instance_of::<PyTuple>() {
            value.getattr(column.as_str())?
        } else {
            value.get_item(column)?
        };
        // As NumPy takes Python's numbers: they have the precision of the others.
        if is_number(&own) {
            Ok(own)
        } else {
            real(&format!("{name}[{column:?}]"), NUMBER, &own).map(Bound::into_any)
        }
    });
    Ok(Named::Columns(columns.collect::<PyResult<_>>()?))
}

/// An error about columns of different shapes.
pub fn misfit(name: &str, error: &dyn std::fmt::Display) -> PyErr {
    PyValueError::new_err(format!("`{name}`: the columns do not fit each other: {error}"))
}

fn mismatch(name: &str, what: &str, names: &[String]) -> PyErr {
    let one = one(name);
    PyValueError::new_err(format!("`{name}`: {what}; the {one}s are {}.", names.join(", ")))
}

/// Returns the noun for a number of the argument `name`, for errors.
fn one(name: &str) -> &'static str {
    if name == "rates" { "rate" } else { "value" }
}

/// The columns of a table or of structs of Arrow by name; nothing if it is neither.
fn columns_of_arrow<'py>(value: &Bound<'py, PyAny>) -> PyResult<Option<Bound<'py, PyAny>>> {
    static COLUMNS: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    let py = value.py();
    if is_number(value) || value.is_instance_of::<PyUntypedArray>() || !is_arrow(value)? {
        return Ok(None);
    }
    let columns = COLUMNS.import(py, "dq8._arrow", "columns")?.call1((value,))?;
    Ok((!columns.is_none()).then_some(columns))
}

/// Single numbers are the same in all rows.
fn side_by_side<'py>(
    py: Python<'py>,
    columns: &[Bound<'py, PyAny>],
) -> PyResult<Bound<'py, PyAny>> {
    let numpy = py.import("numpy")?;
    let dtype = numpy.call_method1("result_type", PyTuple::new(py, columns)?)?;
    let columns = numpy.call_method1("broadcast_arrays", PyTuple::new(py, columns)?)?;
    let options = PyDict::new(py);
    options.set_item("axis", -1)?;
    numpy.call_method("stack", (columns,), Some(&options))?.call_method1("astype", (dtype,))
}

/// The names of the columns of `value`, if they have any.
fn labels<'py>(value: &Bound<'py, PyAny>) -> PyResult<Option<Vec<Bound<'py, PyAny>>>> {
    let py = value.py();
    let labels = if is_number(value) || value.is_instance_of::<PyList>() {
        return Ok(None);
    } else if has_fields(value)? {
        value.getattr("dtype")?.getattr("names")?
    } else if value.is_instance_of::<PyUntypedArray>() {
        return Ok(None);
    } else if let Some(fields) = value.getattr_opt(intern!(py, "_fields"))? {
        fields
    } else if let Some(names) = value.getattr_opt(intern!(py, "column_names"))? {
        names
    } else if value.hasattr(intern!(py, "keys"))? {
        value.call_method0(intern!(py, "keys"))?
    } else if let Some(columns) = value.getattr_opt(intern!(py, "columns"))? {
        columns
    } else {
        return Ok(None);
    };
    let Ok(labels) = labels.try_iter() else { return Ok(None) };
    labels.collect::<PyResult<_>>().map(Some)
}

/// Whether it is an array, or a record of one, whose elements have fields.
fn has_fields(value: &Bound<'_, PyAny>) -> PyResult<bool> {
    let py = value.py();
    let Some(dtype) = value.getattr_opt(intern!(py, "dtype"))? else { return Ok(false) };
    Ok(dtype
        .getattr_opt(intern!(py, "names"))?
        .is_some_and(|names| names.is_instance_of::<PyTuple>()))
}
