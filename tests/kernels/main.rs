//! Kernels over memory: slices, hierarchies, chains and crowds, in every layout, on every backend.
//!
//! The tests compute with `f64` records and do not know layouts: a [`Subject`](subject::Subject) is
//! one layout behind a plain interface. So every kernel is compiled once for each layout, here.

mod backends;
mod beyond_caches;
mod chain;
mod clips;
mod crowd;
mod elements;
mod errors;
mod hierarchy;
mod inputs;
mod instances;
mod isolation;
mod kernel;
mod laws;
mod locals;
mod matrices;
mod memory;
mod packing;
mod palettes;
#[cfg(feature = "rayon")]
mod parallel;
mod plan;
mod records;
mod sampling;
mod scene;
mod slices;
mod subject;
mod two_bone;
