//! Many configurations of a mechanism, from arrays to arrays.

use crate::argument::{Argument, Input};
use crate::call::Answer;
use crate::error::{misshapen, value_error};
use crate::links::Chosen;
use crate::number::Number;
use crate::output::{Output, view_of_out};
use crate::shape::{EIGHT, tuple};
use crate::threads::{GRAIN, Threads};
use dq8::simd::MAX_LANES;
use dq8::{Backend, ShapeError};
use dq8_robot::{Body, Mechanism, OwnedMechanism, World, WorldAligned};
use numpy::prelude::*;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::sync::OnceLock;

/// In which axes, and about which point, a Jacobian is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Frame {
    World,
    Body,
    Aligned,
}

impl Frame {
    /// What Python calls so.
    pub(crate) fn of(name: &str) -> PyResult<Self> {
        match name {
            "world" => Ok(Self::World),
            "body" => Ok(Self::Body),
            "aligned" => Ok(Self::Aligned),
            _ => Err(PyValueError::new_err(format!(
                "Expected `frame` to be 'world', 'body' or 'aligned', got '{name}'."
            ))),
        }
    }
}

/// Configurations in memory, and their leading dimensions.
fn configurations<'py, R: Number>(
    mechanism: &OwnedMechanism<R>,
    values: &Argument<'py>,
) -> PyResult<(Input<'py, R>, Vec<usize>)> {
    let values = Input::<R>::of(values)?;
    let full = values.full_leading().to_vec();
    let count = mechanism.view().values();
    let Some((_, leading)) = full.split_last().filter(|&(&last, _)| last == count) else {
        return Err(misshapen("values", &format!("(..., {count})"), &full));
    };
    Ok((values.in_full()?, leading.to_vec()))
}

/// The poses of links at each configuration.
pub(crate) fn poses<'py, R: Number>(
    mechanism: &OwnedMechanism<R>,
    values: &Argument<'py>,
    chosen: Option<Chosen>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let (values, leading) = configurations(mechanism, values)?;
    let py = values.py();
    let view = mechanism.view();
    let mut shape = leading;
    let elements: usize = shape.iter().product::<usize>() * view.links();
    let threads = Threads::for_elements(elements);
    if !chosen.as_ref().is_some_and(|chosen| chosen.one) {
        shape.push(chosen.as_ref().map_or(view.links(), |chosen| chosen.links.len()));
    }
    let output = Output::<R>::new(py, out, &shape, EIGHT)?;
    let values = values.apart_from(&output)?;
    let numbers = values.records::<1>().as_flattened();
    let backend = Backend::best();
    let poses = |numbers: &[R], to: &mut [[R; 8]]| match &chosen {
        None => view.job().backend(backend).poses(numbers, to),
        Some(Chosen { links, .. }) => view.job().links(links).backend(backend).poses(numbers, to),
    };
    let links = chosen.as_ref().map_or(view.links(), |chosen| chosen.links.len());
    output.fill(&threads, |to| pieces(&threads, view, numbers, links, to, &poses))
}

/// The Jacobian of a link at each configuration.
pub(crate) fn jacobian<'py, R: Number>(
    mechanism: &OwnedMechanism<R>,
    values: &Argument<'py>,
    link: usize,
    frame: Frame,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let (values, leading) = configurations(mechanism, values)?;
    let py = values.py();
    let view = mechanism.view();
    let configurations: usize = leading.iter().product();
    let shape = [&leading[..], &[6, view.rates()]].concat();
    let transposed = out.map(|out| by_columns(out, &shape)).transpose()?;
    let output = Output::<R>::new(py, transposed.as_ref(), &leading, &[view.rates(), 6])?;
    let values = values.apart_from(&output)?;
    let numbers = values.records::<1>().as_flattened();
    let backend = Backend::best();
    let columns = |numbers: &[R], to: &mut [[R; 6]]| {
        let mut poses = vec![[R::ZERO; 8]; to.len() / view.rates()];
        macro_rules! jacobians {
            ($frame:expr) => {
                view.job()
                    .links(&[link])
                    .backend(backend)
                    .jacobians($frame, numbers, &mut poses, to)
            };
        }
        match frame {
            Frame::World => jacobians!(World),
            Frame::Body => jacobians!(Body),
            Frame::Aligned => jacobians!(WorldAligned),
        }
    };
    let threads = Threads::for_elements(configurations * view.links());
    let columns =
        output.fill(&threads, |to| pieces(&threads, view, numbers, view.rates(), to, &columns))?;
    match out {
        Some(out) => Ok(out.clone()),
        None => columns.call_method1("swapaxes", (-1, -2)),
    }
}

/// `out` as it is written: column after column.
fn by_columns<'py>(out: &Bound<'py, PyAny>, shape: &[usize]) -> Answer<'py> {
    let array = view_of_out(out)?;
    if array.shape() == shape {
        return array.call_method1("swapaxes", (-1, -2));
    }
    Err(misshapen("out", &format!("{}, that of the result", tuple(shape)), array.shape()))
}

/// Writes elements of some configurations.
type Compute<'f, R, const C: usize> =
    dyn Fn(&[R], &mut [[R; C]]) -> Result<(), ShapeError> + Sync + 'f;

/// `each` of the configurations in `numbers`, which writes `rows` elements of `to` for one; some together.
fn pieces<R: Number, const C: usize>(
    threads: &Threads,
    view: Mechanism<'_, R>,
    numbers: &[R],
    rows: usize,
    to: &mut [[R; C]],
    each: &Compute<'_, R, C>,
) -> PyResult<()> {
    if to.is_empty() {
        return Ok(());
    }
    let (failure, values) = (OnceLock::new(), view.values());
    // Whole registers.
    let size = rows * GRAIN.div_ceil(view.links()).next_multiple_of(MAX_LANES);
    threads.split(size, to, &|(first, to)| {
        let (first, count) = (first / rows, to.len() / rows);
        let numbers = &numbers[first * values..(first + count) * values];
        each(numbers, to).map_err(|error| failure.set(error)).is_ok()
    });
    failure.into_inner().map_or(Ok(()), |error| Err(value_error(error)))
}
