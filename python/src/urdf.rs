//! URDF files.

use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The text of a file; or the text that is given, if the first thing in it is `<`.
pub(crate) fn text_of(source: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Ok(text) = source.extract::<String>()
        && text.trim_start().starts_with('<')
    {
        return Ok(text);
    }
    let py = source.py();
    let path = py.import("pathlib")?.call_method1("Path", (source,))?;
    let options = PyDict::new(py);
    options.set_item("encoding", "utf-8-sig")?;
    path.call_method("read_text", (), Some(&options))?.extract()
}
