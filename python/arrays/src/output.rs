//! Where results are written: `out`, or new arrays.

use crate::error::{misshapen, value_error};
use crate::number::Number;
use crate::plain::{check_mask, held, view};
use crate::shape::tuple;
use crate::threads::Threads;
use numpy::prelude::*;
use numpy::{PyArrayDyn, PyReadwriteArrayDyn, PyUntypedArray};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyTuple, PyWeakrefReference};

static EMPTY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();

/// Where a result is written.
pub struct Output<'py, R: Number> {
    /// What the caller gave as `out`, and a view of it that nobody else has, so that it stays as it
    /// was checked.
    given: Option<(Bound<'py, PyAny>, Bound<'py, PyArrayDyn<R>>)>,
    /// Contiguous.
    array: Bound<'py, PyArrayDyn<R>>,
}

/// What a caller gave as `out`, as a view that nobody else has.
pub fn view_of_out<'py>(out: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyUntypedArray>> {
    let Ok(array) = out.cast::<PyUntypedArray>() else {
        return Err(PyTypeError::new_err(format!(
            "Expected `out` to be an array, got {}.",
            out.get_type().name()?
        )));
    };
    check_mask("out", out)?;
    view(array)
}

impl<'py, R: Number> Output<'py, R> {
    /// `out`, or a new array.
    pub fn new(
        py: Python<'py>,
        out: Option<&Bound<'py, PyAny>>,
        leading: &[usize],
        core: &[usize],
    ) -> PyResult<Self> {
        R::output(py, out, leading, core)
    }

    pub(crate) fn made(
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
        let view = view_of_out(out)?;
        let dtype = view.dtype();
        let Ok(view) = view.cast_into::<PyArrayDyn<R>>() else {
            return Err(PyTypeError::new_err(format!(
                "Expected `out` to have dtype {}, the dtype of the result, got {dtype}.",
                if R::SINGLE { "float32" } else { "float64" },
            )));
        };
        if view.shape() != shape {
            let expected = format!("{}, that of the result", tuple(&shape));
            return Err(misshapen("out", &expected, view.shape()));
        }
        if !view.getattr("flags")?.getattr("writeable")?.is_truthy()? {
            return Err(PyValueError::new_err(
                "Expected `out` to be writeable, got a read-only array.",
            ));
        }
        let plain = view.is_c_contiguous() && view.data().is_aligned();
        let array = if plain { view.clone() } else { empty(py, &shape)? };
        Ok(Self { given: Some((out.clone(), view)), array })
    }

    /// What the caller gave as `out`.
    pub fn given(&self) -> Option<&Bound<'py, PyArrayDyn<R>>> {
        self.given.as_ref().map(|(_, view)| view)
    }

    /// The array that is written first.
    pub fn memory(&self) -> &Bound<'py, PyArrayDyn<R>> {
        &self.array
    }

    /// An error if the caller gave memory for this that another output has too.
    pub fn check_apart(&self, other: &Self) -> PyResult<()> {
        let (Some(given), Some(other)) = (self.given(), other.given()) else { return Ok(()) };
        let numpy = given.py().import("numpy")?;
        if numpy.call_method1("shares_memory", (given, other))?.is_truthy()? {
            return Err(PyValueError::new_err("Expected the arrays of `out` not to overlap."));
        }
        Ok(())
    }

    /// Keeps other threads of Python from resizing it.
    pub fn held(&self) -> Option<Bound<'py, PyWeakrefReference>> {
        held(self.given().unwrap_or(&self.array).as_any())
    }

    /// The memory to be written.
    pub fn borrow(&self) -> PyResult<PyReadwriteArrayDyn<'py, R>> {
        self.array.try_readwrite().map_err(|error| PyValueError::new_err(format!("`out`: {error}")))
    }

    /// What the function returns, after `write` has written all elements. Other threads of Python
    /// run meanwhile.
    pub fn fill<const C: usize>(
        self,
        threads: &Threads,
        write: impl FnOnce(&mut [[R; C]]) -> PyResult<()> + Send,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (py, _held) = (self.array.py(), self.held());
        self.fill_attached(|to| threads.run(py, || write(to.as_chunks_mut().0)))
    }

    /// [`fill`](Self::fill), where `write` decides whether other threads of Python run.
    pub fn fill_attached(
        self,
        write: impl FnOnce(&mut [R]) -> PyResult<()>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut memory = self.borrow()?;
        // It is contiguous.
        write(memory.as_slice_mut().map_err(value_error)?)?;
        drop(memory);
        self.finish()
    }

    /// What the function returns: `out`, the new array, or, of no dimensions, a number.
    pub fn finish(self) -> PyResult<Bound<'py, PyAny>> {
        let Some((out, view)) = self.given else {
            return if self.array.ndim() == 0 {
                self.array.get_item(PyTuple::empty(self.array.py()))
            } else {
                Ok(self.array.into_any())
            };
        };
        if !view.is(&self.array) {
            view.py().import("numpy")?.call_method1("copyto", (&view, &self.array))?;
        }
        Ok(out)
    }
}

/// Without zeros in it: all of it is about to be written.
fn empty<'py, R: Number>(py: Python<'py>, shape: &[usize]) -> PyResult<Bound<'py, PyArrayDyn<R>>> {
    let shape = PyTuple::new(py, shape)?;
    let array = EMPTY.import(py, "numpy", "empty")?.call1((shape, numpy::dtype::<R>(py)))?;
    Ok(array.cast_into::<PyArrayDyn<R>>()?)
}
