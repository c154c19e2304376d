//! [`Axis`]: the dimension that a function goes along. Kernels have it last, before the numbers of
//! an element.

use crate::argument::Argument;
use crate::call::Answer;
use crate::error::misshapen;
use crate::output::view_of_out;
use crate::shape::tuple;
use numpy::PyUntypedArrayMethods;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

/// A leading dimension, counted from the first.
#[derive(Clone, Copy, Debug)]
pub struct Axis(usize);

impl Axis {
    /// What Python calls so, of an array of elements whose shape is `expected`; from its last
    /// dimension where it is negative.
    pub fn of(array: &Argument<'_>, axis: isize, expected: &str) -> PyResult<Self> {
        let (name, shape) = (array.name(), array.shape());
        let Some(leading) = shape.strip_suffix(array.core()).filter(|it| !it.is_empty()) else {
            return Err(misshapen(name, expected, shape));
        };
        let from_start = if axis < 0 { axis.checked_add_unsigned(shape.len()) } else { Some(axis) };
        let from_start = from_start.and_then(|axis| usize::try_from(axis).ok());
        from_start.filter(|&axis| axis < leading.len()).map(Self).ok_or_else(|| {
            let shape = tuple(shape);
            PyValueError::new_err(format!(
                "Expected `axis` to be a leading dimension of `{name}`, whose shape is {shape}, got {axis}."
            ))
        })
    }

    /// `array` with `count` dimensions from this one on behind all others but the last `core`, as
    /// kernels have them.
    pub fn last<'py>(self, array: &Bound<'py, PyAny>, count: usize, core: usize) -> Answer<'py> {
        self.permuted(array, core, |axes| axes.rotate_left(count))
    }

    /// What a kernel has made, as Python has it: the other way.
    pub fn back<'py>(self, array: &Bound<'py, PyAny>, count: usize) -> Answer<'py> {
        self.permuted(array, 1, |axes| axes.rotate_right(count))
    }

    fn permuted<'py>(
        self,
        array: &Bound<'py, PyAny>,
        core: usize,
        permute: impl FnOnce(&mut [usize]),
    ) -> Answer<'py> {
        let count: usize = array.getattr("ndim")?.extract()?;
        let mut axes: Vec<usize> = (0..count).collect();
        let Some(moved) = axes.get_mut(self.0..count.saturating_sub(core)) else {
            return Ok(array.clone());
        };
        permute(moved);
        if axes.is_sorted() {
            return Ok(array.clone());
        }
        array.call_method1("transpose", PyTuple::new(array.py(), axes)?)
    }

    /// `shape` of what a kernel makes, as Python has it.
    fn shape(self, made: &[usize], count: usize) -> Vec<usize> {
        let mut shape = made.to_vec();
        if let Some(moved) = shape.get_mut(self.0..made.len().saturating_sub(1)) {
            moved.rotate_right(count);
        }
        shape
    }

    /// A result of a kernel, whose shape is `made`: what `write` makes of `out` as the kernel has
    /// it, as Python has it.
    pub fn written<'py>(
        self,
        out: Option<&Bound<'py, PyAny>>,
        made: &[usize],
        count: usize,
        write: impl FnOnce(Option<&Bound<'py, PyAny>>) -> Answer<'py>,
    ) -> Answer<'py> {
        let Some(out) = out else { return self.back(&write(None)?, count) };
        let (view, shape) = (view_of_out(out)?, self.shape(made, count));
        if view.shape() != shape {
            let expected = format!("{}, that of the result", tuple(&shape));
            return Err(misshapen("out", &expected, view.shape()));
        }
        write(Some(&self.last(view.as_any(), count, 1)?))?;
        Ok(out.clone())
    }
}
