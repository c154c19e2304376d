//! What to pass in the place of an object that is no array of numbers.

use crate::error::misshapen;
use crate::plain::odd_one;
use crate::shape::{pattern, tuple};
use pyo3::exceptions::PyValueError;
use pyo3::intern;
use pyo3::prelude::*;

/// By the package and the name of a type, what is called `{}` in the call; `{n}` are the numbers of
/// an element.
const CURES: [(&str, &str, &str); 9] = [
    ("dq8", "RigidTransform", "{}.motions"),
    ("scipy", "RigidTransform", "{}.as_dual_quat()"),
    ("scipy", "Rotation", "{}.as_quat()"),
    ("pandas", "Series", "numpy.stack({})` of arrays or `{}.to_numpy(float, na_value=numpy.nan)"),
    ("pandas", "DataFrame", "{}.to_numpy(float, na_value=numpy.nan)"),
    ("polars", "Series", "{}.to_list()"),
    ("polars", "LazyFrame", "{}.collect()"),
    (
        "builtins",
        "dict",
        "numpy.stack([{}[key] for key in keys], axis=-1)` of columns, or `axis=-2` of elements,",
    ),
    ("numpy", "ndarray", "numpy.stack({})` of arrays or `{}.astype(float)"),
];

/// A colon and what to pass, where that is known.
pub(crate) fn cure(name: &str, core: &[usize], value: &Bound<'_, PyAny>) -> PyResult<String> {
    let py = value.py();
    let odd = odd_one(value)?;
    let kind = odd.get_type();
    let (module, own) = (kind.module()?.to_string(), kind.name()?.to_string());
    let package = module.split('.').next().unwrap_or_default();
    let known = CURES.iter().find(|(of, name, _)| *of == package && *name == own);
    let text = match known {
        Some((_, _, text)) => text,
        None if kind.hasattr(intern!(py, "__next__"))? => "list({})",
        None if kind.hasattr(intern!(py, "__array__"))? => return Ok(String::new()),
        None if kind.hasattr(intern!(py, "__dlpack__"))? => "numpy.from_dlpack({})",
        None => return Ok(String::new()),
    };
    let numbers: usize = core.iter().product();
    // In a list, it is each of them that is replaced.
    let called = if odd.is(value) { name } else { "each" };
    Ok(format!(": pass `{}`", text.replace("{}", called).replace("{n}", &numbers.to_string())))
}

/// An error about elements of another shape than `core`, with the function that makes what is
/// wanted of them, where their shape tells what they are.
pub(crate) fn of_another_kind(name: &str, core: &[usize], shape: &[usize]) -> PyErr {
    let cure = match (name, core, shape) {
        ("logs", [8], [.., 6]) => {
            "a logarithm is a dual quaternion here, as `dq8.log` returns it; of twists pass them to `dq8.from_twist`"
        }
        (_, [8], [.., 6]) => "of twists pass `dq8.from_twist({})`",
        (_, [8], [4 | 3, 4]) => {
            "of a matrix pass `dq8.from_matrix({})`, of quaternions `dq8.from_rotation({})`"
        }
        (_, [8], [.., 4 | 3, 4]) => "of matrices pass `dq8.from_matrix({})`",
        (_, [8], [.., 4]) => "of quaternions pass `dq8.from_rotation({})`",
        (_, [8], [.., 3]) => "of translations pass `dq8.from_translation({})`",
        (_, [8], [.., 7]) => {
            "of quaternions and translations pass `dq8.from_rotation_translation(rotations, translations)`"
        }
        (_, [8], [8, _]) => "of motions in columns pass `{}.T`",
        ("twists", [6], [.., 8]) => "of motions pass `dq8.to_twist({})`",
        ("rotations", [4], [.., 3]) => "of rotation vectors there is `dq8.from_rotation_vector`",
        _ => return misshapen(name, &pattern(core), shape),
    };
    PyValueError::new_err(format!(
        "Expected `{name}` to have shape {}, got {}: {}.",
        pattern(core),
        tuple(shape),
        cure.replace("{}", name)
    ))
}
