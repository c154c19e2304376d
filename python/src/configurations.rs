//! Many configurations of a mechanism, from arrays to arrays.

use crate::argument::{Argument, Input};
use crate::call::Answer;
use crate::error::{misshapen, value_error};
use crate::links::Chosen;
use crate::number::Number;
use crate::output::Output;
use crate::shape::{EIGHT, tuple};
use crate::threads::Threads;
use dq8::mechanism::{Body, JacobianFrame, Mechanism, OwnedMechanism, World, WorldAligned};
use dq8::{Backend, ShapeError};
use numpy::PyUntypedArray;
use numpy::prelude::*;
use pyo3::prelude::*;

/// In which axes, and about which point, a Jacobian is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Frame {
    World,
    Body,
    Aligned,
}

/// Configurations in memory, and their leading dimensions.
fn configurations<'py, R: Number>(
    mechanism: &OwnedMechanism<R>,
    values: Argument<'_, 'py>,
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
    values: Argument<'_, 'py>,
    chosen: Option<Chosen>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let (values, leading) = configurations(mechanism, values)?;
    let py = values.py();
    let view = mechanism.view();
    let mut shape = leading;
    let elements: usize = shape.iter().product::<usize>() * view.links();
    if !chosen.as_ref().is_some_and(|chosen| chosen.one) {
        shape.push(chosen.as_ref().map_or(view.links(), |chosen| chosen.links.len()));
    }
    let output = Output::<R>::new(py, out, &shape, EIGHT)?;
    let values = values.apart_from(&output)?;
    let numbers = values.records::<1>().as_flattened();
    let backend = Backend::best();
    output.fill(|to| {
        let threads = Threads::for_elements(elements);
        let done = match &chosen {
            _ if to.is_empty() => Ok(()),
            None if threads.many() => threads.install(|| view.job().backend(backend).threads(usize::MAX).poses(numbers, to)),
            None => view.job().backend(backend).poses(numbers, to),
            Some(Chosen { links, .. }) if threads.many() => {
                threads.install(|| view.job().links(links).backend(backend).threads(usize::MAX).poses(numbers, to))
            }
            Some(Chosen { links, .. }) => view.job().links(links).backend(backend).poses(numbers, to),
        };
        done.map_err(value_error)
    })
}

/// The Jacobian of a link at each configuration.
pub(crate) fn jacobian<'py, R: Number>(
    mechanism: &OwnedMechanism<R>,
    values: Argument<'_, 'py>,
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
    let columns = output.fill(|columns| {
        if columns.is_empty() {
            return Ok(());
        }
        let run = Jacobians { view, link, numbers, configurations };
        let done = match frame {
            Frame::World => run.write(World, columns),
            Frame::Body => run.write(Body, columns),
            Frame::Aligned => run.write(WorldAligned, columns),
        };
        done.map_err(value_error)
    })?;
    match out {
        Some(out) => Ok(out.clone()),
        None => columns.call_method1("swapaxes", (-1, -2)),
    }
}

/// `out` as it is written: column after column.
fn by_columns<'py>(out: &Bound<'py, PyAny>, shape: &[usize]) -> Answer<'py> {
    // What is no array is refused where other outputs are.
    let Ok(array) = out.cast::<PyUntypedArray>() else { return Ok(out.clone()) };
    if array.shape() == shape {
        return out.call_method1("swapaxes", (-1, -2));
    }
    Err(misshapen("out", &format!("{}, that of the result", tuple(shape)), array.shape()))
}

/// What Jacobians are computed of.
struct Jacobians<'a, R> {
    view: Mechanism<'a, R>,
    link: usize,
    numbers: &'a [R],
    configurations: usize,
}

impl<R: Number> Jacobians<'_, R> {
    fn write<F>(self, frame: F, columns: &mut [[R; 6]]) -> Result<(), ShapeError>
    where
        F: JacobianFrame + Send + Sync,
    {
        let Self { view, link, numbers, configurations } = self;
        let mut poses = vec![[R::ZERO; 8]; configurations];
        let threads = Threads::for_elements(configurations * view.links());
        let backend = Backend::best();
        if threads.many() {
            threads.install(|| {
                view.job().links(&[link]).backend(backend).threads(usize::MAX).jacobians(frame, numbers, &mut poses, columns)
            })
        } else {
            view.job().links(&[link]).backend(backend).jacobians(frame, numbers, &mut poses, columns)
        }
    }
}
