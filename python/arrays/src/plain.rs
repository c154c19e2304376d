//! Python objects as plain arrays: no subclasses, and none that stand for more or less than their
//! numbers.

use crate::cure::cure;
use numpy::prelude::*;
use numpy::{PyArrayDescrMethods, PyUntypedArray};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyFloat, PyInt, PyList, PyTuple, PyType, PyWeakrefReference};

static AS_ARRAY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();

/// NumPy nests arrays no deeper.
const DEEPEST: usize = 64;

/// What NumPy makes of a value. Code of the caller may run meanwhile (`__array__`), and may change
/// other arrays: all arguments of a call become plain before one is looked at.
pub fn plain<'py>(name: &str, value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyUntypedArray>> {
    if let Ok(array) = exact(value) {
        return Ok(array.clone());
    }
    check_whole(name, value)?;
    let py = value.py();
    let array = AS_ARRAY.import(py, "numpy", "asarray")?.call1((value,));
    let array = array.map_err(|error| PyValueError::new_err(format!("`{name}`: {error}")))?;
    Ok(array.cast_into::<PyUntypedArray>()?)
}

/// An array of real numbers of at most 64 bits, as [`plain`] makes it.
pub fn real<'py>(
    name: &str,
    core: &[usize],
    value: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyUntypedArray>> {
    // Arrow's nulls would be NaN in NumPy's array.
    if exact(value).is_err()
        && !is_number(value)
        && is_arrow(value)?
        && let Some(numbers) = of_arrow(name, core, value)?
    {
        return real(name, core, &numbers);
    }
    let array = by_names(core, value, plain(name, value)?)?;
    let dtype = array.dtype();
    if matches!((dtype.kind(), dtype.itemsize()), (b'f', 2 | 4 | 8) | (b'i' | b'u' | b'b', _)) {
        return Ok(array);
    }
    // Arrays have a dtype. Of anything else that NumPy makes objects or text of, the type says
    // more.
    let is_array = value.is_instance_of::<PyUntypedArray>();
    let given = match dtype.kind() {
        b'O' | b'U' | b'S' if !is_array => format!("{}{}", kind(value)?, cure(name, core, value)?),
        b'O' => format!("dtype object{}", cure(name, core, value)?),
        _ => format!("dtype {dtype}"),
    };
    Err(PyTypeError::new_err(format!(
        "Expected `{name}` to hold real numbers of at most 64 bits, got {given}."
    )))
}

/// `value` as the functions take an array called `name`, of real numbers and no subclass.
#[pyfunction]
pub fn real_array<'py>(
    name: &str,
    value: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyUntypedArray>> {
    view(&real(name, &[], value)?)
}

/// The same memory as an array that nobody else has, so that nobody changes its dtype, shape or
/// flags.
pub fn view<'py>(array: &Bound<'py, PyUntypedArray>) -> PyResult<Bound<'py, PyUntypedArray>> {
    let py = array.py();
    let view = match exact(array.as_any()) {
        Ok(array) => array.as_any().get_item(py.Ellipsis())?,
        // No method of a subclass runs.
        Err(_) => AS_ARRAY.import(py, "numpy", "asarray")?.call1((array,))?,
    };
    Ok(view.cast_into::<PyUntypedArray>()?)
}

/// Keeps NumPy from moving the memory of a view: it resizes no array to which there are weak
/// references.
pub fn held<'py>(view: &Bound<'py, PyAny>) -> Option<Bound<'py, PyWeakrefReference>> {
    let base = view.getattr(intern!(view.py(), "base")).ok()?;
    PyWeakrefReference::new(&base).ok()
}

/// An error if an array stands for more than its numbers: then `out` must not be it.
pub fn check_mask(name: &str, array: &Bound<'_, PyAny>) -> PyResult<()> {
    // Of the type: records have fields of any name.
    if exact(array).is_ok() || !array.get_type().hasattr(intern!(array.py(), "mask"))? {
        return Ok(());
    }
    let kind = array.get_type().fully_qualified_name()?;
    Err(PyTypeError::new_err(format!(
        "Expected `{name}` to have no mask, got {kind}: pass `{name}.filled(numpy.nan)`, or `{name}.data` to \
         ignore the mask."
    )))
}

/// An error if numbers are not all that matters of a value: it has a mask, or is computed
/// elsewhere.
pub fn check_whole(name: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
    check(name, value, DEEPEST)
}

fn check(name: &str, value: &Bound<'_, PyAny>, depth: usize) -> PyResult<()> {
    let py = value.py();
    if is_number(value) || exact(value).is_ok() {
        return Ok(());
    }
    if let Some(depth) = depth.checked_sub(1)
        && (value.is_instance_of::<PyList>() || value.is_instance_of::<PyTuple>())
    {
        for item in value.try_iter()? {
            check(name, &item?, depth)?;
        }
        return Ok(());
    }
    if value.is_instance_of::<PyUntypedArray>() {
        return check_mask(name, value);
    }
    let kind = value.get_type();
    if !kind.hasattr(intern!(py, "__array_function__"))? && !is_lazy(&kind, value)? {
        return Ok(());
    }
    let name_of_kind = kind.fully_qualified_name()?;
    Err(PyTypeError::new_err(format!(
        "Expected `{name}` to be an array in memory, got {name_of_kind}: pass `numpy.asarray({name})` to compute it \
         here and now, or call the function on its blocks (Dask: the functions of `dq8.dask`)."
    )))
}

/// Whether a value is a graph of Dask, of which NumPy would make an array by computing all of it.
fn is_lazy(kind: &Bound<'_, PyType>, value: &Bound<'_, PyAny>) -> PyResult<bool> {
    let graph = intern!(value.py(), "__dask_graph__");
    Ok(kind.hasattr(graph)? && !value.call_method0(graph)?.is_none())
}

/// The array of a data frame of pandas, or of one row of it, in the order of arrays where names say
/// which number is which. Rows are ordered, and not a series of scalars, whose labels are those of
/// the elements.
fn by_names<'py>(
    core: &[usize],
    value: &Bound<'py, PyAny>,
    array: Bound<'py, PyUntypedArray>,
) -> PyResult<Bound<'py, PyUntypedArray>> {
    static ORDER: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    let are_elements = match (core, array.shape()) {
        ([size], [.., last]) => last == size,
        // Of tables whose rows are of any size.
        ([], [_, last]) => (3..=8).contains(last),
        _ => false,
    };
    if !are_elements || exact(value).is_ok() {
        return Ok(array);
    }
    let (py, kind) = (value.py(), value.get_type());
    let labels = match (kind.name()?.to_cow()?.as_ref(), array.ndim()) {
        ("DataFrame", 2) => value.getattr(intern!(py, "columns"))?,
        ("Series", 1) => value.getattr(intern!(py, "index"))?,
        _ => return Ok(array),
    };
    let labels = labels.try_iter()?.collect::<PyResult<Vec<_>>>()?;
    let order = ORDER.import(py, "dq8._names", "order")?.call1((PyList::new(py, labels)?,))?;
    if order.is_none() {
        return Ok(array);
    }
    Ok(array.call_method1("take", (order, -1))?.cast_into()?)
}

/// The numbers of a column or table of Arrow; nothing if it holds others than those that its memory
/// is read for, which NumPy may know.
fn of_arrow<'py>(
    name: &str,
    core: &[usize],
    value: &Bound<'py, PyAny>,
) -> PyResult<Option<Bound<'py, PyAny>>> {
    static ROWS: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    let py = value.py();
    let core = PyTuple::new(py, core)?;
    match ROWS.import(py, "dq8._arrow", "rows")?.call1((value, core)) {
        Ok(numbers) => Ok(Some(numbers)),
        Err(error) if error.is_instance_of::<PyTypeError>(py) => Ok(None),
        Err(error) => Err(PyValueError::new_err(format!("`{name}`: {}", error.value(py)))),
    }
}

/// Whether a value offers Arrow's memory. Of the objects of pandas, which does as well, [`cure`]
/// says more.
pub(crate) fn is_arrow(value: &Bound<'_, PyAny>) -> PyResult<bool> {
    let py = value.py();
    let kind = value.get_type();
    let offers = kind.hasattr(intern!(py, "__arrow_c_array__"))?
        || kind.hasattr(intern!(py, "__arrow_c_stream__"))?;
    Ok(offers && kind.module()?.to_string().split('.').next() != Some("pandas"))
}

/// Python's own numbers, which take the precision of what they meet.
pub fn is_number(value: &Bound<'_, PyAny>) -> bool {
    value.is_exact_instance_of::<PyFloat>() || value.is_exact_instance_of::<PyInt>()
}

/// A value that is an array, and of no subclass.
fn exact<'a, 'py>(value: &'a Bound<'py, PyAny>) -> Result<&'a Bound<'py, PyUntypedArray>, ()> {
    static TYPE: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let py = value.py();
    let array = TYPE.import(py, "numpy", "ndarray").map_err(drop)?;
    if !value.is_exact_instance(array) {
        return Err(());
    }
    value.cast::<PyUntypedArray>().map_err(drop)
}

/// The type of a value; of a list, also that of what it holds.
fn kind(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if value.is_none() {
        return Ok("None".to_owned());
    }
    let own = value.get_type().fully_qualified_name()?.to_string();
    let held = odd_one(value)?;
    if held.is(value) {
        return Ok(own);
    }
    Ok(format!("a {own} with {} in it", kind(&held)?))
}

/// What keeps a nested list from being an array of numbers; the value itself if it is no list.
pub fn odd_one<'py>(value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let mut at = value.clone();
    for _ in 0..DEEPEST {
        if !(at.is_instance_of::<PyList>() || at.is_instance_of::<PyTuple>()) {
            break;
        }
        let mut odd = None;
        for item in at.try_iter()? {
            let item = item?;
            if !is_number(&item) {
                odd = Some(item);
                break;
            }
        }
        let Some(item) = odd else { break };
        at = item;
    }
    Ok(at)
}
