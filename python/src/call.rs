//! From a Python call to a sweep: precision, shapes, memory, and the interpreter lock.

use crate::argument::{Argument, Input, Number, Output, is_single, tuple};
use crate::broadcast::Broadcast;
use crate::law::Law;
use crate::sweep::{Arguments, sweep};
use crate::threads::{GRAIN, Threads};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;

/// What a Python function returns.
pub(crate) type Answer<'py> = PyResult<Bound<'py, PyAny>>;

/// From so many elements on, other Python threads run meanwhile: some microseconds of work.
const RELEASE: usize = 512;

/// Runs shorter than this are made into one, with copies of what is broadcast.
const SHORT: usize = 32;

/// `law` of the arguments; the result has the last dimensions `core` and is written to `out`, if given.
pub(crate) fn call<'py, F, const A: usize, const B: usize, const C: usize, const D: usize>(
    py: Python<'py>,
    law: F,
    arguments: [Option<Argument<'_, 'py>>; 3],
    core: &[usize],
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py>
where
    F: Law<A, B, C, D>,
{
    if is_single(&arguments)? {
        typed::<f32, F, A, B, C, D>(py, law, arguments, core, out)
    } else {
        typed::<f64, F, A, B, C, D>(py, law, arguments, core, out)
    }
}

fn typed<'py, R, F, const A: usize, const B: usize, const C: usize, const D: usize>(
    py: Python<'py>,
    law: F,
    arguments: [Option<Argument<'_, 'py>>; 3],
    core: &[usize],
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py>
where
    R: Number,
    F: Law<A, B, C, D>,
{
    let names = arguments;
    let mut inputs = [None, None, None];
    for (input, argument) in inputs.iter_mut().zip(arguments) {
        *input = argument.map(Input::<R>::of).transpose()?;
    }
    let mut broadcast = broadcast(&inputs, names)?;
    let output = Output::<R>::new(py, out, &broadcast.shape, core)?;
    for input in &mut inputs {
        *input = input.take().map(|input| input.apart_from(&output)).transpose()?;
    }
    if broadcast.runs() > 1 && broadcast.run < SHORT {
        for input in &mut inputs {
            // One for all stays one for all.
            if input.as_ref().is_some_and(|input| input.leading().iter().any(|&size| size > 1)) {
                *input = input.take().map(|input| input.filled(&broadcast.shape)).transpose()?;
            }
        }
        broadcast = self::broadcast(&inputs, names)?;
    }

    let [a, b, c] = &inputs;
    let arguments = Arguments { a: records(a), b: records(b), c: records(c) };
    let mut memory = output.borrow()?;
    // It is contiguous.
    let to = memory.as_slice_mut().map(|numbers| numbers.as_chunks_mut::<D>().0);
    let to = to.map_err(|error| PyValueError::new_err(error.to_string()))?;
    if to.len() < RELEASE {
        runs(law, arguments, &broadcast, to);
    } else {
        py.detach(|| runs(law, arguments, &broadcast, to));
    }
    drop(memory);
    output.finish()
}

/// What is not there has one element of no numbers, for every other.
fn records<'s, R: Number, const C: usize>(input: &'s Option<Input<'_, R>>) -> &'s [[R; C]] {
    input.as_ref().map_or(&[], |input| input.records())
}

fn broadcast<R: Number>(
    inputs: &[Option<Input<'_, R>>; 3],
    arguments: [Option<Argument<'_, '_>>; 3],
) -> PyResult<Broadcast> {
    let shapes = [0, 1, 2].map(|i| inputs[i].as_ref().map_or(&[][..], |input| input.leading()));
    Broadcast::of(shapes).ok_or_else(|| {
        let given: Vec<_> = arguments
            .iter()
            .zip(shapes)
            .filter_map(|(argument, shape)| Some(format!("`{}` {}", (*argument)?.name, tuple(shape))))
            .collect();
        PyValueError::new_err(format!(
            "operands could not be broadcast together: leading dimensions {}",
            given.join(", ")
        ))
    })
}

/// Every run of a broadcast.
fn runs<R, F, const A: usize, const B: usize, const C: usize, const D: usize>(
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
    let threads = Threads::for_elements(to.len());
    let run = |threads: &Threads, index: usize, to: &mut [[R; D]]| {
        let [a, b, c] = broadcast.begin(index);
        let arguments = Arguments {
            a: arguments.a.get(a..).unwrap_or_default(),
            b: arguments.b.get(b..).unwrap_or_default(),
            c: arguments.c.get(c..).unwrap_or_default(),
        };
        sweep(threads, law, arguments, broadcast.each, to);
    };
    // Long runs are split, short ones are handed out whole.
    if threads.many() && broadcast.run < 2 * GRAIN {
        let alone = Threads::for_elements(0);
        let pieces = to.par_chunks_mut(broadcast.run).enumerate();
        threads.install(|| pieces.for_each(|(index, to)| run(&alone, index, to)));
    } else {
        for (index, to) in to.chunks_mut(broadcast.run).enumerate() {
            run(&threads, index, to);
        }
    }
}
