//! What every function and job computes, as hashes that are the same on every machine:
//! `tests/vectors/bits.tsv`. Without std and, but for the feature `trajectory`, without a heap, so
//! that boards run it too. The inputs are made of integers, so that no generator can hide a
//! difference; NaN is one value, because its sign and payload differ between machines.
//!
//! `operations` and `geometry` read the tables of the accuracy contract: what is new there is
//! hashed here.
#![no_std]
#![forbid(unsafe_code)]

mod deal;
#[macro_use]
mod kinds;
mod geometry;
mod operations;
mod random;
mod sample;

/// The jobs, written once for both numbers.
#[path = "."]
mod single {
    pub(crate) type R = f32;
    #[path = "jobs.rs"]
    pub(crate) mod jobs;
    #[path = "robots.rs"]
    mod robots;
    #[cfg(feature = "trajectory")]
    #[path = "trajectories.rs"]
    pub(crate) mod trajectories;
    #[path = "zeros.rs"]
    mod zeros;
}
#[path = "."]
#[allow(clippy::duplicate_mod, reason = "the other number")]
mod double {
    pub(crate) type R = f64;
    #[path = "jobs.rs"]
    pub(crate) mod jobs;
    #[path = "robots.rs"]
    mod robots;
    #[cfg(feature = "trajectory")]
    #[path = "trajectories.rs"]
    pub(crate) mod trajectories;
    #[path = "zeros.rs"]
    mod zeros;
}

use dq8::simd::{Portable, Unfused};
use dq8::{Backend, DualQuat, Level, Scalar, batch};

#[path = "../../examples/lockstep/world.rs"]
mod world;

/// What is told: the number, the entry (`scalar`, `lanes`, `job`), a name, and the hash.
pub type Sink<'s> = dyn FnMut([&str; 3], u64) + 's;

/// The hashes that all machines have.
pub const KNOWN: &str = include_str!("../vectors/bits.tsv");

/// Everything, by all instructions of this CPU whose bits are promised: a name comes once for each
/// of them.
pub fn hashes(sink: &mut Sink<'_>) {
    parts(sink);
    example(sink);
}

/// Every function and every job.
pub fn parts(sink: &mut Sink<'_>) {
    scalar::<f32>("f32", sink);
    scalar::<f64>("f64", sink);
    lanes(Unfused(Portable), sink);
    #[cfg(target_arch = "x86_64")]
    {
        use dq8::simd::x86_64::{Avx2, Avx512};
        if let Some(level) = Avx2::detect() {
            lanes(Unfused(level), sink);
        }
        if let Some(level) = Avx512::detect() {
            lanes(Unfused(level), sink);
        }
    }
    for backend in backends() {
        single::jobs::run(backend, &mut |name, hash| sink(["f32", "job", name], hash));
        double::jobs::run(backend, &mut |name, hash| sink(["f64", "job", name], hash));
        #[cfg(feature = "trajectory")]
        {
            let of_single = &mut |name: &str, hash| sink(["f32", "trajectory", name], hash);
            single::trajectories::run(backend, of_single);
            let of_double = &mut |name: &str, hash| sink(["f64", "trajectory", name], hash);
            double::trajectories::run(backend, of_double);
        }
    }
}

/// The ten thousand steps of the example, which take four times as long as everything else.
pub fn example(sink: &mut Sink<'_>) {
    for backend in backends() {
        if let Ok(hash) = world::World::new(backend).run(10_000) {
            sink(["f32", "example", "lockstep"], hash);
        }
    }
}

/// All instructions of this CPU, without fused ones: the last are those of `Backend::reproducible`.
fn backends() -> impl Iterator<Item = Backend> {
    Backend::available().map(Backend::unfused)
}

/// How many hashes are those of [`KNOWN`]; the others are told, with what is known of them.
pub fn compare(other: &mut dyn FnMut([&str; 3], u64)) -> usize {
    let mut same = 0;
    hashes(&mut |name, hash| {
        if known(name) == Some(hash) {
            same += 1;
        } else {
            other(name, hash);
        }
    });
    same
}

/// [`compare`] for boards: prints what has another hash. True if there is none.
pub fn report(print: &mut dyn FnMut(&str)) -> bool {
    let mut others = 0;
    let same = compare(&mut |name, _| {
        others += 1;
        name.iter().for_each(|part| [*part, " "].into_iter().for_each(&mut *print));
        print("has other bits\n");
    });
    // Each once for some instructions or other.
    let here = |line: &&str| cfg!(feature = "trajectory") || !line.contains("\ttrajectory\t");
    let passed = others == 0 && same >= KNOWN.lines().filter(here).count();
    print(if passed { "bits: PASS\n" } else { "bits: FAIL\n" });
    passed
}

/// What [`KNOWN`] says.
fn known(name: [&str; 3]) -> Option<u64> {
    let line = KNOWN.lines().find_map(|line| {
        let mut words = line.split('\t');
        name.iter().all(|name| words.next() == Some(name)).then_some(words)
    });
    u64::from_str_radix(line?.next()?, 16).ok()
}

fn scalar<R: Scalar>(real: &str, sink: &mut Sink<'_>) {
    let sink = &mut |name: &str, hash| sink([real, "scalar", name], hash);
    operations::run::<DualQuat<R>>((), sink);
    geometry::scalar::<R>(sink);
}

fn lanes<V: Level>(level: V, sink: &mut Sink<'_>) {
    let single = &mut |name: &str, hash| sink(["f32", "lanes", name], hash);
    operations::run::<batch::DualQuat<V::Single>>(level, single);
    geometry::lanes::<V::Single>(level, single);
    let double = &mut |name: &str, hash| sink(["f64", "lanes", name], hash);
    operations::run::<batch::DualQuat<V::Double>>(level, double);
    geometry::lanes::<V::Double>(level, double);
}
