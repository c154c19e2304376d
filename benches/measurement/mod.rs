//! How long is measured.

use criterion::Criterion;
use std::time::Duration;

/// Short runs, so that all benches together take minutes: their point is ratios of contenders in
/// the same run, and those are larger than what longer runs would still find.
pub(crate) fn brief() -> Criterion {
    Criterion::default()
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(1))
        .sample_size(20)
        .nresamples(10_000)
}
