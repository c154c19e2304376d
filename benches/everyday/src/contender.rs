//! One way to do an operation, and how long it takes.

use std::hint::black_box;
use std::time::Instant;

pub(crate) struct Contender {
    pub(crate) name: &'static str,
    /// Goes over all of its numbers once.
    pass: Box<dyn FnMut()>,
    operations: usize,
}

/// Long against the tick of the clock, short against the slice that another process takes.
const PASSES: u32 = 100;

impl Contender {
    /// `operation` on each of `inputs`, from memory to memory.
    pub(crate) fn new<I, O, F>(name: &'static str, inputs: Vec<I>, operation: F) -> Self
    where
        I: 'static,
        O: 'static,
        F: Fn(&I) -> O + Copy + 'static,
    {
        let operations = inputs.len();
        let mut outputs: Vec<O> = inputs.iter().map(operation).collect();
        let pass = Box::new(move || over(black_box(&inputs), black_box(&mut outputs), operation));
        Self { name, pass, operations }
    }

    /// Of one operation.
    pub(crate) fn nanoseconds(&mut self) -> f64 {
        (self.pass)();
        let begin = Instant::now();
        for _ in 0..PASSES {
            (self.pass)();
        }
        begin.elapsed().as_secs_f64() * 1e9 / f64::from(PASSES) / self.operations as f64
    }
}

/// The loop that a user would write, apart, so that it stands alone in the machine code.
#[inline(never)]
fn over<I, O>(inputs: &[I], outputs: &mut [O], operation: impl Fn(&I) -> O) {
    for (output, input) in outputs.iter_mut().zip(inputs) {
        *output = operation(black_box(input));
    }
}
