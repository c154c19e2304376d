//! From a Python call to a sweep: precision, shapes, memory, and the interpreter lock.

use crate::argument::{Argument, Input, is_single};
use crate::broadcast::{Broadcast, cycles, misfit};
use crate::law::{Each, Law, Operand};
use crate::number::Number;
use crate::output::Output;
use crate::sweep::{Arguments, sweep};
use crate::threads::{GRAIN, Threads};
use dq8::simd::MAX_LANES;
use pyo3::prelude::*;

/// What a Python function returns.
pub type Answer<'py> = PyResult<Bound<'py, PyAny>>;

/// From so many elements on, other Python threads run meanwhile: some microseconds of work.
const RELEASE: usize = 512;

/// Runs shorter than this are made into one: beginning a run costs as much as some elements.
const SHORT: usize = 32;

/// `law` of the arguments; the result has the last dimensions `core` and is written to `out`, if given.
pub fn call<'py, F, const A: usize, const B: usize, const C: usize, const D: usize>(
    py: Python<'py>,
    law: F,
    arguments: &[Argument<'py>],
    core: &[usize],
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py>
where
    F: Law<A, B, C, D>,
{
    if is_single(arguments) {
        typed::<f32, F, A, B, C, D>(py, law, arguments, core, out)
    } else {
        typed::<f64, F, A, B, C, D>(py, law, arguments, core, out)
    }
}

fn typed<'py, R, F, const A: usize, const B: usize, const C: usize, const D: usize>(
    py: Python<'py>,
    law: F,
    arguments: &[Argument<'py>],
    core: &[usize],
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py>
where
    R: Number,
    F: Law<A, B, C, D>,
{
    let Ready { mut inputs, broadcast, output, cycling } = ready::<R>(py, arguments, core, out)?;
    let large = broadcast.shape.iter().product::<usize>() >= RELEASE;
    let _held = large.then(|| output.held());
    if large {
        inputs = inputs.map(|input| input.map(Input::held));
    }
    let [a, b, c] = &inputs;
    let (mut cycle_a, mut cycle_b, mut cycle_c) = (Vec::new(), Vec::new(), Vec::new());
    let arguments = Arguments {
        a: operand(a, cycling, &mut cycle_a),
        b: operand(b, cycling, &mut cycle_b),
        c: operand(c, cycling, &mut cycle_c),
    };
    output.fill_attached(|to| {
        let threads = Threads::for_elements(to.len());
        let compute = |to| {
            runs(&threads, law, arguments, &broadcast, to);
            Ok(())
        };
        if large { threads.run(py, || compute(to)) } else { compute(to) }
    })
}

/// What a call needs that does not depend on its law.
struct Ready<'py, R: Number> {
    inputs: [Option<Input<'py, R>>; 3],
    broadcast: Broadcast,
    output: Output<'py, R>,
    /// How many elements there are if arguments are read over and over.
    cycling: Option<usize>,
}

fn ready<'py, R: Number>(
    py: Python<'py>,
    arguments: &[Argument<'py>],
    core: &[usize],
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<Ready<'py, R>> {
    let mut inputs = [None, None, None];
    for (input, argument) in inputs.iter_mut().zip(arguments) {
        *input = Some(Input::<R>::attached(argument)?);
    }
    let mut broadcast = broadcast(&inputs, arguments)?;
    let output = Output::<R>::new(py, out, &broadcast.shape, core)?;
    for input in &mut inputs {
        *input = input.take().map(|input| input.apart_from(&output)).transpose()?;
    }
    // Short runs are made into one: what cycles is read over and over, what does not is repeated in memory.
    let short = broadcast.runs() > 1 && broadcast.run < SHORT;
    if short {
        let mut each = [false; 3];
        for (input, each) in inputs.iter_mut().zip(&mut each) {
            let Some(argument) = input.take() else { continue };
            *each = argument.leading().iter().any(|&size| size > 1);
            let as_it_is = !*each || cycles(argument.leading(), &broadcast.shape);
            *input = Some(if as_it_is { argument } else { argument.filled(&broadcast.shape)? });
        }
        broadcast = Broadcast::flat(broadcast.shape, each);
    }
    let cycling = short.then_some(broadcast.run);
    Ok(Ready { inputs, broadcast, output, cycling })
}

/// The elements of an argument. If there must be `cycling` of them and there are fewer, then those over and
/// over, from `cycle`.
fn operand<'s, R: Number, const C: usize>(
    input: &'s Option<Input<'_, R>>,
    cycling: Option<usize>,
    cycle: &'s mut Vec<[R; C]>,
) -> Each<'s, R, C> {
    let records = input.as_ref().map_or(&[][..], |input| input.records());
    if cycling.is_none_or(|count| records.len() <= 1 || records.len() == count) {
        return Each::of(records);
    }
    cycle.extend(records.iter().cycle().take(records.len() + MAX_LANES));
    Each { records: cycle, period: records.len(), first: 0 }
}

fn broadcast<R: Number>(
    inputs: &[Option<Input<'_, R>>; 3],
    arguments: &[Argument<'_>],
) -> PyResult<Broadcast> {
    let once = [0, 1, 2].map(|i| inputs[i].as_ref().map_or(&[][..], |input| input.leading()));
    let shapes =
        [0, 1, 2].map(|i| inputs[i].as_ref().map_or(&[][..], |input| input.full_leading()));
    Broadcast::of(shapes, once).ok_or_else(|| {
        misfit(arguments.iter().zip(shapes).map(|(argument, shape)| (argument.name(), shape)))
    })
}

/// Every run of a broadcast.
fn runs<R, F, const A: usize, const B: usize, const C: usize, const D: usize>(
    threads: &Threads,
    law: F,
    arguments: Arguments<'_, R, A, B, C>,
    broadcast: &Broadcast,
    to: &mut [[R; D]],
) where
    R: Number,
    F: Law<A, B, C, D>,
{
    if to.is_empty() {
        return;
    }
    let run = |index: usize, to: &mut [[R; D]]| {
        let [a, b, c] = broadcast.begin(index);
        let arguments =
            Arguments { a: arguments.a.from(a), b: arguments.b.from(b), c: arguments.c.from(c) };
        sweep(threads, law, arguments, broadcast.each, to);
    };
    let each_run = |first: usize, to: &mut [[R; D]]| {
        for (index, to) in to.chunks_mut(broadcast.run).enumerate() {
            run(first + index, to);
        }
    };
    // Long runs are split, short ones are handed out whole, some together.
    if broadcast.run >= 2 * GRAIN {
        return each_run(0, to);
    }
    let together = broadcast.run * GRAIN.div_ceil(broadcast.run);
    threads.split(together, to, &|(first, to)| {
        each_run(first / broadcast.run, to);
        true
    });
}
