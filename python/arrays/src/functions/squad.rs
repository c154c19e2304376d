//! Smooth motion through key poses.

use super::motion;
use crate::argument::{Argument, Input, common_dtype, is_single};
use crate::broadcast::{common, misfit};
use crate::call::Answer;
use crate::law::{Each, OneOrEach, Operand, store};
use crate::number::Number;
use crate::output::Output;
use crate::shape::{EIGHT, NUMBER};
use crate::threads::{GRAIN, Threads};
use dq8::{Backend, Kernel, Lanes, Level, batch};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// A motion made of `N` motions and a number. All of them compute so much that a look at where an
/// argument lies does not count, so there is one kernel for all broadcasts.
trait OfMany<const N: usize>: Copy + Send + Sync {
    /// On lanes.
    fn of<L: Lanes>(self, motions: [batch::DualQuat<L>; N], t: L) -> batch::DualQuat<L>;
}

#[derive(Clone, Copy)]
struct Squad;
impl OfMany<4> for Squad {
    #[inline(always)]
    fn of<L: Lanes>(self, motions: [batch::DualQuat<L>; 4], t: L) -> batch::DualQuat<L> {
        let [start, control_start, control_end, end] = motions;
        start.squad(control_start, control_end, end, t)
    }
}

/// Smooth motion from key pose to key pose, drawn toward two control poses that it does not pass
/// through.
///
/// ``sclerp(sclerp(start, end, t), sclerp(control_start, control_end, t), 2t(1 − t))``
///
/// With controls from `squad_control`, velocities of points and angles are continuous across keys
/// at even times. Each of the three goes the shorter way, so signs do not matter, and consecutive
/// keys should be less than half a turn apart.
///
/// Parameters
/// ----------
/// start, control_start, control_end, end : array_like, shape (..., 8)
///     Unit dual quaternions: the key poses at t = 0 and t = 1, and their controls.
/// t : array_like, shape (...)
///     Where between them. Leading dimensions of all five broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
///
/// References
/// ----------
/// K. Shoemake, "Quaternion calculus and fast animation", SIGGRAPH course notes, 1987, with
/// `sclerp` for slerp.
///
/// Examples
/// --------
/// >>> import dq8
/// >>> keys = dq8.from_translation([[0.0, 0, 0], [1, 1, 0], [2, 0, 0], [3, 1, 0]])
/// >>> controls = dq8.squad_control(keys[:-2], keys[1:-1], keys[2:])
/// >>> dq8.translation(dq8.squad(keys[1], controls[0], controls[1], keys[2], 0.5))
/// array([1.5, 0.5, 0. ])
#[pyfunction]
#[pyo3(signature = (start, control_start, control_end, end, t, *, out=None))]
pub fn squad<'py>(
    start: &Bound<'py, PyAny>,
    control_start: &Bound<'py, PyAny>,
    control_end: &Bound<'py, PyAny>,
    end: &Bound<'py, PyAny>,
    t: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let motions = [
        Argument::new("start", EIGHT, start)?,
        Argument::new("control_start", EIGHT, control_start)?,
        Argument::new("control_end", EIGHT, control_end)?,
        Argument::new("end", EIGHT, end)?,
    ];
    of_many(Squad, &motions, Some(&Argument::new("t", NUMBER, t)?), out)
}

#[derive(Clone, Copy)]
struct Control;
impl OfMany<3> for Control {
    #[inline(always)]
    fn of<L: Lanes>(self, motions: [batch::DualQuat<L>; 3], _: L) -> batch::DualQuat<L> {
        let [previous, current, next] = motions;
        batch::DualQuat::squad_control(previous, current, next)
    }
}

/// The control poses of key poses for `squad`: ``σ exp(−(log(σ*σ₊) + log(σ*σ₋))/4)``.
///
/// With them the motion passes through σ with the mean of the screws from the key before and to
/// the key after. At the ends of a path give the key itself for the neighbour it has not. Keys
/// evenly spaced along a screw are their own controls.
///
/// Parameters
/// ----------
/// previous, current, next : array_like, shape (..., 8)
///     Unit dual quaternions: key poses σ₋, σ and σ₊, one after the other; leading
///     dimensions broadcast.
/// out : ndarray, optional
///     Where to write the result.
///
/// Returns
/// -------
/// ndarray, shape (..., 8)
#[doc = common_dtype!()]
///
/// References
/// ----------
/// K. Shoemake, "Quaternion calculus and fast animation", SIGGRAPH course notes, 1987.
///
/// Examples
/// --------
/// >>> import dq8
/// >>> keys = dq8.from_translation([[0.0, 0, 0], [1, 1, 0], [2, 0, 0]])
/// >>> dq8.translation(dq8.squad_control(*keys))
/// array([1. , 1.5, 0. ])
#[pyfunction]
#[pyo3(signature = (previous, current, next, *, out=None))]
pub fn squad_control<'py>(
    previous: &Bound<'py, PyAny>,
    current: &Bound<'py, PyAny>,
    next: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let motions = [
        Argument::new("previous", EIGHT, previous)?,
        Argument::new("current", EIGHT, current)?,
        Argument::new("next", EIGHT, next)?,
    ];
    of_many(Control, &motions, None, out)
}

fn of_many<'py, F: OfMany<N>, const N: usize>(
    law: F,
    motions: &[Argument<'py>; N],
    t: Option<&Argument<'py>>,
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    if is_single(motions.iter().chain(t)) {
        typed::<f32>(motions, t, out, &|motions, t, to| sweep(law, motions, t, to))
    } else {
        typed::<f64>(motions, t, out, &|motions, t, to| sweep(law, motions, t, to))
    }
}

/// What computes a piece of motions and t: all that is compiled for each law.
type Compute<'f, R> =
    dyn Fn(&[OneOrEach<'_, R, 8>], OneOrEach<'_, R, 1>, &mut [[R; 8]]) + Sync + 'f;

fn typed<'py, R: Number>(
    motions: &[Argument<'py>],
    t: Option<&Argument<'py>>,
    out: Option<&Bound<'py, PyAny>>,
    compute: &Compute<'_, R>,
) -> Answer<'py> {
    let mut inputs = Vec::with_capacity(motions.len() + 1);
    for argument in motions.iter().chain(t) {
        inputs.push((argument.name(), Input::<R>::of(argument)?));
    }
    let shapes = || inputs.iter().map(|(name, input)| (*name, input.full_leading()));
    let shape = common(shapes().map(|(_, shape)| shape)).ok_or_else(|| misfit(shapes()))?;
    let Some(py) = inputs.first().map(|(_, input)| input.py()) else {
        return Err(PyValueError::new_err("There are no motions."));
    };
    let output = Output::<R>::new(py, out, &shape, EIGHT)?;
    let mut ready = Vec::with_capacity(inputs.len());
    for (_, input) in inputs {
        let input = if input.is_one() { input } else { input.filled(&shape)? };
        ready.push(input.apart_from(&output)?);
    }

    let (motions, t) = ready.split_at(motions.len());
    let motions: Vec<_> = motions.iter().map(|motion| operand(Some(motion))).collect();
    let t = operand(t.first());
    let threads = Threads::for_elements(shape.iter().product());
    output.fill(&threads, |to| {
        threads.split(GRAIN, to, &|(first, to)| {
            let motions: Vec<_> = motions.iter().map(|motion| motion.from(first)).collect();
            compute(&motions, t.from(first), to);
            true
        });
        Ok(())
    })
}

/// The elements of an argument; zeros if there is none.
fn operand<'s, R: Number, const C: usize>(input: Option<&'s Input<'_, R>>) -> OneOrEach<'s, R, C> {
    let records = input.map_or(&[][..], |input| input.records());
    OneOrEach::of(Each::of(records), input.is_some_and(|input| !input.is_one()))
}

/// Writes `law` of as many motions as it has.
fn sweep<R: Number, F: OfMany<N>, const N: usize>(
    law: F,
    motions: &[OneOrEach<'_, R, 8>],
    t: OneOrEach<'_, R, 1>,
    to: &mut [[R; 8]],
) {
    let Ok(motions) = motions.try_into() else { return };
    Backend::best().run(OfEach { law, motions, t, to });
}

struct OfEach<'s, R, F, const N: usize> {
    law: F,
    motions: [OneOrEach<'s, R, 8>; N],
    t: OneOrEach<'s, R, 1>,
    to: &'s mut [[R; 8]],
}

impl<R: Number, F: OfMany<N>, const N: usize> Kernel for OfEach<'_, R, F, N> {
    type Output = ();

    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        let Self { law, motions: from, t, to } = self;
        let mut motions = [batch::DualQuat::<R::Lanes<V>>::identity(level); N];
        let mut first = 0;
        while let Some(rest) = to.get_mut(first..).filter(|rest| !rest.is_empty()) {
            for (loaded, from) in motions.iter_mut().zip(from) {
                let Some(components) = from.load(level, first) else { return };
                *loaded = motion(components);
            }
            let Some([t]) = t.load(level, first) else { return };
            store(law.of(motions, t).to_array(), rest);
            first += R::Lanes::<V>::LANES;
        }
    }
}
