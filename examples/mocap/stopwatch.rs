//! How long a piece of work takes when nothing disturbs it.

use std::time::{Duration, Instant};

/// Seconds for one call of `work`, the least of several measurements: whatever else the machine
/// does only adds time. Ends at the first call that fails.
pub(crate) fn fastest<E>(mut work: impl FnMut() -> Result<(), E>) -> Result<f64, E> {
    // A measurement must be long against the tick of the clock.
    const SHORTEST: Duration = Duration::from_micros(200);
    const TOTAL: Duration = Duration::from_millis(200);
    const FEWEST: u32 = 5;

    let mut time = |calls: u32| {
        let start = Instant::now();
        (0..calls).try_for_each(|_| work())?;
        Ok(start.elapsed())
    };
    let mut calls = 1;
    while time(calls)? < SHORTEST {
        calls *= 2;
    }
    let mut best = Duration::MAX;
    let (mut total, mut measurements) = (Duration::ZERO, 0);
    while total < TOTAL || measurements < FEWEST {
        let elapsed = time(calls)?;
        best = best.min(elapsed);
        total += elapsed;
        measurements += 1;
    }
    Ok(best.as_secs_f64() / f64::from(calls))
}
