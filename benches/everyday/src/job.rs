//! One way to do an operation.

use dq8_fixtures::turns::Job;
use std::hint::black_box;

/// Long against the tick of the clock, short against the slice that another process takes.
const PASSES: u32 = 100;

/// `operation` on each of `inputs`, from memory to memory.
pub(crate) fn job<I, O, F>(name: &'static str, inputs: Vec<I>, operation: F) -> Job<'static>
where
    I: 'static,
    O: 'static,
    F: Fn(&I) -> O + Copy + 'static,
{
    let mut outputs: Vec<O> = inputs.iter().map(operation).collect();
    let pass = move || over(black_box(&inputs), black_box(&mut outputs), operation);
    Job::new(name, pass).repeated(PASSES)
}

/// The loop that a user would write, apart, so that it stands alone in the machine code.
#[inline(never)]
fn over<I, O>(inputs: &[I], outputs: &mut [O], operation: impl Fn(&I) -> O) {
    for (output, input) in outputs.iter_mut().zip(inputs) {
        *output = operation(black_box(input));
    }
}
