//! Python objects as arrays of `f32` or `f64`.

use dq8::Scalar;
use numpy::prelude::*;
use numpy::{Element, PyArrayDyn, PyReadonlyArrayDyn, PyReadwriteArrayDyn, PyUntypedArray};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyInt, PyTuple};

/// A number that NumPy has too.
pub(crate) trait Number: Scalar + Element {}
impl Number for f32 {}
impl Number for f64 {}

/// An argument of a call.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Argument<'a, 'py> {
    pub(crate) name: &'static str,
    /// The last dimensions, of one element.
    pub(crate) core: &'static [usize],
    pub(crate) value: &'a Bound<'py, PyAny>,
}

impl<'a, 'py> Argument<'a, 'py> {
    /// An argument that is there.
    pub(crate) fn new(
        name: &'static str,
        core: &'static [usize],
        value: &'a Bound<'py, PyAny>,
    ) -> Option<Self> {
        Some(Self { name, core, value })
    }
}

/// An argument as memory: one element after the other.
pub(crate) struct Input<'py, R: Number> {
    array: PyReadonlyArrayDyn<'py, R>,
    /// The dimensions before those of one element, and 1 for what has no stride.
    leading: Vec<usize>,
    full_leading: Vec<usize>,
}

impl<'py, R: Number> Input<'py, R> {
    /// The array of an argument, without a copy if it lies one element after the other.
    pub(crate) fn of(argument: Argument<'_, 'py>) -> PyResult<Self> {
        let py = argument.value.py();
        let array = match argument.value.cast_exact::<PyArrayDyn<R>>() {
            Ok(array) => array.clone(),
            Err(_) => convert::<R>(argument)?,
        };
        let shape = array.shape();
        let Some(leading) = shape.strip_suffix(argument.core) else {
            return Err(PyValueError::new_err(format!(
                "Expected `{}` to have shape {}, got {}.",
                argument.name,
                pattern(argument.core),
                tuple(shape)
            )));
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
        Ok(Self { array, leading, full_leading })
    }

    /// The dimensions before those of one element; 1 for one whose elements are all the same.
    pub(crate) fn leading(&self) -> &[usize] {
        &self.leading
    }

    /// The interpreter.
    pub(crate) fn py(&self) -> Python<'py> {
        self.array.py()
    }

    /// The shape of the argument.
    pub(crate) fn shape(&self) -> Vec<usize> {
        let core = &self.array.shape()[self.leading.len()..];
        [&self.full_leading[..], core].concat()
    }

    /// The leading dimensions of the argument, where [`leading`](Self::leading) may have a 1 for one that
    /// has no stride.
    pub(crate) fn full_leading(&self) -> &[usize] {
        &self.full_leading
    }

    /// Whether this is the very memory of a result.
    pub(crate) fn is(&self, out: &Output<'py, R>) -> bool {
        self.array.is(&out.array)
    }

    /// The elements.
    pub(crate) fn records<const C: usize>(&self) -> &[[R; C]] {
        // That it is a slice was checked when it was made.
        self.array.as_slice().unwrap_or_default().as_chunks().0
    }

    /// Whether its memory is part of that of `other`.
    fn overlaps(&self, other: &Bound<'py, PyArrayDyn<R>>) -> bool {
        let own = self.array.data().addr()..self.array.data().addr() + bytes(&self.array);
        let (low, high) = extent(other);
        own.start < high && low < own.end
    }

    /// The same numbers elsewhere, if they lie where `out` is about to be written.
    pub(crate) fn apart_from(self, out: &Output<'py, R>) -> PyResult<Self> {
        let Some(given) = &out.given else { return Ok(self) };
        if !self.overlaps(given) {
            return Ok(self);
        }
        let copy = self.array.call_method0("copy")?.cast_into::<PyArrayDyn<R>>()?;
        Ok(Self { array: copy.readonly(), ..self })
    }

    /// With an element in memory for each of `shape`, to which the leading dimensions broadcast.
    pub(crate) fn filled(self, shape: &[usize]) -> PyResult<Self> {
        if self.leading == shape {
            return Ok(self);
        }
        let py = self.array.py();
        let mut full = shape.to_vec();
        full.extend_from_slice(&self.array.shape()[self.leading.len()..]);
        let full = PyTuple::new(py, full)?;
        let all = py.import("numpy")?.call_method1("broadcast_to", (&*self.array, full))?;
        let all = all.call_method1("copy", ("C",))?;
        let array = all.cast_into::<PyArrayDyn<R>>()?.readonly();
        Ok(Self { array, leading: shape.to_vec(), full_leading: shape.to_vec() })
    }
}

/// Where a result is written.
pub(crate) struct Output<'py, R: Number> {
    /// What the caller gave as `out`.
    given: Option<Bound<'py, PyArrayDyn<R>>>,
    /// Contiguous.
    array: Bound<'py, PyArrayDyn<R>>,
}

impl<'py, R: Number> Output<'py, R> {
    /// `out`, or a new array.
    pub(crate) fn new(
        py: Python<'py>,
        out: Option<&Bound<'py, PyAny>>,
        leading: &[usize],
        core: &[usize],
    ) -> PyResult<Self> {
        let mut shape = leading.to_vec();
        shape.extend_from_slice(core);
        let Some(out) = out else {
            return Ok(Self { given: None, array: empty(py, &shape)? });
        };
        let Ok(untyped) = out.cast::<PyUntypedArray>() else {
            return Err(PyTypeError::new_err(format!(
                "Expected `out` to be an array, got {}.",
                out.get_type().name()?
            )));
        };
        let Ok(given) = out.cast::<PyArrayDyn<R>>() else {
            return Err(PyTypeError::new_err(format!(
                "Expected `out` to have dtype {}, the dtype of the result, got {}.",
                if R::SINGLE { "float32" } else { "float64" },
                untyped.dtype()
            )));
        };
        if given.shape() != shape {
            return Err(PyValueError::new_err(format!(
                "Expected `out` to have shape {}, that of the result, got {}.",
                tuple(&shape),
                tuple(given.shape())
            )));
        }
        if !out.getattr("flags")?.getattr("writeable")?.is_truthy()? {
            return Err(PyValueError::new_err(
                "Expected `out` to be writeable, got a read-only array.",
            ));
        }
        let plain = given.is_c_contiguous() && given.data().is_aligned();
        let array = if plain { given.clone() } else { empty(py, &shape)? };
        Ok(Self { given: Some(given.clone()), array })
    }

    /// The memory to be written.
    pub(crate) fn borrow(&self) -> PyResult<PyReadwriteArrayDyn<'py, R>> {
        self.array.try_readwrite().map_err(|error| PyValueError::new_err(format!("`out`: {error}")))
    }

    /// What the function returns: `out`, the new array, or, of no dimensions, a number.
    pub(crate) fn finish(self) -> PyResult<Bound<'py, PyAny>> {
        let Some(given) = self.given else {
            return if self.array.ndim() == 0 {
                self.array.get_item(PyTuple::empty(self.array.py()))
            } else {
                Ok(self.array.into_any())
            };
        };
        if !given.is(&self.array) {
            given.py().import("numpy")?.call_method1("copyto", (&given, &self.array))?;
        }
        Ok(given.into_any())
    }
}

/// Whether a call computes in `f32`: if all its arrays are `f32` or narrower. Python's numbers do not count.
pub(crate) fn is_single(arguments: &[Option<Argument<'_, '_>>]) -> PyResult<bool> {
    let mut single = false;
    for argument in arguments.iter().flatten() {
        let value = argument.value;
        if value.cast_exact::<PyArrayDyn<f64>>().is_ok() {
            return Ok(false);
        }
        if value.cast_exact::<PyArrayDyn<f32>>().is_ok() {
            single = true;
        } else if !is_number(value) {
            match dtype_of(*argument)? {
                Precision::Single => single = true,
                Precision::Double => return Ok(false),
            }
        }
    }
    Ok(single)
}

/// Python's own numbers, which take the precision of what they meet.
fn is_number(value: &Bound<'_, PyAny>) -> bool {
    value.is_exact_instance_of::<PyFloat>() || value.is_exact_instance_of::<PyInt>()
}

enum Precision {
    Single,
    Double,
}

static AS_ARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
static EMPTY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();

fn numpy_function<'py>(
    py: Python<'py>,
    cell: &'static PyOnceLock<Py<PyAny>>,
    name: &str,
) -> PyResult<&'py Bound<'py, PyAny>> {
    let function =
        cell.get_or_try_init(py, || Ok::<_, PyErr>(py.import("numpy")?.getattr(name)?.unbind()))?;
    Ok(function.bind(py))
}

fn as_array<'py>(argument: Argument<'_, 'py>) -> PyResult<Bound<'py, PyUntypedArray>> {
    let py = argument.value.py();
    let array = numpy_function(py, &AS_ARRAY, "asarray")?.call1((argument.value,));
    let array =
        array.map_err(|error| PyValueError::new_err(format!("`{}`: {error}", argument.name)))?;
    Ok(array.cast_into::<PyUntypedArray>()?)
}

fn dtype_of(argument: Argument<'_, '_>) -> PyResult<Precision> {
    let dtype = as_array(argument)?.dtype();
    match (dtype.kind(), dtype.itemsize()) {
        (b'f', 2 | 4) => Ok(Precision::Single),
        (b'f', 8) | (b'i' | b'u' | b'b', _) => Ok(Precision::Double),
        _ => Err(PyTypeError::new_err(format!(
            "Expected `{}` to hold real numbers of at most 64 bits, got dtype {dtype}.",
            argument.name
        ))),
    }
}

fn convert<'py, R: Number>(argument: Argument<'_, 'py>) -> PyResult<Bound<'py, PyArrayDyn<R>>> {
    let py = argument.value.py();
    if !is_number(argument.value) {
        dtype_of(argument)?;
    }
    let array = as_array(argument)?;
    // Subclasses of arrays lose their class here, other dtypes and byte orders are converted.
    let typed = numpy_function(py, &AS_ARRAY, "asarray")?.call1((array, numpy::dtype::<R>(py)))?;
    Ok(typed.cast_into::<PyArrayDyn<R>>()?)
}

/// Without zeros in it: all of it is about to be written.
fn empty<'py, R: Number>(py: Python<'py>, shape: &[usize]) -> PyResult<Bound<'py, PyArrayDyn<R>>> {
    let shape = PyTuple::new(py, shape)?;
    let array = numpy_function(py, &EMPTY, "empty")?.call1((shape, numpy::dtype::<R>(py)))?;
    Ok(array.cast_into::<PyArrayDyn<R>>()?)
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

/// As NumPy prints shapes.
pub(crate) fn tuple(shape: &[usize]) -> String {
    let sizes: Vec<_> = shape.iter().map(ToString::to_string).collect();
    format!("({}{})", sizes.join(", "), if shape.len() == 1 { "," } else { "" })
}

/// (..., 8)
fn pattern(core: &[usize]) -> String {
    let sizes: String = core.iter().map(|size| format!(", {size}")).collect();
    format!("(...{sizes})")
}
