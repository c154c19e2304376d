//! From a Python call to a sweep: precision, shapes, memory, and the interpreter lock.

use crate::argument::{Argument, Input, is_single};
use crate::broadcast::{Broadcast, cycles, misfit};
use crate::law::{Law, Numbers};
use crate::number::Number;
use crate::output::Output;
use crate::sweep::{Piece, sweep};
use crate::threads::{GRAIN, Threads};
use dq8::simd::MAX_LANES;
use pyo3::prelude::*;

/// What a Python function returns.
pub type Answer<'py> = PyResult<Bound<'py, PyAny>>;

/// From so many elements on, other Python threads run meanwhile: some microseconds of work.
const RELEASE: usize = 512;

/// Runs shorter than this are made into one: beginning a run costs as much as some elements.
const SHORT: usize = 32;

/// What computes a piece: all that is compiled for each law.
type Compute<'f, R> = dyn Fn(Piece<'_, R>) + Sync + 'f;

/// `law` of the arguments; the result has the last dimensions `core` and is written to `out`, if
/// given.
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
        typed::<f32>(py, &|piece| sweep(law, piece), arguments, core, out)
    } else {
        typed::<f64>(py, &|piece| sweep(law, piece), arguments, core, out)
    }
}

fn typed<'py, R: Number>(
    py: Python<'py>,
    compute: &Compute<'_, R>,
    arguments: &[Argument<'py>],
    core: &[usize],
    out: Option<&Bound<'py, PyAny>>,
) -> Answer<'py> {
    let Ready { mut inputs, broadcast, output, cycling } = ready::<R>(py, arguments, core, out)?;
    let large = broadcast.shape.iter().product::<usize>() >= RELEASE;
    let _held = large.then(|| output.held());
    if large {
        inputs = inputs.map(|input| input.map(Input::held));
    }
    let [a, b, c] = &inputs;
    let (mut cycle_a, mut cycle_b, mut cycle_c) = (Vec::new(), Vec::new(), Vec::new());
    let arguments = [
        operand(a, cycling, &mut cycle_a),
        operand(b, cycling, &mut cycle_b),
        operand(c, cycling, &mut cycle_c),
    ];
    let runs = Runs { arguments, broadcast: &broadcast, size: core.iter().product(), compute };
    output.fill_attached(|to| {
        let threads = Threads::for_elements(to.len() / runs.size);
        let compute = |to| {
            runs.write(&threads, to);
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
    // Short runs are made into one: what cycles is read over and over, what does not is repeated in
    // memory.
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

/// The elements of an argument. If there must be `cycling` of them and there are fewer, then those
/// over and over, from `cycle`.
fn operand<'s, R: Number>(
    input: &'s Option<Input<'_, R>>,
    cycling: Option<usize>,
    cycle: &'s mut Vec<R>,
) -> Numbers<'s, R> {
    let Some(input) = input else { return Numbers::of(&[]) };
    let (numbers, size) = (input.numbers(), input.size());
    let count = numbers.len() / size;
    if cycling.is_none_or(|all| count <= 1 || count == all) {
        return Numbers::of(numbers);
    }
    cycle.extend(numbers.iter().cycle().take(numbers.len() + MAX_LANES * size));
    Numbers { period: count, ..Numbers::of(cycle) }
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

/// Every run of a broadcast, each of whose results has `size` numbers.
struct Runs<'s, R> {
    arguments: [Numbers<'s, R>; 3],
    broadcast: &'s Broadcast,
    size: usize,
    compute: &'s Compute<'s, R>,
}

impl<R: Number> Runs<'_, R> {
    fn write(&self, threads: &Threads, to: &mut [R]) {
        if to.is_empty() {
            return;
        }
        let run = self.broadcast.run;
        // Long runs are split, short ones are handed out whole, some together.
        if run >= 2 * GRAIN {
            return self.some(threads, 0, to);
        }
        let together = run * GRAIN.div_ceil(run) * self.size;
        threads.split(together, to, &|(first, to)| {
            self.some(threads, first / (run * self.size), to);
            true
        });
    }

    /// Those from number `first` on.
    fn some(&self, threads: &Threads, first: usize, to: &mut [R]) {
        let Self { arguments, broadcast, size, compute } = *self;
        for (index, to) in to.chunks_mut(broadcast.run * size).enumerate() {
            let begin = broadcast.begin(first + index);
            // What is one for all is so for each piece.
            let begin = |at| {
                [0, 1, 2].map(|i| arguments[i].from(begin[i] + at * usize::from(broadcast.each[i])))
            };
            if broadcast.each == [false; 3] {
                // One for all, all of them: one element says what all are.
                let (one, rest) = to.split_at_mut(size);
                compute(Piece { arguments: begin(0), each: [true, false, false], to: one });
                rest.chunks_mut(size).for_each(|to| to.copy_from_slice(one));
                continue;
            }
            threads.split(GRAIN * size, to, &|(at, to)| {
                compute(Piece { arguments: begin(at / size), each: broadcast.each, to });
                true
            });
        }
    }
}
