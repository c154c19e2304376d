//! [`Worst`]: the largest error of what a test measures.

use std::cell::Cell;

/// The largest error so far, in units of u · scale.
pub(crate) struct Worst {
    name: &'static str,
    units: Cell<f64>,
}

impl Worst {
    pub(crate) fn of(name: &'static str) -> Self {
        Self { name, units: Cell::new(0.0) }
    }

    /// An error, and what it is relative to; NaN is infinite.
    pub(crate) fn see(&self, error: f64, scale: f64) {
        let units = error.abs() / scale;
        let units = if units.is_nan() { f64::INFINITY } else { units };
        self.units.set(self.units.get().max(units));
    }

    /// Asserts that the worst is within what is allowed, and what is allowed no more than four times
    /// that: a looser bound would say nothing.
    #[track_caller]
    pub(crate) fn within(&self, allowed: f64) {
        let (name, worst) = (self.name, self.units.get());
        println!("{name}: {worst:.2} of {allowed} u");
        assert!(worst <= allowed, "{name}: {worst:.2} u, where {allowed} u are allowed");
        let chosen = ["PROPTEST_CASES", "PROPTEST_RNG_SEED"];
        let usual = chosen.iter().all(|name| std::env::var_os(name).is_none());
        assert!(
            !usual || allowed <= 4.0 * worst + 1.0,
            "{name}: {worst:.2} u is far below {allowed} u"
        );
    }
}
