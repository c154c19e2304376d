//! [`Race`]: contenders on the same crowd, timed one after the other.

use crate::contender::Contender;
use crate::crowd::{Crowd, Place};
use crate::skeleton::JOINTS;
use criterion::measurement::WallTime;
use criterion::{Bencher, BenchmarkGroup, Criterion, Throughput};
use dq8::Backend;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Passes in place before the input is restored.
///
/// Repeated without end, model = parent · model makes translations and errors of the norm grow like
/// binomial coefficients, until they overflow. Eight passes over twelve levels keep every number
/// ordinary: the norm within a percent, translations below a million bones. They also take long
/// enough that starting and stopping the clock, which stands while the input is restored, does not
/// show.
const PASSES: u64 = 8;

pub(crate) struct Race<'a> {
    group: BenchmarkGroup<'a, WallTime>,
    crowd: Crowd,
    place: Place,
}

impl<'a> Race<'a> {
    pub(crate) fn new(criterion: &'a mut Criterion, instances: usize, place: Place) -> Self {
        let name = match place {
            Place::Out => "out-of-place",
            Place::In => "in-place",
        };
        let mut group = criterion.benchmark_group(format!("crowd/{instances}/{name}"));
        group.throughput(Throughput::Elements((instances * JOINTS) as u64));
        Self { group, crowd: Crowd::new(instances), place }
    }

    /// [`run`](Self::run) with each set of instructions; its name is appended.
    pub(crate) fn run_on_every_backend<C: Contender>(&mut self, name: &str) {
        for backend in Backend::available() {
            Backend::limit(Some(backend));
            self.run::<C>(&format!("{name}-{backend}"));
        }
        Backend::limit(None);
    }

    /// Checks the contender against `f64`, then times it.
    pub(crate) fn run<C: Contender>(&mut self, name: &str) {
        let Self { group, crowd, place } = self;
        let hierarchy = crowd.hierarchy();
        // Criterion calls the closure several times, and not at all if a filter excludes it.
        let mut memory = None;
        group.bench_function(name, |bencher| {
            let (locals, models) = memory.get_or_insert_with(|| {
                let locals = crowd.checked_locals::<C>(name, *place);
                (locals.clone(), locals)
            });
            match place {
                Place::Out => bencher.iter(|| {
                    C::local_to_model(&hierarchy, black_box(locals), black_box(models));
                }),
                Place::In => in_place(bencher, locals, models, |poses| {
                    C::local_to_model_in_place(&hierarchy, poses);
                }),
            }
        });
    }
}

fn in_place<E: Copy>(
    bencher: &mut Bencher,
    locals: &[E],
    poses: &mut [E],
    mut pass: impl FnMut(&mut [E]),
) {
    bencher.iter_custom(|passes| {
        let (mut elapsed, mut left) = (Duration::ZERO, passes);
        while left > 0 {
            poses.copy_from_slice(locals);
            let now = left.min(PASSES);
            let start = Instant::now();
            for _ in 0..now {
                pass(black_box(poses));
            }
            elapsed += start.elapsed();
            left -= now;
        }
        elapsed
    });
}
