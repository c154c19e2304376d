//! [`Worst`]: the largest of many errors, beside the one that is allowed.

use crate::bound::Bound;
use crate::ledger::{LOOSE, sampled_as_usual};
use std::cell::Cell;
use std::fmt::Debug;

/// The largest error so far, in units of what errors are relative to. Dropped, it has been neared:
/// a bound that is far from every error says nothing.
#[derive(Debug)]
pub struct Worst {
    name: &'static str,
    bound: Bound,
    units: Cell<f64>,
}

impl Worst {
    pub fn of(name: &'static str, bound: Bound) -> Self {
        Self { name, bound, units: Cell::new(0.0) }
    }

    /// An error, what it is relative to, and of what it is; NaN is infinite.
    ///
    /// # Panics
    /// If it is more than is allowed.
    #[track_caller]
    pub fn see(&self, error: f64, scale: f64, case: &dyn Debug) {
        let units = error.abs() / scale;
        let units = if units.is_nan() { f64::INFINITY } else { units };
        let Bound { units: allowed, reason, .. } = self.bound;
        assert!(
            units <= allowed,
            "{}: {units:.2} units where {allowed} are allowed ({reason}), for {case:?}",
            self.name
        );
        self.units.set(self.units.get().max(units));
    }
}

impl Drop for Worst {
    fn drop(&mut self) {
        let (worst, Bound { units: allowed, reason, .. }) = (self.units.get(), self.bound);
        println!("{}: {worst:.2} of {allowed} ({reason})", self.name);
        if !std::thread::panicking() && sampled_as_usual() {
            assert!(
                allowed <= LOOSE * worst + 1.0,
                "{}: {worst:.2} units are so much less than {allowed} that the bound says nothing",
                self.name
            );
        }
    }
}
