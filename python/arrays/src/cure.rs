//! What to pass in the place of an object that is no array of numbers.

use crate::plain::odd_one;
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
    ("builtins", "dict", "numpy.stack(list({}.values()), axis=-1)"),
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
