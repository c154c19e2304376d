//! [`Contest`]: one job at one size, and everyone who does it.

use crate::limit::{Limit, Limited};
use dq8::Backend;
use std::fmt;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Work that can be timed, with its memory.
pub trait Run {
    /// How long so many passes over the data take.
    fn time(&mut self, passes: u32) -> Duration;
}

/// More than this many results of one contender are not looked at: the data repeat anyway.
const MAX_CHECKED: usize = 8192;

/// A contender that does not do what it should.
#[derive(Debug)]
pub struct Wrong(String);

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Wrong {}

/// Work whose result can be checked.
pub trait Checked: Run {
    /// The result of transform `index`, after one pass.
    fn numbers(&self, index: usize) -> Vec<f64>;
}

pub struct Contender<'a> {
    pub name: String,
    /// What a contender of this crate computes with, if it can choose.
    pub backend: Option<Backend>,
    /// Makes its data. Done anew for every round: so no contender keeps a lucky or unlucky address,
    /// and those that need gigabytes need not share them.
    pub start: Box<dyn Fn() -> Box<dyn Checked + 'a> + 'a>,
    /// What comes out, if it does something else than the contest asks for.
    pub expected: Option<Vec<Vec<f64>>>,
}

pub struct Contest<'a> {
    pub job: &'static str,
    pub size: String,
    /// What a transform is here.
    pub title: String,
    /// In one pass.
    pub transforms: usize,
    /// By `f64`; fewer than there are transforms if the data repeat.
    pub expected: Vec<Vec<f64>>,
    /// Relative to the largest number of an expected transform, or to 1.
    pub tolerance: f64,
    pub contenders: Vec<Contender<'a>>,
    /// What the machine can do at most, measured in the same rounds.
    pub limits: Vec<Limit<'a>>,
    /// Which of the limits a transform of this crate's approaches.
    pub limited: Option<Limited>,
}

impl<'a> Contest<'a> {
    /// Nothing yet but its names.
    pub fn new(job: &'static str, size: impl Into<String>, title: impl Into<String>) -> Self {
        Self {
            job,
            size: size.into(),
            title: title.into(),
            transforms: 0,
            expected: Vec::new(),
            tolerance: 0.0,
            contenders: Vec::new(),
            limits: Vec::new(),
            limited: None,
        }
    }

    /// One pass of `run`, which is the contender's, and what comes out against `f64`.
    ///
    /// # Errors
    /// If it is not what was expected; the message says who, where and what.
    pub fn check(&self, contender: &Contender<'_>, run: &mut dyn Checked) -> Result<(), Wrong> {
        run.time(1);
        let count = self.transforms;
        let all = contender.expected.as_ref().unwrap_or(&self.expected);
        // From both ends, in steps that share no factor with blocks or skeletons.
        let stride = (count / MAX_CHECKED).next_multiple_of(2) + 1;
        let stride = if count <= MAX_CHECKED { 1 } else { stride };
        for index in (0..count).step_by(stride).chain([count - 1]) {
            let expected = &all[index % all.len()];
            let numbers = run.numbers(index);
            let size = expected.iter().fold(1.0_f64, |size, number| size.max(number.abs()));
            let pairs = numbers.iter().zip(expected);
            let close = |(a, b): (&f64, &f64)| (a - b).abs() <= self.tolerance * size;
            if numbers.len() != expected.len() || !pairs.into_iter().all(close) {
                let (job, size, name) = (self.job, &self.size, &contender.name);
                return Err(Wrong(format!(
                    "{job} {size}: {name} is wrong at transform {index}: {numbers:?}, not {expected:?}"
                )));
            }
        }
        Ok(())
    }

    /// The contender added last does something else.
    pub fn last_should(&mut self, expected: Vec<Vec<f64>>) {
        let last = self.contenders.last_mut().expect("a contender");
        last.expected = Some(expected);
    }

    /// A contender that reads `I` and writes a slice of `O`.
    pub fn add<I: 'a, O: 'a>(
        &mut self,
        name: impl Into<String>,
        backend: Option<Backend>,
        memory: impl Fn() -> (I, Vec<O>) + 'a,
        pass: impl Fn(&I, &mut [O]) + Copy + 'a,
        numbers: impl Fn(&[O], usize) -> Vec<f64> + Copy + 'a,
    ) {
        let start = move || {
            let (input, output) = memory();
            Box::new(Outward { input, output, pass, numbers }) as Box<dyn Checked + 'a>
        };
        self.push(name.into(), backend, start);
    }

    /// A contender that writes over its input.
    pub fn add_in_place<E: Copy + 'a>(
        &mut self,
        name: impl Into<String>,
        backend: Option<Backend>,
        memory: impl Fn() -> Vec<E> + 'a,
        pass: impl Fn(&mut [E]) + Copy + 'a,
        numbers: impl Fn(&[E], usize) -> Vec<f64> + Copy + 'a,
    ) {
        let start = move || {
            let input = memory();
            let output = input.clone();
            Box::new(InPlace { input, output, pass, numbers }) as Box<dyn Checked + 'a>
        };
        self.push(name.into(), backend, start);
    }

    fn push(
        &mut self,
        name: String,
        backend: Option<Backend>,
        start: impl Fn() -> Box<dyn Checked + 'a> + 'a,
    ) {
        let start = Box::new(start);
        self.contenders.push(Contender { name, backend, start, expected: None });
    }
}

struct Outward<I, O, P, N> {
    input: I,
    output: Vec<O>,
    pass: P,
    numbers: N,
}

impl<I, O, P: Fn(&I, &mut [O]), N> Run for Outward<I, O, P, N> {
    fn time(&mut self, passes: u32) -> Duration {
        let start = Instant::now();
        for _ in 0..passes {
            (self.pass)(black_box(&self.input), black_box(&mut self.output));
        }
        start.elapsed()
    }
}

impl<I, O, P, N> Checked for Outward<I, O, P, N>
where
    P: Fn(&I, &mut [O]),
    N: Fn(&[O], usize) -> Vec<f64>,
{
    fn numbers(&self, index: usize) -> Vec<f64> {
        (self.numbers)(&self.output, index)
    }
}

pub struct InPlace<E, P, N> {
    pub input: Vec<E>,
    pub output: Vec<E>,
    pub pass: P,
    pub numbers: N,
}

/// Passes in place before the input is restored.
///
/// Repeated without end, model = parent · model makes translations and errors of the norm grow
/// like binomial coefficients, until they overflow. Eight passes over the levels of a skeleton keep
/// every number ordinary, and take long enough that starting and stopping the clock does not show.
const PASSES: u32 = 8;

impl<E: Copy, P: Fn(&mut [E]), N> Run for InPlace<E, P, N> {
    fn time(&mut self, passes: u32) -> Duration {
        let (mut elapsed, mut left) = (Duration::ZERO, passes);
        while left > 0 {
            self.output.copy_from_slice(&self.input);
            let now = left.min(PASSES);
            let start = Instant::now();
            for _ in 0..now {
                (self.pass)(black_box(&mut self.output));
            }
            elapsed += start.elapsed();
            left -= now;
        }
        elapsed
    }
}

impl<E: Copy, P: Fn(&mut [E]), N: Fn(&[E], usize) -> Vec<f64>> Checked for InPlace<E, P, N> {
    fn numbers(&self, index: usize) -> Vec<f64> {
        (self.numbers)(&self.output, index)
    }
}
