//! Many configurations of a mechanism, from arrays to arrays.

use crate::argument::{Argument, Input, is_single};
use crate::broadcast::common;
use crate::call::Answer;
use crate::columns::{Named, misfit, named};
use crate::error::{misshapen, value_error};
use crate::links::Chosen;
use crate::number::Number;
use crate::output::{Output, view_of_out};
use crate::shape::{EIGHT, NUMBER, tuple};
use crate::threads::{GRAIN, Threads};
use dq8::simd::MAX_LANES;
use dq8::{Backend, ShapeError};
use dq8_robot::{Body, Job, Mechanism, OwnedMechanism, World, WorldAligned};
use numpy::prelude::*;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::borrow::Cow;
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

    /// Writes the Jacobians of the link of a job, and its poses.
    pub(crate) fn jacobians<R: Number>(
        self,
        job: &Job<'_, R, &[usize]>,
        values: &[R],
        poses: &mut [[R; 8]],
        columns: &mut [[R; 6]],
    ) -> Result<(), ShapeError> {
        match self {
            Self::World => job.jacobians(World, values, poses, columns),
            Self::Body => job.jacobians(Body, values, poses, columns),
            Self::Aligned => job.jacobians(WorldAligned, values, poses, columns),
        }
    }
}

/// Configurations: one array, or an array for each value.
pub(crate) enum Values<'py> {
    Rows(Argument<'py>),
    Columns(Vec<Argument<'py>>),
}

impl<'py> Values<'py> {
    /// What the caller called `values`, of a mechanism with these names.
    pub(crate) fn of(value: &Bound<'py, PyAny>, names: &dyn Fn() -> Vec<String>) -> PyResult<Self> {
        let argument = |value: &_| Argument::new("values", NUMBER, value);
        Ok(match named("values", value, names)? {
            Named::Rows(rows) => Self::Rows(argument(&rows)?),
            Named::Columns(columns) => {
                Self::Columns(columns.iter().map(argument).collect::<PyResult<_>>()?)
            }
        })
    }

    /// Whether they are `f32`.
    pub(crate) fn is_single(&self) -> bool {
        match self {
            Self::Rows(rows) => is_single([rows]),
            Self::Columns(columns) => is_single(columns),
        }
    }
}

/// Configurations in memory.
pub(crate) struct Configurations<'py, R: Number> {
    /// One for each value, or one of all.
    inputs: Vec<Input<'py, R>>,
    /// The leading dimensions of all of them.
    pub(crate) leading: Vec<usize>,
}

impl<'py, R: Number> Configurations<'py, R> {
    pub(crate) fn of(mechanism: &OwnedMechanism<R>, values: &Values<'py>) -> PyResult<Self> {
        let columns = match values {
            Values::Columns(columns) if !columns.is_empty() => columns,
            Values::Columns(_) => return Err(misshapen("values", "(..., 0)", &[])),
            Values::Rows(rows) => {
                let input = Input::<R>::of(rows)?;
                let full = input.full_leading().to_vec();
                let count = mechanism.view().values();
                // Arrow's lists of no rows do not say how long they are.
                let fits = |&(&last, _): &(&usize, _)| last == count || full == [0, 0];
                let Some((_, leading)) = full.split_last().filter(fits) else {
                    return Err(misshapen("values", &format!("(..., {count})"), &full));
                };
                return Ok(Self { inputs: vec![input.in_full()?], leading: leading.to_vec() });
            }
        };
        let inputs = columns.iter().map(Input::<R>::of).collect::<PyResult<Vec<_>>>()?;
        let shapes = || inputs.iter().map(Input::full_leading);
        let leading = common(shapes()).ok_or_else(|| {
            let shapes: Vec<_> = shapes().map(tuple).collect();
            misfit("values", &shapes.join(", "))
        })?;
        let inputs = inputs.into_iter().map(|it| it.filled(&leading)).collect::<PyResult<_>>()?;
        Ok(Self { inputs, leading })
    }

    /// With `count` values in memory for each of `shape`, to which the leading dimensions
    /// broadcast.
    pub(crate) fn filled(self, shape: &[usize], count: usize) -> PyResult<Self> {
        if self.leading == shape {
            return Ok(self);
        }
        let inputs = self.inputs.into_iter().map(|input| {
            // Rows have a dimension more than columns.
            let of_one: &[usize] =
                if input.full_leading().len() > self.leading.len() { &[count] } else { &[] };
            input.filled(&[shape, of_one].concat())
        });
        Ok(Self { inputs: inputs.collect::<PyResult<_>>()?, leading: shape.to_vec() })
    }

    pub(crate) fn apart_from(mut self, output: &Output<'py, R>) -> PyResult<Self> {
        self.inputs =
            self.inputs.into_iter().map(|it| it.apart_from(output)).collect::<PyResult<_>>()?;
        Ok(self)
    }

    pub(crate) fn given(&self) -> Given<'_, R> {
        // The column of an only value holds rows of one number.
        match &self.inputs[..] {
            [rows] => Given::Rows(rows.numbers()),
            columns => Given::Columns(columns.iter().map(Input::numbers).collect()),
        }
    }
}

/// Some configurations: side by side, or a slice for each value.
pub(crate) enum Given<'s, R> {
    Rows(&'s [R]),
    Columns(Vec<&'s [R]>),
}

/// The number of configurations that columns are put together for at once.
const BLOCK: usize = 64;

impl<'s, R: Number> Given<'s, R> {
    /// Returns the configurations in `range`, `values` numbers each, side by side. Columns are put
    /// together piece by piece, in the cache: kernels that read columns where they lie would make
    /// the compiled code of all these functions twice as large.
    pub(crate) fn part(&self, values: usize, range: std::ops::Range<usize>) -> Cow<'s, [R]> {
        let all = match self {
            Self::Rows(rows) => return rows[range.start * values..range.end * values].into(),
            Self::Columns(all) => all,
        };
        let mut rows = vec![R::ZERO; range.len() * values];
        // Few rows at a time: all their columns are put in while they are in the first cache.
        for (block, rows) in rows.chunks_mut(BLOCK * values).enumerate() {
            for (index, column) in all.iter().enumerate() {
                let column = &column[range.start + BLOCK * block..range.end];
                for (row, &from) in rows.chunks_exact_mut(values).zip(column) {
                    row[index] = from;
                }
            }
        }
        rows.into()
    }
}

/// The poses of links at each configuration.
pub(crate) fn poses<'py, R: Number>(
    py: Python<'py>,
    mechanism: &OwnedMechanism<R>,
    values: &Values<'py>,
    chosen: Option<Chosen>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let values = Configurations::of(mechanism, values)?;
    let view = mechanism.view();
    let mut shape = values.leading.clone();
    let elements: usize = shape.iter().product::<usize>() * view.links();
    let threads = Threads::for_elements(elements);
    if !chosen.as_ref().is_some_and(|chosen| chosen.one) {
        shape.push(chosen.as_ref().map_or(view.links(), |chosen| chosen.links.len()));
    }
    let output = Output::<R>::new(py, out, &shape, EIGHT)?;
    let values = values.apart_from(&output)?;
    let given = values.given();
    let job = view.job().backend(Backend::best());
    let poses = |values: &[R], to: &mut [[R; 8]]| match &chosen {
        None => job.poses(values, to),
        Some(chosen) => job.links(&chosen.links).poses(values, to),
    };
    let links = chosen.as_ref().map_or(view.links(), |chosen| chosen.links.len());
    output.fill(&threads, |to| pieces(&threads, view, &given, links, to, &poses))
}

/// The Jacobian of a link at each configuration.
pub(crate) fn jacobian<'py, R: Number>(
    py: Python<'py>,
    mechanism: &OwnedMechanism<R>,
    values: &Values<'py>,
    link: usize,
    frame: Frame,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let values = Configurations::of(mechanism, values)?;
    let leading = values.leading.clone();
    let view = mechanism.view();
    let configurations: usize = leading.iter().product();
    let shape = [&leading[..], &[6, view.rates()]].concat();
    let transposed = out.map(|out| by_columns(out, &shape)).transpose()?;
    let output = Output::<R>::new(py, transposed.as_ref(), &leading, &[view.rates(), 6])?;
    let values = values.apart_from(&output)?;
    let given = values.given();
    let links = [link];
    let job = view.job().links(&links).backend(Backend::best());
    let columns = |values: &[R], to: &mut [[R; 6]]| {
        let mut poses = vec![[R::ZERO; 8]; to.len() / view.rates()];
        frame.jacobians(&job, values, &mut poses, to)
    };
    let threads = Threads::for_elements(configurations * view.links());
    let columns =
        output.fill(&threads, |to| pieces(&threads, view, &given, view.rates(), to, &columns))?;
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

/// Returns the number of configurations of a piece, which fill whole registers.
pub(crate) fn configurations_per_piece<R: Number>(view: Mechanism<'_, R>) -> usize {
    GRAIN.div_ceil(view.links()).next_multiple_of(MAX_LANES)
}

/// `each` of the configurations, which writes `count` elements of `to` for one; some together.
fn pieces<R: Number, const C: usize>(
    threads: &Threads,
    view: Mechanism<'_, R>,
    given: &Given<'_, R>,
    count: usize,
    to: &mut [[R; C]],
    each: &Compute<'_, R, C>,
) -> PyResult<()> {
    if to.is_empty() {
        return Ok(());
    }
    let failure = OnceLock::new();
    let size = count * configurations_per_piece(view);
    threads.split(size, to, &|(first, to)| {
        let range = first / count..(first + to.len()) / count;
        each(&given.part(view.values(), range), to).map_err(|error| failure.set(error)).is_ok()
    });
    failure.into_inner().map_or(Ok(()), |error| Err(value_error(error)))
}
