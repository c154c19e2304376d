//! One operation at a time on slices that stay in the first cache: throughput in motions or points,
//! dq8 and the peers that have the operation.
//!
//! ```text
//! cargo bench --bench operations -- sclerp
//! cargo bench --bench operations -- 'dq8 8 lanes'
//! ```

mod measurement;

use criterion::{Criterion, criterion_group, criterion_main};
use dq8_contest::caches::Level;
use dq8_contest::task::{Motions, Operation, Task};
use measurement::measure;

fn pairs(criterion: &mut Criterion) {
    for operation in Operation::ALL {
        let name = format!("{operation:?}").to_lowercase();
        measure(criterion, &name, Task::Pairs(operation, Level::L1));
    }
}

fn points(criterion: &mut Criterion) {
    for (name, by) in [("points_by_one", Motions::One), ("points_by_each", Motions::Each)] {
        measure(criterion, name, Task::Points(by, Level::L1));
    }
}

criterion_group! { name = operations; config = measurement::brief(); targets = pairs, points }
criterion_main!(operations);
