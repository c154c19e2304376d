//! People.

use crate::argument::{Argument, Input};
use crate::links::{check_names, parents_of};
use crate::raised;
use crate::shape::{NUMBER, VECTOR};
use crate::threads::watched;
use dq8_python_arrays::error::{misshapen, value_error};
use dq8_retarget::{BodyModel, RetargetError, Role};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::Arc;

/// The motion of a person: joints with names, and a pose of each in each frame. `load`, `positions`
/// and `body_model` make it.
#[pyclass(frozen, module = "dq8.retarget")]
#[derive(Debug)]
pub struct Person {
    pub(crate) person: Arc<dq8_retarget::Person>,
    #[pyo3(get)]
    _warning: Option<String>,
}

/// A person and a warning.
type Made = Result<(dq8_retarget::Person, Option<String>), RetargetError>;

/// Makes a person while other threads of Python run. A table gives roles to joints.
fn made(
    py: Python<'_>,
    table: Option<String>,
    make: impl FnOnce() -> Made + Send + 'static,
) -> PyResult<Person> {
    let made = watched(py, move |_| {
        let (person, warning) = make()?;
        let person = match table {
            Some(table) => person.with_table(&table)?,
            None => person,
        };
        Ok::<_, RetargetError>((person, warning))
    })?;
    let (person, _warning) = made.map_err(|error| raised(&error))?;
    Ok(Person { person: Arc::new(person), _warning })
}

/// Returns rows of three numbers, and their leading dimensions.
fn vectors(name: &'static str, value: &Bound<'_, PyAny>) -> PyResult<(Vec<[f64; 3]>, Vec<usize>)> {
    let input = Input::<f64>::of(&Argument::new(name, VECTOR, value)?)?.in_full()?;
    Ok((input.records().to_vec(), input.full_leading().to_vec()))
}

fn numbers(name: &'static str, value: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    let input = Input::<f64>::of(&Argument::new(name, NUMBER, value)?)?.in_full()?;
    Ok(input.numbers().to_vec())
}

/// Returns the seconds from frame to frame.
fn frame_time(fps: f64) -> PyResult<f64> {
    if fps > 0.0 && fps.is_finite() {
        return Ok(1.0 / fps);
    }
    Err(value_error(format!("Expected `fps` to be finite and more than 0, got {fps}.")))
}

#[pymethods]
impl Person {
    /// A person of the bytes of a BVH file.
    #[staticmethod]
    fn _from_bvh(
        py: Python<'_>,
        title: String,
        data: &Bound<'_, PyBytes>,
        table: Option<String>,
    ) -> PyResult<Self> {
        let bytes = data.as_bytes().to_vec();
        made(py, table, move || {
            let (person, warning) = dq8_retarget::Person::from_bvh(title, &bytes)?;
            Ok((person, warning.map(|it| it.to_string())))
        })
    }

    /// A person of the places of joints.
    #[staticmethod]
    fn _from_positions(
        py: Python<'_>,
        title: String,
        names: Vec<String>,
        parents: &Bound<'_, PyAny>,
        positions: &Bound<'_, PyAny>,
        fps: f64,
        table: Option<String>,
    ) -> PyResult<Self> {
        let parents = parents_of(parents)?;
        check_names("names", &names, parents.len())?;
        let (places, leading) = vectors("array", positions)?;
        if !matches!(leading[..], [_, joints] if joints == names.len()) {
            let shape = [&leading[..], &[3]].concat();
            return Err(misshapen("array", &format!("(frames, {}, 3)", names.len()), &shape));
        }
        let time = frame_time(fps)?;
        made(py, table, move || {
            let parent = |&it: &u32| (it != u32::MAX).then_some(it as usize);
            let joints: Vec<_> =
                names.iter().map(String::as_str).zip(parents.iter().map(parent)).collect();
            Ok((dq8_retarget::Person::from_positions(title, &joints, &places, time)?, None))
        })
    }

    /// A person of the turns of joints, and of the arrays of a body model.
    #[staticmethod]
    #[expect(clippy::too_many_arguments, reason = "each is an array")]
    fn _from_body_model(
        py: Python<'_>,
        title: String,
        template: &Bound<'_, PyAny>,
        shapes: &Bound<'_, PyAny>,
        regressor: &Bound<'_, PyAny>,
        betas: &Bound<'_, PyAny>,
        turns: &Bound<'_, PyAny>,
        places: &Bound<'_, PyAny>,
        fps: f64,
        table: Option<String>,
    ) -> PyResult<Self> {
        let (template, shapes) =
            (vectors("v_template", template)?.0, numbers("shapedirs", shapes)?);
        let (regressor, betas) = (numbers("J_regressor", regressor)?, numbers("betas", betas)?);
        let (turns, places) = (vectors("turns", turns)?.0, vectors("places", places)?.0);
        let time = frame_time(fps)?;
        made(py, table, move || {
            let model = BodyModel { template: &template, shapes: &shapes, regressor: &regressor };
            let person = dq8_retarget::Person::from_body_model;
            Ok((person(title, model, &betas, &turns, &places, time)?, None))
        })
    }

    /// The title.
    #[getter]
    fn title(&self) -> &str {
        self.person.title()
    }

    /// The names of the joints.
    #[getter]
    fn joints(&self) -> Vec<String> {
        self.person.joint_names().to_vec()
    }

    /// The joint that carries each joint, −1 for a root.
    #[getter]
    fn parents(&self) -> Vec<i64> {
        let parent = |it: &Option<usize>| it.map_or(-1, |parent| parent as i64);
        self.person.parents().iter().map(parent).collect()
    }

    /// The joint of each role that was found.
    #[getter]
    fn roles(&self) -> Vec<(&'static str, &str)> {
        let names = self.person.joint_names();
        let found = |role: Role| Some((role.name(), names[self.person.joint(role)?].as_str()));
        Role::ALL.into_iter().filter_map(found).collect()
    }

    /// The number of frames per second.
    #[getter]
    fn fps(&self) -> f64 {
        1.0 / self.person.frame_time()
    }

    /// The number of frames.
    fn __len__(&self) -> usize {
        self.person.frames()
    }

    fn __repr__(&self) -> String {
        let (title, frames) = (self.person.title(), self.person.frames());
        let (joints, fps) = (self.person.joint_names().len(), self.fps());
        let fps = (fps * 1e6).round() / 1e6;
        format!("<dq8.retarget.Person {title:?}: {joints} joints, {frames} frames, {fps} fps>")
    }
}
