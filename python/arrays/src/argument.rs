//! Arguments: arrays of `f32` or `f64`.

use crate::axis::Axis;
use crate::cure::of_another_kind;
use crate::number::Number;
use crate::output::Output;
use crate::plain::{held, is_number, real, view};
use numpy::prelude::*;
use numpy::{PyArrayDescrMethods, PyArrayDyn, PyReadonlyArrayDyn, PyUntypedArray};
use pyo3::exceptions::{PyOverflowError, PyValueError};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::{PyTuple, PyWeakrefReference};

/// An argument of a call. All are made before one becomes an [`Input`]: code of the caller may run
/// when one is made ([`plain`](crate::plain::plain)), and none does afterwards.
#[derive(Clone, Debug)]
pub struct Argument<'py> {
    name: &'static str,
    /// The last dimensions, of one element.
    core: &'static [usize],
    array: Bound<'py, PyUntypedArray>,
    /// Whether it was one of Python's own numbers.
    number: bool,
}

impl<'py> Argument<'py> {
    /// What the caller called `name`.
    pub fn new(
        name: &'static str,
        core: &'static [usize],
        value: &Bound<'py, PyAny>,
    ) -> PyResult<Self> {
        // SciPy's rotations, where rotations are asked for.
        if name == "rotations"
            && let Some(as_quat) = value.getattr_opt(intern!(value.py(), "as_quat"))?
        {
            return Self::new(name, core, &as_quat.call0()?);
        }
        Ok(Self { name, core, array: real(name, core, value)?, number: is_number(value) })
    }

    /// All of a call: names, shapes of elements, values.
    pub fn all(
        given: &[(&'static str, &'static [usize], &Bound<'py, PyAny>)],
    ) -> PyResult<Vec<Self>> {
        given.iter().map(|&(name, core, value)| Self::new(name, core, value)).collect()
    }

    /// Its name in errors.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// The last dimensions, of one element.
    pub fn core(&self) -> &'static [usize] {
        self.core
    }

    /// The same with elements of another shape.
    pub fn of_elements(self, core: &'static [usize]) -> Self {
        Self { core, ..self }
    }

    /// The same with `axis` behind all others but those of an element.
    pub fn along(self, axis: Axis) -> PyResult<Self> {
        let array = axis.last(self.array.as_any(), 1, self.core.len())?;
        Ok(Self { array: array.cast_into()?, ..self })
    }

    /// The shape of the array.
    pub fn shape(&self) -> &[usize] {
        self.array.shape()
    }

    /// Its dtype, as NumPy abbreviates it: kind and bytes.
    pub fn dtype(&self) -> (u8, usize) {
        let dtype = self.array.dtype();
        (dtype.kind(), dtype.itemsize())
    }
}

/// An argument as memory: one element after the other. What is checked is a view that nobody else
/// has, so it stays as it was checked.
pub struct Input<'py, R: Number> {
    array: PyReadonlyArrayDyn<'py, R>,
    /// The dimensions before those of one element, and 1 for what has no stride.
    leading: Vec<usize>,
    full_leading: Vec<usize>,
    _held: Option<Bound<'py, PyWeakrefReference>>,
}

impl<'py, R: Number> Input<'py, R> {
    /// The array of an argument, without a copy if it lies one element after the other, for a call
    /// during which other threads of Python run.
    pub fn of(argument: &Argument<'py>) -> PyResult<Self> {
        Ok(Self::attached(argument)?.held())
    }

    /// [`of`](Self::of), before it is known whether they do.
    pub fn attached(argument: &Argument<'py>) -> PyResult<Self> {
        R::attached(argument)
    }

    pub(crate) fn read(argument: &Argument<'py>) -> PyResult<Self> {
        let py = argument.array.py();
        let view = view(&argument.array)?;
        let array = match view.cast_into::<PyArrayDyn<R>>() {
            Ok(array) => array,
            Err(other) => {
                // Other dtypes and byte orders are converted.
                let other = real(argument.name, argument.core, &other.into_inner())?;
                other.call_method1("astype", (numpy::dtype::<R>(py),))?.cast_into()?
            }
        };
        let shape = array.shape();
        let Some(leading) = shape.strip_suffix(argument.core) else {
            return Err(of_another_kind(argument.name, argument.core, shape));
        };
        let full_leading = leading.to_vec();
        let mut leading = full_leading.clone();
        let array = if array.is_c_contiguous() && array.data().is_aligned() {
            array
        } else {
            // A dimension without a stride is one element, repeated: so it is treated.
            let mut once = array.clone().into_any();
            for (axis, size) in leading.iter_mut().enumerate() {
                if *size > 1 && array.strides()[axis] == 0 {
                    *size = 1;
                    let mut index = vec![whole(py); axis];
                    index.push(pyo3::types::PySlice::new(py, 0, 1, 1).into_any());
                    once = once.get_item(PyTuple::new(py, index)?)?;
                }
            }
            // A copy is aligned as well.
            once.call_method1("copy", ("C",))?.cast_into()?
        };
        let array = borrow(&array, argument.name)?;
        array.as_slice().map_err(|error| {
            PyValueError::new_err(format!("`{}` cannot be read: {error}", argument.name))
        })?;
        Ok(Self { array, leading, full_leading, _held: None })
    }

    /// Such that other threads of Python cannot resize it.
    pub fn held(self) -> Self {
        Self { _held: held(self.array.as_any()), ..self }
    }

    /// The dimensions before those of one element; 1 for one whose elements are all the same.
    pub fn leading(&self) -> &[usize] {
        &self.leading
    }

    /// The interpreter.
    pub fn py(&self) -> Python<'py> {
        self.array.py()
    }

    /// The shape of the argument.
    pub fn shape(&self) -> Vec<usize> {
        let core = &self.array.shape()[self.leading.len()..];
        [&self.full_leading[..], core].concat()
    }

    /// The leading dimensions of the argument, where [`leading`](Self::leading) may have a 1 for
    /// one that has no stride.
    pub fn full_leading(&self) -> &[usize] {
        &self.full_leading
    }

    /// Whether there is one element for all.
    pub fn is_one(&self) -> bool {
        self.leading.iter().all(|&size| size == 1)
    }

    /// Whether this is the very memory of a result of the same shape.
    pub fn is(&self, out: &Output<'py, R>) -> bool {
        self.array.data().addr() == out.memory().data().addr()
    }

    /// The elements.
    pub fn records<const C: usize>(&self) -> &[[R; C]] {
        self.numbers().as_chunks().0
    }

    /// The numbers of all elements.
    pub fn numbers(&self) -> &[R] {
        // That it is a slice was checked when it was made.
        self.array.as_slice().unwrap_or_default()
    }

    /// How many numbers an element has.
    pub fn size(&self) -> usize {
        self.array.shape()[self.leading.len()..].iter().product()
    }

    /// Whether its memory is part of that of `other`.
    fn overlaps<S: Number>(&self, other: &Bound<'py, PyArrayDyn<S>>) -> bool {
        let own = self.array.data().addr()..self.array.data().addr() + bytes(&self.array);
        let (low, high) = extent(other);
        own.start < high && low < own.end
    }

    /// The same numbers elsewhere, if they lie where `out` is about to be written.
    pub fn apart_from<S: Number>(self, out: &Output<'py, S>) -> PyResult<Self> {
        let Some(given) = out.given() else { return Ok(self) };
        if !self.overlaps(given) {
            return Ok(self);
        }
        let copy = self.array.call_method0("copy")?.cast_into::<PyArrayDyn<R>>()?;
        Ok(Self { array: copy.readonly(), ..self })
    }

    /// With an element in memory for each of its own leading dimensions.
    pub fn in_full(self) -> PyResult<Self> {
        let shape = self.full_leading.clone();
        self.filled(&shape)
    }

    /// With an element in memory for each of `shape`, to which the leading dimensions broadcast.
    pub fn filled(self, shape: &[usize]) -> PyResult<Self> {
        if self.leading == shape { Ok(self) } else { R::filled(self, shape) }
    }

    pub(crate) fn repeated(self, shape: &[usize]) -> PyResult<Self> {
        let py = self.array.py();
        let mut full = shape.to_vec();
        full.extend_from_slice(&self.array.shape()[self.leading.len()..]);
        let full = PyTuple::new(py, full)?;
        let all = py.import("numpy")?.call_method1("broadcast_to", (&*self.array, full))?;
        let all = all.call_method1("copy", ("C",))?;
        let array = all.cast_into::<PyArrayDyn<R>>()?.readonly();
        let leading = shape.to_vec();
        Ok(Self { array, full_leading: leading.clone(), leading, _held: None })
    }
}

/// Whether a call computes in `f32`: if all its arrays are `f32` or narrower. Python's numbers do
/// not count.
pub fn is_single<'a, 'py: 'a>(arguments: impl IntoIterator<Item = &'a Argument<'py>>) -> bool {
    let mut arrays = arguments.into_iter().filter(|argument| !argument.number).peekable();
    arrays.peek().is_some() && arrays.all(|array| matches!(array.dtype(), (b'f', 2 | 4)))
}

fn borrow<'py, R: Number>(
    array: &Bound<'py, PyArrayDyn<R>>,
    name: &str,
) -> PyResult<PyReadonlyArrayDyn<'py, R>> {
    array.try_readonly().map_err(|error| {
        PyValueError::new_err(format!("`{name}` is being written by another thread: {error}"))
    })
}

/// The slice `:`.
fn whole(py: Python<'_>) -> Bound<'_, PyAny> {
    pyo3::types::PySlice::full(py).into_any()
}

fn bytes<R: Number>(array: &Bound<'_, PyArrayDyn<R>>) -> usize {
    array.len() * size_of::<R>()
}

/// The addresses between which the numbers of an array lie.
fn extent<R: Number>(array: &Bound<'_, PyArrayDyn<R>>) -> (usize, usize) {
    let (mut low, mut high) = (array.data().addr(), array.data().addr() + size_of::<R>());
    for (&size, &stride) in array.shape().iter().zip(array.strides()) {
        let reach = stride.unsigned_abs() * size.saturating_sub(1);
        if stride < 0 {
            low -= reach;
        } else {
            high += reach;
        }
    }
    (low, high)
}

/// The line of docstrings that says the dtype of results, where [`is_single`] decides it of all
/// arguments.
#[macro_export]
macro_rules! common_dtype {
    () => {
        "    float32 if all arrays are float32 or float16, otherwise float64."
    };
}
pub use crate::common_dtype;

/// The argument `max_iterations`. Python's own error for a number that is out of range names
/// neither the argument nor the range.
pub fn iterations(count: &Bound<'_, PyAny>) -> PyResult<u32> {
    count.extract().map_err(|error: PyErr| {
        if !error.is_instance_of::<PyOverflowError>(count.py()) {
            return error;
        }
        let most = u32::MAX;
        PyOverflowError::new_err(format!(
            "Expected `max_iterations` to be from 0 to {most}, got {count}."
        ))
    })
}
