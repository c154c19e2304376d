//! [`Ledger`]: the worst error of each line of a list of bounds.

use crate::bound::{Bound, on};
use std::cell::RefCell;
use std::fmt::Write;

/// A bound for an operation.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    pub op: &'static str,
    pub bound: Bound,
}

/// The bound of an operation for the kinds of input named; for all that no line above names, where
/// there are none.
pub const fn line(
    op: &'static str,
    kinds: &'static [&'static str],
    units: f64,
    reason: &'static str,
) -> Line {
    Line { op, bound: on(kinds, units, reason) }
}

/// What was measured for each line of a list.
#[derive(Debug)]
pub struct Ledger {
    name: &'static str,
    lines: Vec<Line>,
    worst: RefCell<Vec<Option<Worst>>>,
}

#[derive(Clone, Debug)]
struct Worst {
    units: f64,
    place: String,
}

impl Ledger {
    /// Runs `measure`, and prints the worst errors beside those allowed.
    ///
    /// # Panics
    /// If an error is more than its line allows, or a line was not measured, or is so loose that it
    /// says nothing.
    pub fn keep(name: &'static str, lines: &[Line], measure: impl FnOnce(&Self)) {
        let worst = RefCell::new(vec![None; lines.len()]);
        let ledger = Self { name, lines: lines.to_vec(), worst };
        measure(&ledger);
        ledger.close();
    }

    /// An error of `units` (in u · scale) at `place`; NaN is infinite.
    ///
    /// # Panics
    /// If there is no line for the operation and kind.
    pub fn measure(&self, op: &str, kind: &str, units: f64, place: impl FnOnce() -> String) {
        let of_op = || self.lines.iter().enumerate().filter(|(_, line)| line.op == op);
        let named = of_op().find(|(_, line)| line.bound.kinds.contains(&kind));
        let found = named.or_else(|| of_op().find(|(_, line)| line.bound.kinds.is_empty()));
        let Some((index, _)) = found else {
            panic!("{} have no line for {op} ({kind:?})", self.name);
        };
        let units = if units.is_nan() { f64::INFINITY } else { units };
        let slot = &mut self.worst.borrow_mut()[index];
        if slot.as_ref().is_none_or(|worst| units > worst.units) {
            *slot = Some(Worst { units, place: place() });
        }
    }

    fn close(self) {
        let mut broken = String::new();
        for (line, worst) in self.lines.iter().zip(self.worst.into_inner()) {
            let Line { op, bound: Bound { kinds, units, reason } } = line;
            let Some(worst) = worst else {
                writeln!(broken, "{op} {kinds:?} was not measured").expect("a string grows");
                continue;
            };
            println!("{:24} {op:24} {kinds:?} {:6.2} of {units:.2}", self.name, worst.units);
            let verdict = if worst.units > *units {
                "more than is allowed"
            } else if sampled_as_usual() && *units > LOOSE * worst.units + 1.0 {
                "so much less than is allowed that the line says nothing"
            } else {
                continue;
            };
            writeln!(
                broken,
                "{op} {kinds:?}: {:.2} u is {verdict}, {units} ({reason}): {}",
                worst.units, worst.place
            )
            .expect("a string grows");
        }
        assert!(broken.is_empty(), "{}:\n{broken}", self.name);
    }
}

/// Lines are one and a half times what was measured where they were written; elsewhere there may be
/// fewer implementations and another library of functions.
pub(crate) const LOOSE: f64 = 3.0;

/// Whether a bound must be near what is measured. Whoever asks for fewer inputs meets fewer bad
/// ones, and other hosts round otherwise than those on which bounds were measured.
pub(crate) fn sampled_as_usual() -> bool {
    let as_usual = ["PROPTEST_CASES", "PROPTEST_RNG_SEED", "DQ8_SWEEP_STRIDE"]
        .iter()
        .all(|name| std::env::var_os(name).is_none());
    as_usual && cfg!(target_arch = "x86_64")
}
