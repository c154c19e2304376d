//! URDF files.

use crate::error::value_error;
use crate::mechanism::Mechanism;
use dq8_robot::OwnedMechanism;
use dq8_robot::urdf::Robot;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// The bytes of a file; or those that are given, or of the text that is given, if the first thing
/// in it is `<`.
fn bytes_of(source: &Bound<'_, PyAny>) -> PyResult<Vec<u8>> {
    if let Ok(bytes) = source.cast::<PyBytes>() {
        return Ok(bytes.as_bytes().to_vec());
    }
    if let Ok(text) = source.extract::<String>()
        && text.trim_start().starts_with('<')
    {
        // It is UTF-8 here, whatever it declares.
        return Ok(format!("\u{feff}{text}").into_bytes());
    }
    let path = source.py().import("pathlib")?.call_method1("Path", (source,))?;
    path.call_method0("read_bytes")?.extract()
}

/// The robot of a file, or of what is in it.
pub(crate) fn mechanism_of(source: &Bound<'_, PyAny>) -> PyResult<Mechanism> {
    let bytes = bytes_of(source)?;
    let robot = Robot::from_bytes(&bytes).map_err(value_error)?;
    let joints = robot.joints().to_vec();
    Ok(Mechanism {
        links: robot.link_names().to_vec(),
        joint_names: robot.joint_names().to_vec(),
        double: OwnedMechanism::new(&joints).map_err(value_error)?,
        single: robot.cast(),
        drives: robot.drives().to_vec(),
        joints,
        urdf: Some((robot.name().to_owned(), bytes)),
    })
}
