//! Contests, timed by criterion.

use criterion::{BenchmarkId, Criterion, Throughput};
use dq8_contest::caches::Caches;
use dq8_contest::contest::{Contender, Contest};
use dq8_contest::task::Task;
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

/// A group of all contenders, each checked against `f64` before it is timed.
pub(crate) fn measure(criterion: &mut Criterion, name: &str, task: Task) {
    task.with_contest(&Caches::of_this_machine(), |contest| {
        let mut group = criterion.benchmark_group(name);
        group.throughput(Throughput::Elements(contest.transforms as u64));
        for contender in &contest.contenders {
            let id = BenchmarkId::from_parameter(&contender.name);
            // Criterion calls the closure several times, and not at all if a filter excludes it.
            let mut run = None;
            group.bench_function(id, |bencher| {
                let run = run.get_or_insert_with(|| checked(contest, contender));
                bencher.iter_custom(|passes| run.time(u32::try_from(passes).unwrap_or(u32::MAX)));
            });
        }
    });
}

fn checked<'a>(
    contest: &Contest<'_>,
    contender: &Contender<'a>,
) -> Box<dyn dq8_contest::contest::Checked + 'a> {
    let mut run = (contender.start)();
    if let Err(wrong) = contest.check(contender, &mut *run) {
        panic!("{wrong}");
    }
    run
}
