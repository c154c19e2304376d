//! Motions, and their measures.

use crate::argument::{Argument, Input};
use crate::humanoid::Humanoid;
use crate::interrupt::Interrupt;
use crate::person::Person;
use crate::raised;
use crate::shape::NUMBER;
use crate::threads::watched;
use dq8_python_arrays::error::misshapen;
use dq8_retarget::{Report, RetargetError, Settings, Speeds, Targets, retarget_while};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A flag that ends calls of other threads.
#[pyclass(frozen, module = "dq8.retarget")]
#[derive(Debug, Default)]
pub struct Stop(Arc<AtomicBool>);

#[pymethods]
impl Stop {
    #[new]
    fn new() -> Self {
        Self::default()
    }

    /// Ends all calls that have this, soon.
    fn set(&self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// The keywords of `retarget`.
#[derive(Debug, FromPyObject)]
#[pyo3(from_item_all)]
pub struct Wishes {
    fps: f64,
    rest: Option<i64>,
    ankle: Option<f64>,
    feet: bool,
    smooth: Option<f64>,
    speeds: Option<Speed>,
    collide: bool,
}

#[derive(Debug, FromPyObject)]
enum Speed {
    AtMost(f64),
    Named(String),
}

impl Wishes {
    fn settings(&self) -> PyResult<Settings> {
        let Self { fps, ankle, feet, smooth, collide, .. } = *self;
        let refused = |what: String| Err(PyValueError::new_err(what));
        let rest = match self.rest.map(usize::try_from).transpose() {
            Ok(rest) => rest,
            Err(_) => return refused("Expected `rest` to be the number of a frame.".to_owned()),
        };
        let speeds = match &self.speeds {
            None => Speeds::Free,
            Some(Speed::AtMost(speed)) => Speeds::AtMost(*speed),
            Some(Speed::Named(name)) if name == "file" => Speeds::File,
            Some(Speed::Named(name)) => {
                return refused(format!(
                    "Expected `speeds` to be a number, 'file' or None, got {name:?}."
                ));
            }
        };
        let settings = Settings { fps, rest, ankle, feet, smooth, speeds, collide };
        settings.check().map_err(|error| raised(&error))?;
        Ok(settings)
    }
}

/// Refuses settings that are out of their ranges.
#[pyfunction]
pub fn check_settings(settings: Wishes) -> PyResult<()> {
    settings.settings().map(drop)
}

/// The values and contacts of a motion, its measures, and what is to be told.
type Made<'py> = (Bound<'py, PyAny>, Bound<'py, PyAny>, Measures<'py>, Vec<String>);

/// Numbers by their names, sentences about those that are not good, and whether edges of soles are
/// known.
type Measures<'py> = (Bound<'py, PyDict>, Vec<String>, bool);

/// Brings the motion of a person on a humanoid.
#[pyfunction]
pub fn retarget_motion<'py>(
    py: Python<'py>,
    person: &Person,
    humanoid: &Humanoid,
    settings: Wishes,
    stop: Option<&Stop>,
) -> PyResult<Made<'py>> {
    let settings = settings.settings()?;
    let (person, robot) = (person.person.clone(), humanoid.humanoid.clone());
    let stop = stop.map(|stop| stop.0.clone());
    let made = watched(py, move |interrupt: &Interrupt| {
        let stopped = || stop.as_ref().is_some_and(|stop| stop.load(Ordering::Relaxed));
        retarget_while(&person, &robot, &settings, &mut |part| {
            interrupt.note(part);
            !interrupt.came() && !stopped()
        })
    })?;
    let motion = made.map_err(|error| raised(&error))?;
    let frames = motion.contacts.len();
    let columns = motion.values.len() / frames.max(1);
    let values = PyArray1::from_vec(py, motion.values).reshape([frames, columns])?.into_any();
    let contacts = PyArray1::from_vec(py, motion.contacts.into_flattened());
    let contacts = contacts.reshape([frames, 2])?.into_any();
    Ok((values, contacts, measures(py, &motion.report)?, motion.told))
}

/// Measures a motion of a humanoid, the values of the base and of the joints in each frame.
#[pyfunction]
pub fn retarget_report<'py>(
    py: Python<'py>,
    person: &Person,
    humanoid: &Humanoid,
    values: &Bound<'_, PyAny>,
    settings: Wishes,
) -> PyResult<Measures<'py>> {
    let fps = settings.fps;
    let settings = settings.settings()?;
    let given = Input::<f64>::of(&Argument::new("values", NUMBER, values)?)?.in_full()?;
    let (shape, values) = (given.shape(), given.numbers().to_vec());
    drop(given);
    let (person, robot) = (person.person.clone(), humanoid.humanoid.clone());
    let columns = robot.robot().mechanism().values();
    let report = watched(py, move |_| {
        let targets = Targets::new(&person, &robot, &settings)?;
        let expected = targets.frames();
        if values.len() != expected * columns {
            return Ok(Err(expected));
        }
        Report::of(&targets, &robot, &values).map(Ok)
    })?;
    match report.map_err(|error: RetargetError| raised(&error))? {
        Ok(report) => measures(py, &report),
        Err(frames) => {
            let each = format!("a row for each frame of `person` at {fps} per second");
            Err(misshapen("values", &format!("({frames}, {columns}), {each}"), &shape))
        }
    }
}

fn measures<'py>(py: Python<'py>, report: &Report) -> PyResult<Measures<'py>> {
    // What is not known, as where the file has meshes as shapes, is NaN.
    let numbers = report.measures().map(|measure| measure.unwrap_or(f64::NAN));
    let numbers = Report::MEASURES.into_iter().zip(numbers);
    Ok((numbers.into_py_dict(py)?, report.warnings(), report.edges))
}
