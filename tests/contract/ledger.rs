//! [`Ledger`]: the worst error of each line of a section of the table.

use crate::tolerance::{Bound, Section, section};
use std::cell::RefCell;
use std::fmt::Write;

/// What was measured for each line of a section.
#[derive(Debug)]
pub struct Ledger {
    section: &'static Section,
    worst: RefCell<Vec<Option<Worst>>>,
}

#[derive(Debug)]
struct Worst {
    units: f64,
    place: String,
}

impl Ledger {
    /// Runs `measure`, and prints the worst errors beside those allowed.
    ///
    /// # Panics
    /// If the table has no such section, an error is more than its line allows, or a line was not
    /// measured, or is so loose that it says nothing.
    pub fn keep(name: &str, measure: impl FnOnce(&Self)) {
        let section = section(name);
        let worst = section.lines.iter().map(|_| None).collect();
        let ledger = Self { section, worst: RefCell::new(worst) };
        measure(&ledger);
        ledger.close();
    }

    /// An error of `units` (in u · scale) at `place`; NaN is infinite.
    ///
    /// # Panics
    /// If the section has no line for the operation and kind.
    pub fn measure(&self, op: &str, kind: &str, units: f64, place: impl FnOnce() -> String) {
        let line = self.section.line(op, kind);
        let units = if units.is_nan() { f64::INFINITY } else { units };
        let index = self.section.lines.iter().position(|other| std::ptr::eq(other, line));
        let slot = &mut self.worst.borrow_mut()[index.expect("the line is of this section")];
        if slot.as_ref().is_none_or(|worst| units > worst.units) {
            *slot = Some(Worst { units, place: place() });
        }
    }

    fn close(self) {
        let mut broken = String::new();
        for (line, worst) in self.section.lines.iter().zip(self.worst.into_inner()) {
            let Bound { op, kinds, units, reason } = line;
            let Some(worst) = worst else {
                writeln!(broken, "{op} {kinds:?} was not measured").expect("a string grows");
                continue;
            };
            println!(
                "{:24} {op:24} {kinds:?} {:6.2} of {units:.2}",
                self.section.name, worst.units
            );
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
        assert!(broken.is_empty(), "{}:\n{broken}", self.section.name);
    }
}

/// Lines are one and a half times what was measured where they were written; elsewhere there may be
/// fewer implementations and another library of functions.
const LOOSE: f64 = 3.0;

/// Whoever asks for fewer inputs meets fewer bad ones.
fn sampled_as_usual() -> bool {
    ["PROPTEST_CASES", "PROPTEST_RNG_SEED", "DQ8_SWEEP_STRIDE"]
        .iter()
        .all(|name| std::env::var_os(name).is_none())
}
