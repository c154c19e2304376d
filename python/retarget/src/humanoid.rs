//! Humanoids.

use crate::raised;
use crate::threads::watched;
use dq8_python_arrays::error::value_error;
use dq8_python_robots::mechanism::Mechanism;
use dq8_python_robots::urdf::{bytes_of, decoded};
use dq8_retarget::{RetargetError, Role};
use dq8_robot::JointKind;
use dq8_robot::urdf::UrdfError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyTuple};
use std::sync::Arc;

/// A humanoid robot: its links, and which of them are knees and feet.
#[pyclass(frozen, subclass, module = "dq8.retarget")]
#[derive(Debug)]
pub struct Humanoid {
    pub(crate) humanoid: Arc<dq8_retarget::Humanoid>,
    /// The robot on a base that floats.
    mechanism: Py<Mechanism>,
    urdf: Vec<u8>,
    given: Option<String>,
}

#[pymethods]
impl Humanoid {
    #[new]
    #[pyo3(signature = (source, table=None))]
    fn new(source: &Bound<'_, PyAny>, table: Option<String>) -> PyResult<Self> {
        let (py, mut urdf) = (source.py(), bytes_of(source)?);
        let read = |urdf: Vec<u8>| {
            let table = table.clone();
            watched(py, move |_| dq8_retarget::Humanoid::from_bytes(&urdf, table.as_deref()))
        };
        let mut humanoid = read(urdf.clone())?;
        if let Err(RetargetError::Urdf(error)) = &humanoid
            && let UrdfError::Encoding { encoding } = &**error
        {
            urdf = decoded(py, &urdf, encoding)?;
            humanoid = read(urdf.clone())?;
        }
        let humanoid = humanoid.map_err(|error| raised(&error))?;
        let mechanism = Mechanism::of_robot(humanoid.robot()).map_err(value_error)?;
        let mechanism = Py::new(py, mechanism)?;
        Ok(Self { humanoid: Arc::new(humanoid), mechanism, urdf, given: table })
    }

    /// The name that the file gives the robot.
    #[getter]
    fn name(&self) -> &str {
        self.humanoid.robot().name()
    }

    /// The names of the links.
    #[getter]
    fn links(&self) -> Vec<String> {
        self.humanoid.robot().link_names().to_vec()
    }

    /// The names of the joints that move, in the order of a motion's values.
    #[getter]
    fn joints(&self) -> Vec<String> {
        // The first seven values are those of the base.
        self.humanoid.robot().value_names()[7..].to_vec()
    }

    /// The link of each role that was found.
    #[getter]
    fn roles(&self) -> Vec<(&'static str, &str)> {
        let names = self.humanoid.robot().link_names();
        let found =
            |role: Role| Some((role.name(), names[self.humanoid.part(role)?.link].as_str()));
        Role::ALL.into_iter().filter_map(found).collect()
    }

    /// Sentences about parts whose names mislead, about what had to be assumed, and about shapes
    /// that are not read.
    #[getter]
    fn told(&self) -> Vec<String> {
        self.humanoid.told().to_vec()
    }

    /// The roles as a table of TOML, which `Humanoid` takes.
    fn table(&self) -> String {
        self.humanoid.table()
    }

    /// The robot on a base that floats: its values are those of the base and then those of joints.
    #[getter]
    fn _mechanism(&self, py: Python<'_>) -> Py<Mechanism> {
        self.mechanism.clone_ref(py)
    }

    /// The link that floats.
    #[getter]
    fn _base(&self) -> usize {
        let joints = self.humanoid.robot().joints();
        joints.iter().position(|joint| joint.kind != JointKind::Fixed).unwrap_or(0)
    }

    fn __str__(&self) -> String {
        self.humanoid.to_string()
    }

    fn __repr__(&self) -> String {
        let robot = self.humanoid.robot();
        let (name, joints) = (robot.name(), self.joints().len());
        format!("<dq8.retarget.Humanoid {name:?}: {joints} joints, {} roles>", self.roles().len())
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let (py, own) = (slf.py(), slf.get());
        let given = (PyBytes::new(py, &own.urdf), own.given.clone()).into_pyobject(py)?;
        Ok((slf.get_type().into_any(), given))
    }
}
