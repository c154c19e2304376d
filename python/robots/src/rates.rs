//! Manipulabilities, velocities of links, and the rates for given velocities, from the Jacobians of
//! many configurations on lanes. No Jacobian leaves the caches.

use crate::argument::{Argument, Input, is_single};
use crate::broadcast::{common, misfit};
use crate::call::Answer;
use crate::columns::in_order;
use crate::configurations::{Configurations, Frame, Values, configurations_per_piece};
use crate::error::{misshapen, value_error};
use crate::links::link_of;
use crate::mechanism::Mechanism;
use crate::number::Number;
use crate::output::Output;
use crate::shape::{NUMBER, SIX};
use crate::threads::Threads;
use dq8::simd::Records;
use dq8::{Backend, Kernel, Lanes, Level};
use dq8_robot::OwnedMechanism;
use dq8_robot::internal::{rate_of, rows, scales};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::sync::OnceLock;

/// √det(J Jᵀ) of the Jacobian J of a link.
#[pyfunction]
pub fn manipulability<'py>(
    mechanism: &Bound<'py, Mechanism>,
    values: &Bound<'py, PyAny>,
    link: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    // It is the same in all frames, and this one is the cheapest.
    found(mechanism, values, link, "world", None, Law::Volume, out)
}

/// The twists J · rates of a link.
#[pyfunction]
pub fn velocity<'py>(
    mechanism: &Bound<'py, Mechanism>,
    values: &Bound<'py, PyAny>,
    rates: &Bound<'py, PyAny>,
    link: &Bound<'py, PyAny>,
    frame: &str,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let rates = in_order("rates", rates, &|| mechanism.get().rates())?;
    let rates = Argument::new("rates", NUMBER, &rates)?;
    found(mechanism, values, link, frame, Some(rates), Law::Twist, out)
}

/// The rates for which |J · rates − twist|² + λ²|rates|² is least.
#[pyfunction]
pub fn rates_for<'py>(
    mechanism: &Bound<'py, Mechanism>,
    values: &Bound<'py, PyAny>,
    twists: &Bound<'py, PyAny>,
    link: &Bound<'py, PyAny>,
    frame: &str,
    damping: f64,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    if !(damping >= 0.0 && damping.is_finite()) {
        return Err(PyValueError::new_err(format!(
            "Expected `damping` to be finite and at least 0, got {damping}."
        )));
    }
    let twists = Argument::new("twists", SIX, twists)?;
    found(mechanism, values, link, frame, Some(twists), Law::Rates { damping }, out)
}

/// The computation from a Jacobian.
#[derive(Clone, Copy, Debug)]
enum Law {
    /// A number.
    Volume,
    /// A twist, of rates.
    Twist,
    /// Rates, of a twist.
    Rates { damping: f64 },
}

fn found<'py>(
    mechanism: &Bound<'py, Mechanism>,
    values: &Bound<'py, PyAny>,
    link: &Bound<'py, PyAny>,
    frame: &str,
    other: Option<Argument<'py>>,
    law: Law,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let (py, mechanism, frame) = (values.py(), mechanism.get(), Frame::of(frame)?);
    let link = link_of(&mechanism.links, "link", link)?;
    let values = Values::of(values, &|| mechanism.values())?;
    let asked = Asked { link, frame, other: other.as_ref(), law };
    if values.is_single() && other.as_ref().is_none_or(|other| is_single([other])) {
        typed(py, asked, mechanism.single()?, &values, out)
    } else {
        typed(py, asked, &mechanism.double, &values, out)
    }
}

/// The arguments of the caller, besides the values.
#[derive(Clone, Copy)]
struct Asked<'a, 'py> {
    link: usize,
    frame: Frame,
    other: Option<&'a Argument<'py>>,
    law: Law,
}

fn typed<'py, R: Number>(
    py: Python<'py>,
    Asked { link, frame, other, law }: Asked<'_, 'py>,
    mechanism: &OwnedMechanism<R>,
    values: &Values<'py>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let view = mechanism.view();
    let (count, rates) = (view.values(), view.rates());
    let values = Configurations::of(mechanism, values)?;
    let other = other.map(|other| of_each::<R>(other, rates)).transpose()?;
    let leading = other.as_ref().map_or(&[][..], |(_, leading, _)| leading);
    let Some(shape) = common([&values.leading[..], leading].into_iter()) else {
        let names = if matches!(law, Law::Twist) { "rates" } else { "twists" };
        return Err(misfit([("values", &values.leading[..]), (names, leading)].into_iter()));
    };
    let values = values.filled(&shape, count)?;
    let core: &[usize] = match law {
        Law::Volume => &[],
        Law::Twist => SIX,
        Law::Rates { .. } => &[rates],
    };
    let output = Output::<R>::new(py, out, &shape, core)?;
    let values = values.apart_from(&output)?;
    let (taken, other) = match other {
        Some((input, _, taken)) => {
            let core: &[usize] = if matches!(law, Law::Twist) { &[rates] } else { &[] };
            let input = input.filled(&[&shape[..], core].concat())?.apart_from(&output)?;
            (taken, Some(input))
        }
        None => (0, None),
    };
    let (given, other) = (values.given(), other.as_ref().map_or(&[][..], Input::numbers));
    let made: usize = core.iter().product();
    let links = [link];
    let job = view.job().links(&links).backend(Backend::best());
    let threads = Threads::for_elements(shape.iter().product::<usize>() * view.links());
    output.fill::<1>(&threads, |to| {
        let (to, failure) = (to.as_flattened_mut(), OnceLock::new());
        if to.is_empty() {
            return Ok(());
        }
        let size = made * configurations_per_piece(view);
        threads.split(size, to, &|(first, to)| {
            let range = first / made..(first + to.len()) / made;
            let mut columns = vec![[R::ZERO; 6]; range.len() * rates];
            let mut poses = vec![[R::ZERO; 8]; range.len()];
            let part = given.part(count, range.clone());
            let done = frame.jacobians(&job, &part, &mut poses, &mut columns);
            let other = &other[range.start * taken..range.end * taken];
            let work = Work { law, rates, columns: &columns, other, to };
            done.map(|()| Backend::best().run(work)).map_err(|error| failure.set(error)).is_ok()
        });
        failure.into_inner().map_or(Ok(()), |error| Err(value_error(error)))
    })
}

/// Rates or twists of each configuration, their leading dimensions, and how many numbers there are
/// in each.
fn of_each<'py, R: Number>(
    argument: &Argument<'py>,
    rates: usize,
) -> PyResult<(Input<'py, R>, Vec<usize>, usize)> {
    let input = Input::<R>::of(argument)?;
    let full = input.full_leading().to_vec();
    if argument.core() == SIX {
        return Ok((input, full, 6));
    }
    match full.split_last() {
        Some((&last, leading)) if last == rates => Ok((input, leading.to_vec(), rates)),
        _ => Err(misshapen(argument.name(), &format!("(..., {rates})"), &full)),
    }
}

/// The columns of some Jacobians, what there is of each configuration, and where the results go.
struct Work<'s, R> {
    law: Law,
    rates: usize,
    columns: &'s [[R; 6]],
    other: &'s [R],
    to: &'s mut [R],
}

impl<R: Number> Kernel for Work<'_, R> {
    type Output = ();
    const WIDE: bool = false;

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { law, rates, columns, other, to } = self;
        let lanes = R::Lanes::<V>::LANES;
        let made = match law {
            Law::Volume => 1,
            Law::Twist => 6,
            Law::Rates { .. } => rates,
        };
        let zero = R::Lanes::<V>::splat(level, R::ZERO);
        let mut own = vec![[zero; 6]; rates];
        for (group, to) in to.chunks_mut(lanes * made).enumerate() {
            let first = group * lanes;
            for (rate, column) in own.iter_mut().enumerate() {
                let from = columns.get(first * rates + rate..).unwrap_or_default();
                *column = R::Lanes::<V>::load_strided(level, from, Some(rates), &[R::ZERO; 6]);
            }
            match law {
                Law::Volume => volume(zero, &mut own).store_partial(to),
                Law::Twist => {
                    let mut twist = [zero; 6];
                    for (rate, column) in own.iter().enumerate() {
                        let from = other.as_chunks::<1>().0.get(first * rates + rate..);
                        let from = from.unwrap_or_default();
                        let stride = Some(rates);
                        let [speed] = R::Lanes::<V>::load_strided(level, from, stride, &[R::ZERO]);
                        for (sum, &row) in twist.iter_mut().zip(column) {
                            *sum = row.mul_add(speed, *sum);
                        }
                    }
                    R::Lanes::<V>::store_records(twist, to.as_chunks_mut().0);
                }
                Law::Rates { damping } => {
                    let from = other.as_chunks().0.get(first..).unwrap_or_default();
                    let twist = R::Lanes::<V>::load_records(level, from, [R::ZERO; 6]);
                    let scales = scales(zero, &mut own, twist, damping);
                    for (rate, column) in own.iter().enumerate() {
                        let sum = rate_of(zero, column, &scales);
                        let places = to.iter_mut().skip(rate).step_by(rates);
                        for (to, &rate) in places.zip(sum.to_array().as_ref()) {
                            *to = rate;
                        }
                    }
                }
            }
        }
    }
}

/// The product of the lengths of the rows, after each was made orthogonal to those before it
/// (Gram–Schmidt); det(J Jᵀ) itself would lose half of the digits near a singularity.
#[inline(always)]
fn volume<L: Lanes>(zero: L, columns: &mut [[L; 6]]) -> L {
    let one = zero.constant(1.0);
    // Six rows of fewer numbers depend on each other.
    let mut volume = if columns.len() < 6 { zero } else { one };
    for first in 0..6 {
        let square = rows(zero, columns, first, first);
        volume = volume * square.sqrt();
        let inverse = L::select(square.eq(zero), zero, one / square);
        for row in first + 1..6 {
            let along = rows(zero, columns, first, row) * inverse;
            for column in &mut *columns {
                column[row] = column[row] - along * column[first];
            }
        }
    }
    volume
}
