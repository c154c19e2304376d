//! URDF files.

use crate::error::value_error;
use crate::mechanism::Mechanism;
use crate::threads::whole;
use dq8_robot::urdf::{Robot, UrdfError};
use dq8_robot::{MechanismError, OwnedMechanism};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// Returns text as UTF-8 behind a byte order mark, which counts more than the encoding that the
/// text itself declares.
fn with_mark(text: &str) -> Vec<u8> {
    format!("\u{feff}{text}").into_bytes()
}

/// The bytes of a file; or those that are given, or of the text that is given, if the first thing
/// in it is `<`.
pub fn bytes_of(source: &Bound<'_, PyAny>) -> PyResult<Vec<u8>> {
    if let Ok(bytes) = source.cast::<PyBytes>() {
        return Ok(bytes.as_bytes().to_vec());
    }
    if let Ok(text) = source.extract::<String>()
        && text.trim_start().starts_with('<')
    {
        return Ok(with_mark(&text));
    }
    let path = source.py().import("pathlib")?.call_method1("Path", (source,))?;
    path.call_method0("read_bytes")?.extract()
}

/// Returns the robot of a file, or of the contents of a file. Python decodes all encodings that a
/// file may declare: tables of them in this module would be a twentieth of the wheel.
pub(crate) fn mechanism_of(source: &Bound<'_, PyAny>) -> PyResult<Mechanism> {
    let py = source.py();
    let (encoding, bytes) = match made(py, bytes_of(source)?)? {
        Err(Failure::Encoding { encoding, bytes }) => (encoding, bytes),
        made => return made.map_err(Failure::raised),
    };
    made(py, decoded(py, &bytes, &encoding)?)?.map_err(Failure::raised)
}

/// Returns the text of bytes in an encoding as UTF-8 behind a byte order mark.
pub fn decoded(py: Python<'_>, bytes: &[u8], encoding: &str) -> PyResult<Vec<u8>> {
    let text = PyBytes::new(py, bytes).call_method1("decode", (encoding, "replace"));
    let text =
        text.map_err(|error| value_error(format!("the file declares an {}", error.value(py))));
    Ok(with_mark(&text?.extract::<String>()?))
}

/// From so many bytes on, other threads of Python run meanwhile.
const LARGE: usize = 1 << 18;

fn made(py: Python<'_>, bytes: Vec<u8>) -> PyResult<Result<Mechanism, Failure>> {
    // Small files, those of all robots that there are, take less time than a thread does.
    if bytes.len() < LARGE { Ok(read(bytes)) } else { whole(py, || read(bytes)) }
}

/// The reason why there is no robot.
enum Failure {
    /// The bytes must be decoded first.
    Encoding {
        encoding: String,
        bytes: Vec<u8>,
    },
    Said(String),
}

impl Failure {
    fn raised(self) -> PyErr {
        match self {
            Self::Encoding { encoding, .. } => value_error(format!("not text in {encoding}")),
            Self::Said(text) => value_error(text),
        }
    }
}

fn read(bytes: Vec<u8>) -> Result<Mechanism, Failure> {
    let robot = match Robot::from_bytes(&bytes) {
        Ok(robot) => robot,
        Err(UrdfError::Encoding { encoding }) => return Err(Failure::Encoding { encoding, bytes }),
        Err(error) => return Err(Failure::Said(error.to_string())),
    };
    let mechanism =
        Mechanism::of_robot(&robot).map_err(|error| Failure::Said(error.to_string()))?;
    Ok(Mechanism { urdf: Some((robot.name().to_owned(), bytes)), ..mechanism })
}

impl Mechanism {
    /// Returns a robot of a file, which does not know its file.
    pub fn of_robot(robot: &Robot) -> Result<Self, MechanismError> {
        Ok(Self {
            links: robot.link_names().to_vec(),
            joint_names: robot.joint_names().to_vec(),
            joints: robot.joints().to_vec(),
            drives: robot.drives().to_vec(),
            double: OwnedMechanism::new(robot.joints())?,
            single: robot.cast(),
            urdf: None,
            fixed: None,
        })
    }
}
