//! URDF files.

use crate::error::value_error;
use crate::mechanism::Mechanism;
use crate::threads::whole;
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
    // Small files, those of all robots that there are, take less time than a thread does.
    if bytes.len() < LARGE {
        return read(bytes).map_err(value_error);
    }
    whole(source.py(), || read(bytes))?.map_err(value_error)
}

/// From so many bytes on, other threads of Python run meanwhile.
const LARGE: usize = 1 << 18;

fn read(bytes: Vec<u8>) -> Result<Mechanism, String> {
    let robot = Robot::from_bytes(&bytes).map_err(|error| error.to_string())?;
    let joints = robot.joints().to_vec();
    Ok(Mechanism {
        links: robot.link_names().to_vec(),
        joint_names: robot.joint_names().to_vec(),
        double: OwnedMechanism::new(&joints).map_err(|error| error.to_string())?,
        single: robot.cast(),
        drives: robot.drives().to_vec(),
        joints,
        urdf: Some((robot.name().to_owned(), bytes)),
    })
}
