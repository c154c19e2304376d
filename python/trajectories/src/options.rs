//! [`Options`]: what the caller of a job chose.

use crate::argument::{Argument, Input};
use crate::call::Answer;
use crate::error::{misshapen, value_error};
use crate::output::Output;
use crate::pieces::{Piece, in_pieces, size};
use crate::shape::{EIGHT, NUMBER};
use crate::threads::Threads;
use dq8::DualQuat;
use dq8_trajectory::{Frame, Job, Outside, TrajectoryError};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyString;

/// The clock of the times, the frame of the results, and what is outside the stamps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Options {
    origin: f64,
    unit: f64,
    frame: Frame,
    outside: Outside,
}

impl Options {
    pub(crate) fn new(
        (origin, unit): (f64, f64),
        frame: Option<&Bound<'_, PyAny>>,
        outside: &str,
    ) -> PyResult<Self> {
        let outside = match outside {
            "hold" => Outside::Hold,
            "continue" => Outside::Continue,
            "refuse" => Outside::Refuse,
            _ => {
                return Err(PyValueError::new_err(format!(
                    "Expected `outside` to be 'hold', 'continue' or 'refuse', got '{outside}'."
                )));
            }
        };
        let frame = frame.map_or(Ok(Frame::World), frame_of)?;
        Ok(Self { origin, unit, frame, outside })
    }

    /// The job with these options.
    pub(crate) fn of<P: Copy>(self, job: Job<P>) -> Job<P> {
        job.clock(self.origin, self.unit).frame(self.frame).outside(self.outside)
    }

    /// A time on the clock of the stamps, in seconds.
    pub(crate) fn stamp(self, time: f64) -> f64 {
        time * self.unit + self.origin
    }

    /// An error for the first time that is outside, where that is refused: before any piece of the
    /// work is done, each of which would find it only in itself.
    pub(crate) fn check(self, [first, last]: [f64; 2], times: &[f64]) -> PyResult<()> {
        if self.outside != Outside::Refuse {
            return Ok(());
        }
        match times.iter().position(|&time| !(first..=last).contains(&self.stamp(time))) {
            Some(index) => {
                let value = self.stamp(times[index]);
                let error = TrajectoryError::Outside { index, value, first, last };
                Err(value_error(format!("`times`: {error}.")))
            }
            None => Ok(()),
        }
    }
}

/// The times at which something is asked for, and who says what is there.
pub(crate) struct Asked<'a, 'py> {
    pub(crate) times: &'a Bound<'py, PyAny>,
    pub(crate) options: Options,
    /// The first stamp and the last.
    pub(crate) range: [f64; 2],
    /// How many there are.
    pub(crate) stamps: usize,
    pub(crate) out: Option<&'a Bound<'py, PyAny>>,
}

/// What is at some of the times.
type Work<'f, const C: usize> =
    dyn Fn(&[f64], &mut [[f64; C]]) -> Result<(), TrajectoryError> + Sync + 'f;

impl<'py> Asked<'_, 'py> {
    /// An element of the shape `core` for each time, from `work` on some of them.
    pub(crate) fn answer<const C: usize>(self, core: &[usize], work: &Work<'_, C>) -> Answer<'py> {
        let times = Input::<f64>::of(&Argument::new("times", NUMBER, self.times)?)?.in_full()?;
        let output = Output::<f64>::new(times.py(), self.out, times.full_leading(), core)?;
        let times = times.apart_from(&output)?;
        let at = times.numbers();
        self.options.check(self.range, at)?;
        let (threads, size) = (Threads::for_elements(at.len()), size(self.stamps));
        output.fill(&threads, |to: &mut [[f64; C]]| {
            let work: &Piece<'_, _> = &|first, to| work(&at[first..first + to.len()], to);
            in_pieces(&threads, size, to, work)
        })
    }
}

/// What Python calls so: a name, a time in seconds, or a pose.
fn frame_of(frame: &Bound<'_, PyAny>) -> PyResult<Frame> {
    if let Ok(name) = frame.cast::<PyString>() {
        return match name.to_str()? {
            "world" => Ok(Frame::World),
            "start" => Ok(Frame::Start),
            "end" => Ok(Frame::End),
            name => Err(PyValueError::new_err(format!(
                "Expected `frame` to be 'world', 'start', 'end', a time or a pose, got '{name}'."
            ))),
        };
    }
    if let Ok(time) = frame.extract::<f64>() {
        return Ok(Frame::At(time));
    }
    let pose = Input::<f64>::of(&Argument::new("frame", EIGHT, frame)?)?;
    match pose.records::<8>() {
        [one] if pose.full_leading().is_empty() => Ok(Frame::Pose(DualQuat::from_array(*one))),
        _ => Err(misshapen("frame", "(8,)", &pose.shape())),
    }
}
