//! [`Machine`]: how disturbed it is while contenders are timed.

use std::hint::black_box;
use std::time::Instant;

/// A mark that takes so many times as long as the shortest ever says that what was timed beside it
/// counts for nothing.
const DISTURBED: f64 = 1.05;

/// Times a piece of work that is always the same, between the contenders: what that varies by is
/// the clock of the CPU and whoever else is on it, and no contender's doing.
#[derive(Debug)]
pub(crate) struct Machine {
    /// Seconds of the piece of work.
    work: fn() -> f64,
    shortest: f64,
    marks: Vec<f64>,
    repeated: usize,
}

impl Machine {
    pub(crate) fn new() -> Self {
        Self { work: chain, shortest: f64::INFINITY, marks: Vec::new(), repeated: 0 }
    }

    /// What comes is another contest.
    pub(crate) fn next(&mut self) {
        self.marks.clear();
        self.repeated = 0;
    }

    /// Does `work` between two marks, again as long as one of them is disturbed, `attempts` times
    /// at most; what the last attempt returns.
    pub(crate) fn calmly<T>(&mut self, attempts: usize, mut work: impl FnMut() -> T) -> T {
        for _ in 1..attempts {
            let (before, result, after) = (self.mark(), work(), self.mark());
            if before.max(after) <= DISTURBED * self.shortest {
                return result;
            }
            self.repeated += 1;
        }
        self.mark();
        work()
    }

    fn mark(&mut self) -> f64 {
        let mark = (self.work)();
        self.shortest = self.shortest.min(mark);
        self.marks.push(mark);
        mark
    }

    /// By how much of the shortest mark ever the middle one of this contest was longer: a lead
    /// smaller than this is none.
    pub(crate) fn spread(&self) -> f64 {
        let mut marks = self.marks.clone();
        marks.sort_by(f64::total_cmp);
        marks.get(marks.len() / 2).map_or(0.0, |middle| middle / self.shortest - 1.0)
    }

    /// How many measurements of this contest were made again.
    pub(crate) fn repeated(&self) -> usize {
        self.repeated
    }
}

/// Each product waits for the one before it, so no other core, cache or width of lanes matters.
/// Some 50 μs: long against the tick of the clock, short against a millisecond of a contender.
fn chain() -> f64 {
    let begin = Instant::now();
    black_box(
        (0..40_000_u32).fold(black_box(1_u64), |product, _| product.wrapping_mul(black_box(3))),
    );
    begin.elapsed().as_secs_f64()
}

#[cfg(test)]
mod tests {
    use super::Machine;

    /// What a contender is timed for, beside marks of one second each.
    fn times(shortest: f64) -> (usize, Machine) {
        let (mut machine, mut times) = (Machine { work: || 1.0, ..Machine::new() }, 0);
        machine.shortest = shortest;
        machine.calmly(4, || times += 1);
        (times, machine)
    }

    #[test]
    fn who_is_calm_is_timed_once() {
        for shortest in [f64::INFINITY, 1.0, 0.96] {
            let (times, machine) = times(shortest);
            assert_eq!((times, machine.repeated()), (1, 0));
        }
    }

    #[test]
    fn who_is_disturbed_is_timed_again_and_the_spread_says_by_how_much() {
        let (times, mut machine) = times(0.8);
        assert_eq!((times, machine.repeated()), (4, 3));
        assert!((machine.spread() - 0.25).abs() < 1e-12, "{}", machine.spread());
        machine.next();
        assert_eq!((machine.repeated(), machine.spread()), (0, 0.0));
    }
}
