//! One operation at a time on arrays that stay in L1: nanoseconds an operation, this crate beside
//! peers that have it.
//!
//! Everything is compared with scalar `f64` before it is timed. Throughput counts operations, not
//! vectors.
//!
//! ```text
//! cargo bench --bench operations -- sclerp
//! cargo bench --bench operations -- lanes-f32x8
//! ```

#[macro_use]
mod group;

mod algebra;
mod blend;
mod case;
#[path = "../measurement/mod.rs"]
mod measurement;
mod outcome;
mod peer;
#[path = "../representation/mod.rs"]
mod representation;
mod rigid;
mod screw;
mod transform;

use criterion::{criterion_group, criterion_main};

criterion_group! {
    name = operations;
    config = measurement::brief();
    targets =
        algebra::product,
        algebra::normalize,
        algebra::inverse,
        algebra::conjugate,
        algebra::conjugate_dual,
        algebra::conjugate_both,
        rigid::from_rotation_translation,
        rigid::translation,
        rigid::to_matrix3x4,
        transform::points_by_one,
        transform::points_by_each,
        transform::directions_by_each,
        transform::lines_by_each,
        blend::nlerp,
        screw::log,
        screw::exp,
        screw::pow,
        screw::sclerp,
}
criterion_main!(operations);
