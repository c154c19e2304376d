//! The arguments of searches in Python, and the function behind `track` and `sequence`.

use crate::argument::{Argument, iterations};
use crate::columns::in_order;
use crate::mechanism::Mechanism;
use crate::shape::{EIGHT, NUMBER, SIX, VECTOR};
use dq8_python_ik::goals::Goals;
use dq8_python_ik::reach_report::ReachReport;
use dq8_python_ik::search::Search;
use dq8_python_ik::track::track as all;
use dq8_robot::ik::{Options, Tracking};
use pyo3::prelude::*;

/// The arguments of every search, as the caller gave them.
#[derive(Clone, Copy)]
pub(crate) struct Asked<'a, 'py> {
    pub(crate) targets: &'a Bound<'py, PyAny>,
    pub(crate) values: &'a Bound<'py, PyAny>,
    pub(crate) links: &'a Bound<'py, PyAny>,
    pub(crate) weights: Option<&'a Bound<'py, PyAny>>,
    pub(crate) posture: Option<&'a Bound<'py, PyAny>>,
    pub(crate) settings: Tracking<f64>,
}

impl<'py> Asked<'_, 'py> {
    /// Reads the arguments for a mechanism.
    pub(crate) fn of(self, mechanism: &Mechanism) -> PyResult<Search<'py>> {
        let named = |name, value| {
            Argument::new(name, NUMBER, &in_order(name, value, &|| mechanism.values())?)
        };
        let targets = Argument::new("targets", EIGHT, self.targets)?;
        let positions = targets.shape().last() == Some(&3);
        let values = named("values", self.values)?;
        let weights = self.weights.map(|value| Argument::new("weights", SIX, value)).transpose()?;
        Ok(Search {
            targets: if positions { targets.of_elements(VECTOR) } else { targets },
            values,
            posture: self.posture.map(|value| named("posture", value)).transpose()?,
            goals: Goals::of(&mechanism.links, self.links, weights.as_ref(), positions)?,
            settings: self.settings,
        })
    }
}

/// The function behind `Mechanism.track` and `Mechanism.sequence`.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "keywords of Python")]
pub fn track<'py>(
    mechanism: &Bound<'py, Mechanism>,
    clips: Option<&Bound<'py, PyAny>>,
    targets: &Bound<'py, PyAny>,
    values: &Bound<'py, PyAny>,
    links: &Bound<'py, PyAny>,
    weights: Option<&Bound<'py, PyAny>>,
    posture: Option<&Bound<'py, PyAny>>,
    angular_tolerance: f64,
    linear_tolerance: f64,
    #[pyo3(from_py_with = iterations)] max_iterations: u32,
    length_per_radian: Option<f64>,
    max_step: f64,
    damping: f64,
    least_gain: f64,
    posture_weight: f64,
    start_weight: f64,
    floating_weight: f64,
    steady: bool,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, ReachReport)> {
    let mechanism = mechanism.get();
    let options = Options {
        angular_tolerance,
        linear_tolerance,
        max_iterations,
        length_per_radian,
        max_step,
        damping,
        restarts: false,
        least_gain,
    };
    let settings = Tracking { options, posture_weight, start_weight, floating_weight, steady };
    let clips = clips.map(|clips| Argument::new("clips", NUMBER, clips)).transpose()?;
    let search = Asked { targets, values, links, weights, posture, settings }.of(mechanism)?;
    all(&mechanism.double, clips.as_ref(), &search, out)
}
