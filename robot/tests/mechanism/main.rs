//! Mechanisms: one configuration against matrices, lanes against one configuration, Jacobians against
//! differentiation, and what cannot be one.

mod arms;
mod book;
mod dh;
mod empty;
mod errors;
mod far;
mod hinge;
mod lanes;
#[cfg(feature = "rayon")]
mod parallel;
mod points;
mod reach;
mod single;
mod solutions;
mod tree;
mod twists;
