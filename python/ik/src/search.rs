//! [`Search`]: the arguments of every search, and their conversion to one precision.

use crate::argument::{Argument, Input};
use crate::error::misshapen;
use crate::goals::Goals;
use crate::number::Number;
use dq8::{DualQuat, Real};
use dq8_robot::Mechanism;
use dq8_robot::ik::{Freedom, Goal, Options, Reach, ReachError, Tracking};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::ops::Range;

/// The arguments of a search.
#[derive(Debug)]
pub struct Search<'py> {
    /// Poses or positions, one for each goal.
    pub targets: Argument<'py>,
    /// The configurations from which the search starts.
    pub values: Argument<'py>,
    /// The links, the points on them and the weights: what the targets are for.
    pub goals: Goals,
    /// The configuration to stay near.
    pub posture: Option<Argument<'py>>,
    /// The limits of the search, and its other weights.
    pub settings: Tracking<f64>,
}

/// The goals, the freedoms and the posture of a search in one precision. The search borrows them.
pub(crate) struct Parts<'py, R: Number> {
    goals: Vec<Goal<R>>,
    freedoms: Vec<Freedom<R>>,
    posture: Option<Input<'py, R>>,
}

impl<'py, R: Number> Parts<'py, R> {
    pub(crate) fn of(search: &Search<'py>, mechanism: Mechanism<'_, R>) -> PyResult<Self> {
        let count = mechanism.values();
        let posture = search.posture.as_ref().map(Input::<R>::of).transpose()?;
        if let Some(posture) = &posture
            && posture.full_leading() != [count]
        {
            return Err(misshapen("posture", &format!("({count},)"), &posture.shape()));
        }
        let posture = posture.map(Input::in_full).transpose()?;
        let goals = search.goals.goals.iter().map(Goal::cast).collect();
        Ok(Self { goals, freedoms: vec![Freedom::default(); mechanism.rates()], posture })
    }

    pub(crate) fn reach<'a>(&'a mut self, mechanism: Mechanism<'a, R>) -> PyResult<Reach<'a, R>> {
        let reach = Reach::new(mechanism, &self.goals, &mut self.freedoms).map_err(named)?;
        let Some(posture) = &self.posture else { return Ok(reach) };
        reach.with_posture(posture.numbers()).map_err(named)
    }
}

/// Makes the exception of an error, which begins with the name of the wrong argument.
fn named(error: ReachError) -> PyErr {
    let argument = match error {
        ReachError::NoGoals
        | ReachError::Link { .. }
        | ReachError::Point { .. }
        | ReachError::Unmoved { .. } => "`links`: ",
        ReachError::Weight { .. } | ReachError::NoWeight { .. } => "`weights`: ",
        ReachError::PostureLength { .. } | ReachError::Posture { .. } => "`posture`: ",
        _ => "",
    };
    PyValueError::new_err(format!("{argument}{error}."))
}

/// Checks the settings and returns them in the precision of the call.
pub(crate) fn settings<R: Number>(settings: &Tracking<f64>) -> PyResult<Tracking<R>> {
    // As the call will see it: what is tiny may be zero there, and what is huge infinite.
    let number = |name: &str, what: &str, value: f64, fits: fn(f64) -> bool| {
        if fits(<R as Real>::from_f64(value).into()) {
            return Ok(());
        }
        Err(PyValueError::new_err(format!("Expected `{name}` to be {what}, got {value}.")))
    };
    let Tracking { options, posture_weight, start_weight, floating_weight, .. } = *settings;
    let Options { angular_tolerance, linear_tolerance, damping, least_gain, .. } = options;
    for (name, value) in
        [("angular_tolerance", angular_tolerance), ("linear_tolerance", linear_tolerance)]
    {
        number(name, "at least 0", value, |value| value >= 0.0)?;
    }
    if let Some(length) = options.length_per_radian {
        let fits = |length: f64| length > 0.0 && length.is_finite();
        number("length_per_radian", "finite and more than 0", length, fits)?;
    }
    number("max_step", "more than 0", options.max_step, |step| step > 0.0)?;
    number("least_gain", "from 0 to 1", least_gain, |gain| (0.0..=1.0).contains(&gain))?;
    for (name, value) in [
        ("damping", damping),
        ("posture_weight", posture_weight),
        ("start_weight", start_weight),
        ("floating_weight", floating_weight),
    ] {
        let fits = |value: f64| value >= 0.0 && value.is_finite();
        number(name, "finite and at least 0", value, fits)?;
    }
    Ok(settings.cast())
}

/// Returns the leading dimensions of configurations that have `count` values each.
pub(crate) fn configurations<'s, R: Number>(
    values: &'s Input<'_, R>,
    count: usize,
) -> PyResult<&'s [usize]> {
    match values.full_leading().split_last() {
        Some((&last, leading)) if last == count => Ok(leading),
        _ => Err(misshapen("values", &format!("(..., {count})"), &values.shape())),
    }
}

/// Returns the leading dimensions of targets, without the dimension that counts goals.
pub(crate) fn of_goals<'s, R: Number>(
    targets: &'s Input<'_, R>,
    goals: &Goals,
) -> PyResult<&'s [usize]> {
    let full = targets.full_leading();
    match full.split_last() {
        _ if goals.one => Ok(full),
        Some((&count, leading)) if count == goals.goals.len() => Ok(leading),
        _ => {
            let expected = format!("(..., {}, {})", goals.goals.len(), targets.size());
            Err(misshapen("targets", &expected, &targets.shape()))
        }
    }
}

/// Rows of `size` numbers: one row for each configuration, or one row for all of them.
#[derive(Clone, Copy)]
pub(crate) struct Rows<'s, R> {
    numbers: &'s [R],
    size: usize,
}

impl<'s, R: Number> Rows<'s, R> {
    pub(crate) fn at(&self, index: usize) -> &'s [R] {
        let first = if self.numbers.len() == self.size { 0 } else { index * self.size };
        &self.numbers[first..first + self.size]
    }

    /// Adds the targets of the configurations `each`. A target has `size` numbers: eight of a pose,
    /// or three of a position.
    pub(crate) fn targets<S: Real>(
        &self,
        each: Range<usize>,
        size: usize,
        to: &mut Vec<DualQuat<S>>,
    ) {
        for index in each {
            to.extend(self.at(index).chunks_exact(size).map(|record| {
                let mut numbers = [S::ZERO; 8];
                for (to, from) in numbers.iter_mut().zip(record) {
                    *to = S::from_f64((*from).into());
                }
                match numbers {
                    [x, y, z, ..] if size == 3 => DualQuat::from_translation([x, y, z]),
                    numbers => DualQuat::from_array(numbers),
                }
            }));
        }
    }

    pub(crate) fn of<'py>(input: &'s Input<'py, R>, each: &[usize]) -> Self {
        Self { numbers: input.numbers(), size: each.iter().product::<usize>() * input.size() }
    }
}

/// Lays an input out in memory, `each` elements for each index of `shape`; or only once if the same
/// elements serve every index.
pub(crate) fn filled<'py, R: Number>(
    input: Input<'py, R>,
    shape: &[usize],
    each: &[usize],
) -> PyResult<Input<'py, R>> {
    let own = input.leading();
    let once = own.ends_with(each) && own[..own.len() - each.len()].iter().all(|&size| size == 1);
    if once { Ok(input) } else { input.filled(&[shape, each].concat()) }
}
