//! Many configurations of a mechanism, from arrays to arrays.

use crate::argument::{Argument, Input, is_single};
use crate::broadcast::common;
use crate::call::Answer;
use crate::columns::{Named, misfit, named};
use crate::error::{misshapen, value_error};
use crate::law::load;
use crate::links::Chosen;
use crate::number::Number;
use crate::output::{Output, view_of_out};
use crate::shape::{EIGHT, NUMBER, tuple};
use crate::threads::{GRAIN, Threads};
use dq8::simd::{MAX_LANES, Records};
use dq8::{Backend, Kernel, Lanes, Level, ShapeError};
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
struct Configurations<'py, R: Number> {
    /// All, or one for each value.
    inputs: Vec<Input<'py, R>>,
    /// The leading dimensions of all of them.
    leading: Vec<usize>,
}

impl<'py, R: Number> Configurations<'py, R> {
    fn of(mechanism: &OwnedMechanism<R>, values: &Values<'py>) -> PyResult<Self> {
        let columns = match values {
            Values::Columns(columns) if !columns.is_empty() => columns,
            Values::Columns(_) => return Err(misshapen("values", "(..., 0)", &[])),
            Values::Rows(rows) => {
                let input = Input::<R>::of(rows)?;
                let full = input.full_leading().to_vec();
                let count = mechanism.view().values();
                let Some((_, leading)) = full.split_last().filter(|&(&last, _)| last == count)
                else {
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

    fn apart_from(mut self, output: &Output<'py, R>) -> PyResult<Self> {
        self.inputs =
            self.inputs.into_iter().map(|it| it.apart_from(output)).collect::<PyResult<_>>()?;
        Ok(self)
    }

    fn numbers(&self) -> Numbers<'_, R> {
        self.inputs.iter().map(|input| input.records::<1>().as_flattened()).collect()
    }
}

/// All numbers, or those of each value.
type Numbers<'s, R> = Vec<&'s [R]>;

/// The configurations `range` of numbers, `values` for each, side by side; in `made` where they are columns.
fn rows<'s, R: Number>(
    numbers: &Numbers<'s, R>,
    values: usize,
    range: std::ops::Range<usize>,
    made: &'s mut Vec<R>,
) -> &'s [R] {
    if let [rows] = numbers[..] {
        return &rows[range.start * values..range.end * values];
    }
    made.resize(range.len() * values, R::ZERO);
    let columns: Numbers<'_, R> = numbers.iter().map(|all| &all[range.clone()]).collect();
    Backend::best().run(SideBySide { columns: &columns, to: made });
    made
}

/// Rows of columns: of four columns at a time as many rows as lanes, which leave in whole quads.
struct SideBySide<'s, R> {
    columns: &'s [&'s [R]],
    to: &'s mut [R],
}

impl<R: Number> Kernel for SideBySide<'_, R> {
    type Output = ();
    const WIDE: bool = false;

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { columns, to } = self;
        let (values, lanes) = (columns.len(), R::Lanes::<V>::LANES);
        let rows = to.len() / values;
        let whole = if values < 4 { 0 } else { rows - rows % lanes };
        let (groups, rest) = to.split_at_mut(whole * values);
        for begin in (0..values).step_by(4) {
            // The last four begin earlier where there is no multiple of four.
            let begin = begin.min(values.saturating_sub(4));
            let Some(&quad) = columns.get(begin..).and_then(|rest| rest.first_chunk::<4>()) else {
                break;
            };
            // In step: nothing is looked up or checked in the loop.
            let [a, b, c, d] = quad.map(|column| column.chunks_exact(lanes));
            let groups = groups.chunks_exact_mut(lanes * values);
            for (((a, b), (c, d)), to) in a.zip(b).zip(c.zip(d)).zip(groups) {
                let mut quad = [R::Lanes::<V>::splat(level, R::ZERO); 4];
                for (slot, column) in quad.iter_mut().zip([a, b, c, d]) {
                    let Some([loaded]) = load(level, column.as_chunks().0) else { return };
                    *slot = loaded;
                }
                R::Lanes::<V>::store_rows([quad], &mut to[begin..], values);
            }
        }
        for (row, to) in (whole..).zip(rest.chunks_exact_mut(values)) {
            for (slot, column) in to.iter_mut().zip(columns) {
                *slot = column[row];
            }
        }
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
    let numbers = values.numbers();
    let backend = Backend::best();
    let poses = |numbers: &[R], to: &mut [[R; 8]]| match &chosen {
        None => view.job().backend(backend).poses(numbers, to),
        Some(Chosen { links, .. }) => view.job().links(links).backend(backend).poses(numbers, to),
    };
    let links = chosen.as_ref().map_or(view.links(), |chosen| chosen.links.len());
    output.fill(&threads, |to| pieces(&threads, view, &numbers, links, to, &poses))
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
    let numbers = values.numbers();
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
        output.fill(&threads, |to| pieces(&threads, view, &numbers, view.rates(), to, &columns))?;
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

/// Rows of so many bytes are made of columns at a time: they are in a near cache when they are read, and beginning with
/// others, which takes a fifth of a microsecond, is seldom.
const MADE: usize = 1 << 15;

/// `each` of the configurations in `numbers`, which writes `count` elements of `to` for one; some together.
fn pieces<R: Number, const C: usize>(
    threads: &Threads,
    view: Mechanism<'_, R>,
    numbers: &Numbers<'_, R>,
    count: usize,
    to: &mut [[R; C]],
    each: &Compute<'_, R, C>,
) -> PyResult<()> {
    if to.is_empty() {
        return Ok(());
    }
    let (failure, values) = (OnceLock::new(), view.values());
    // Whole registers.
    let size = count * GRAIN.div_ceil(view.links()).next_multiple_of(MAX_LANES);
    let few = (MADE / (values.max(1) * size_of::<R>())).next_multiple_of(8 * MAX_LANES);
    // Memory for rows is got once for some of them.
    let size = if numbers.len() == 1 { size } else { 4 * size.max(count * few) };
    threads.split(size, to, &|(first, to)| {
        let mut made = Vec::new();
        let together = if numbers.len() == 1 { to.len() } else { count * few };
        to.chunks_mut(together).enumerate().all(|(index, to)| {
            let begin = (first + index * together) / count;
            let range = begin..begin + to.len() / count;
            each(rows(numbers, values, range, &mut made), to)
                .map_err(|error| failure.set(error))
                .is_ok()
        })
    });
    failure.into_inner().map_or(Ok(()), |error| Err(value_error(error)))
}
