//! Links and joints: their names and parents.

use crate::plain::check_whole;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyFrozenSet, PyIterator, PySet};
use std::collections::HashSet;

/// Links that were asked for.
#[derive(Debug)]
pub struct Chosen {
    pub links: Vec<usize>,
    /// Whether it was one, and no sequence.
    pub one: bool,
}

impl Chosen {
    /// The argument `links`, where links have these names.
    pub fn of(names: &[String], links: &Bound<'_, PyAny>) -> PyResult<Self> {
        if links.extract::<String>().is_ok() || links.extract::<i64>().is_ok() {
            return Ok(Self { links: vec![link_of(names, "links", links)?], one: true });
        }
        let links = in_order(links)?;
        let links = links.map(|link| link_of(names, "links", &link?)).collect::<PyResult<_>>()?;
        Ok(Self { links, one: false })
    }
}

/// The items of the argument `links`, in their order.
pub fn in_order<'py>(links: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyIterator>> {
    if links.is_instance_of::<PySet>() || links.is_instance_of::<PyFrozenSet>() {
        return Err(PyTypeError::new_err(
            "Expected `links` to be a sequence of links, got a set, which has no order: pass a list.",
        ));
    }
    links.try_iter().map_err(|_| not_a_link("links", links))
}

/// The names of so many links, each its own; numbers if none are given.
pub fn names(given: Option<Vec<String>>, count: usize) -> PyResult<Vec<String>> {
    let names = given.unwrap_or_else(|| (0..count).map(|link| link.to_string()).collect());
    check_names("links", &names, count)?;
    Ok(names)
}

/// Checks that there are so many names, each its own.
pub fn check_names(argument: &str, names: &[String], count: usize) -> PyResult<()> {
    let mut before = HashSet::with_capacity(names.len());
    let twice = names.iter().find(|&name| !before.insert(name));
    let message = if names.len() != count {
        format!("Expected `{argument}` to have {count} names, got {}.", names.len())
    } else if let Some(name) = twice {
        format!("`{argument}`: two have the name {name:?}.")
    } else {
        return Ok(());
    };
    Err(PyValueError::new_err(message))
}

/// The number of a link, from its name or number; from the end where it is negative.
pub fn link_of(names: &[String], argument: &str, link: &Bound<'_, PyAny>) -> PyResult<usize> {
    if let Ok(name) = link.extract::<String>() {
        return names.iter().position(|other| *other == name).ok_or_else(|| {
            PyValueError::new_err(format!("`{argument}`: there is no link {name:?}."))
        });
    }
    // A bool is a number of Python's, and never meant as one of a link.
    let index: i64 = match link.extract() {
        Ok(index) if !link.is_instance_of::<PyBool>() => index,
        _ => return Err(not_a_link(argument, link)),
    };
    let count = names.len();
    let from_start = if index < 0 { index + count as i64 } else { index };
    usize::try_from(from_start).ok().filter(|&link| link < count).ok_or_else(|| {
        let message = format!("`{argument}`: there is no link {index} among {count}.");
        PyValueError::new_err(message)
    })
}

fn not_a_link(argument: &str, given: &Bound<'_, PyAny>) -> PyErr {
    let kind = given.get_type();
    PyTypeError::new_err(format!(
        "Expected `{argument}` to name links or their numbers, got {kind}."
    ))
}

/// Parents as numbers of joints, −1 for a root.
pub fn parents_of(parents: &Bound<'_, PyAny>) -> PyResult<Vec<u32>> {
    check_whole("parents", parents)?;
    let given: Vec<Option<i64>> = parents.extract().map_err(|_| {
        PyTypeError::new_err("Expected `parents` to be a sequence of integers, −1 for a root.")
    })?;
    let parents = given.iter().map(|&parent| match parent.unwrap_or(-1) {
        -1 => Ok(dq8::Hierarchy::ROOT),
        parent => u32::try_from(parent)
            .ok()
            .filter(|&parent| parent != dq8::Hierarchy::ROOT)
            .ok_or(parent),
    });
    parents.collect::<Result<_, _>>().map_err(|parent| {
        PyValueError::new_err(format!("`parents`: {parent} is neither a joint nor −1."))
    })
}
