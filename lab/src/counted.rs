//! [`Counted`]: a number that counts what is done with it.

use core::cell::Cell;
use core::cmp::Ordering;
use dq8_fixtures::coat;
use dq8_fixtures::textbook::Operation;

/// How many operations of each kind something took.
///
/// Every operation that is written counts, also those with 0, 1, 2 or ½: an addition of a zero
/// that is known beforehand is left out by a compiler, not by the formula.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// xy
    pub multiplications: u32,
    /// x + y and x − y
    pub additions: u32,
    /// −x, which processors get for nothing more often than not.
    pub negations: u32,
    /// x/y
    pub divisions: u32,
    /// √x
    pub square_roots: u32,
    /// Sines, cosines, tangents and their inverses.
    pub trigonometric: u32,
    /// eˣ
    pub exponentials: u32,
    /// ln x
    pub logarithms: u32,
    /// Comparisons, absolute values and tests for infinity.
    pub comparisons: u32,
}

thread_local! {
    static COUNTS: Cell<Counts> = Cell::default();
}

impl Counts {
    /// What `work` does with [`Counted`] numbers, on this thread.
    ///
    /// ```
    /// use lab::{Counted, Counts};
    /// let [x, y] = [2.0, 3.0].map(Counted);
    /// let counts = Counts::of(|| x * y + x);
    /// assert_eq!((counts.multiplications, counts.additions), (1, 1));
    /// ```
    pub fn of<T>(work: impl FnOnce() -> T) -> Self {
        let before = COUNTS.take();
        work();
        COUNTS.replace(before)
    }
}

/// One more of a kind.
fn count(operation: Operation) {
    let mut counts = COUNTS.get();
    *match operation {
        Operation::Addition => &mut counts.additions,
        Operation::Multiplication => &mut counts.multiplications,
        Operation::Negation => &mut counts.negations,
        Operation::Division => &mut counts.divisions,
        Operation::SquareRoot => &mut counts.square_roots,
        Operation::Trigonometric => &mut counts.trigonometric,
        Operation::Exponential => &mut counts.exponentials,
        Operation::Logarithm => &mut counts.logarithms,
        Operation::Comparison => &mut counts.comparisons,
    } += 1;
    COUNTS.set(counts);
}

/// An `f64` that counts: what is written for every [`Real`](dq8::Real) is counted by computing it
/// with these.
#[derive(Clone, Copy, Debug, Default)]
pub struct Counted(pub f64);

coat!(Counted(f64), count);

impl PartialEq for Counted {
    fn eq(&self, other: &Self) -> bool {
        count(Operation::Comparison);
        self.0 == other.0
    }
}

impl PartialOrd for Counted {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        count(Operation::Comparison);
        self.0.partial_cmp(&other.0)
    }
}
