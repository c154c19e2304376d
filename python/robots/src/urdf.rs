//! URDF files.

use crate::error::value_error;
use crate::mechanism::Mechanism;
use dq8_robot::OwnedMechanism;
use dq8_robot::urdf::Robot;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The text of a file; or the text that is given, if the first thing in it is `<`.
fn text_of(source: &Bound<'_, PyAny>) -> PyResult<String> {
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

/// The robot of a file, or of its text.
pub(crate) fn mechanism_of(source: &Bound<'_, PyAny>) -> PyResult<Mechanism> {
    let text = text_of(source)?;
    let robot = Robot::from_urdf(&text).map_err(value_error)?;
    let joints = robot.joints().to_vec();
    Ok(Mechanism {
        links: robot.link_names().to_vec(),
        joint_names: robot.joint_names().to_vec(),
        double: OwnedMechanism::new(&joints).map_err(value_error)?,
        single: robot.cast(),
        drives: robot.drives().to_vec(),
        joints,
        urdf: Some((robot.name().to_owned(), text)),
    })
}
