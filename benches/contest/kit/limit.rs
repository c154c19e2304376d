//! What the machine can do at most: multiply and add, copy, and both at once.

use crate::contest::{InPlace, Run};
use dq8::{Backend, Kernel, Lanes, Level};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// What there is a most of.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Multiply-adds of single numbers, per nanosecond.
    MultiplyAdd(Backend),
    /// Bytes read and written per nanosecond by copying slices as large as those of this size.
    Copy(String),
    /// Bytes read and written per nanosecond by changing slices of this size where they are.
    Rewrite(String),
    /// Bytes of `a = b + s · c` per nanosecond.
    Triad(String),
}

pub struct Limit<'a> {
    pub kind: Kind,
    /// Multiply-adds or bytes in one pass.
    pub per_pass: f64,
    pub start: Box<dyn Fn() -> Box<dyn Run> + 'a>,
}

/// What one transform takes of a limit.
#[derive(Clone, Debug)]
pub enum Limited {
    /// By arithmetic: so many multiply-adds.
    MultiplyAdds(f64),
    /// By memory: so many bytes, against copying at this size.
    Bytes(f64, String),
    /// By memory: so many bytes, against rewriting in place at this size.
    BytesInPlace(f64, String),
}

impl Limited {
    pub fn amount(&self) -> f64 {
        match *self {
            Self::MultiplyAdds(amount) | Self::Bytes(amount, _) | Self::BytesInPlace(amount, _) => {
                amount
            }
        }
    }

    pub fn kind(&self, backend: Backend) -> Kind {
        match self {
            Self::MultiplyAdds(_) => Kind::MultiplyAdd(backend),
            Self::Bytes(_, size) => Kind::Copy(size.clone()),
            Self::BytesInPlace(_, size) => Kind::Rewrite(size.clone()),
        }
    }
}

/// Sums that do not wait for each other: two units of four cycles need eight, and twelve leave room
/// in the sixteen registers of AVX2.
const SUMS: usize = 12;
const STEPS: usize = 100;

impl Limit<'_> {
    pub fn multiply_add(backend: Backend) -> Self {
        let lanes = backend.run(RegisterLanes);
        Self {
            kind: Kind::MultiplyAdd(backend),
            per_pass: (SUMS * STEPS * lanes) as f64,
            start: Box::new(move || Box::new(MultiplyAdd(backend))),
        }
    }

    /// Of slices of `bytes` each.
    pub fn copy(size: impl Into<String>, bytes: usize) -> Self {
        Self {
            kind: Kind::Copy(size.into()),
            per_pass: 2.0 * bytes as f64,
            start: Box::new(move || {
                Box::new(Copy { from: rows(bytes, 1.0), to: rows(bytes, 0.0) })
            }),
        }
    }

    /// Of a slice of `bytes`, restored as often as the contenders' slices are: the first pass after
    /// that finds less of it in the caches.
    pub fn rewrite(size: impl Into<String>, bytes: usize) -> Self {
        Self {
            kind: Kind::Rewrite(size.into()),
            per_pass: 2.0 * bytes as f64,
            start: Box::new(move || {
                Box::new(InPlace {
                    input: rows(bytes, 1.0),
                    output: rows(bytes, 1.0),
                    pass: |lines: &mut [Line]| {
                        for number in lines.as_flattened_mut() {
                            *number = -*number;
                        }
                    },
                    numbers: (),
                })
            }),
        }
    }

    /// Of slices of `bytes` each.
    pub fn triad(size: impl Into<String>, bytes: usize) -> Self {
        Self {
            kind: Kind::Triad(size.into()),
            per_pass: 3.0 * bytes as f64,
            start: Box::new(move || {
                let [b, c, a] = [2.0, 3.0, 0.0].map(|value| rows(bytes, value));
                Box::new(Triad { b, c, a })
            }),
        }
    }
}

/// A cache line.
type Line = [f32; 16];

fn rows(bytes: usize, value: f32) -> Vec<Line> {
    // Not zeroed memory, which is no memory before it is written.
    let mut rows = Vec::with_capacity(bytes / size_of::<Line>());
    rows.resize(bytes / size_of::<Line>(), [value; 16]);
    rows
}

struct MultiplyAdd(Backend);

impl Run for MultiplyAdd {
    fn time(&mut self, passes: u32) -> Duration {
        let steps = passes as usize * STEPS;
        let start = Instant::now();
        self.0.run(MultiplyAdds { steps });
        start.elapsed()
    }
}

/// How many `f32` fill a register.
struct RegisterLanes;

impl Kernel for RegisterLanes {
    type Output = usize;
    #[inline(always)]
    fn run<V: Level>(self, _: V) -> usize {
        V::Single::LANES
    }
}

struct MultiplyAdds {
    steps: usize,
}

impl Kernel for MultiplyAdds {
    type Output = ();
    #[inline(always)]
    fn run<V: Level>(self, level: V) {
        multiply_add::<V::Single>(level, self.steps);
    }
}

#[inline(always)]
fn multiply_add<L: Lanes<Real = f32>>(level: L::Level, steps: usize) {
    // Different starts: equal sums would be computed once.
    let mut starts = [0.0_f32; SUMS];
    for (index, start) in starts.iter_mut().enumerate() {
        *start = index as f32;
    }
    let starts = black_box(starts);
    let mut sums = [L::splat(level, 0.0); SUMS];
    for (sum, start) in sums.iter_mut().zip(starts) {
        *sum = L::splat(level, start);
    }
    let [factor, addend] = black_box([0.5, 0.5]);
    let (factor, addend) = (L::splat(level, factor), L::splat(level, addend));
    for _ in 0..steps {
        for sum in &mut sums {
            *sum = sum.mul_add(factor, addend);
        }
    }
    let mut total = L::splat(level, 0.0);
    for sum in sums {
        total = total + sum;
    }
    black_box(total.to_array());
}

struct Copy {
    from: Vec<Line>,
    to: Vec<Line>,
}

impl Run for Copy {
    fn time(&mut self, passes: u32) -> Duration {
        let start = Instant::now();
        for _ in 0..passes {
            black_box(&mut self.to).copy_from_slice(black_box(&self.from));
        }
        start.elapsed()
    }
}

struct Triad {
    b: Vec<Line>,
    c: Vec<Line>,
    a: Vec<Line>,
}

impl Run for Triad {
    fn time(&mut self, passes: u32) -> Duration {
        let factor = black_box(0.5);
        let start = Instant::now();
        for _ in 0..passes {
            let (b, c) = (black_box(&self.b), black_box(&self.c));
            for ((a, b), c) in black_box(&mut self.a).iter_mut().zip(b).zip(c) {
                for ((a, b), c) in a.iter_mut().zip(b).zip(c) {
                    *a = b + factor * c;
                }
            }
        }
        start.elapsed()
    }
}
