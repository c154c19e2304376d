//! Mechanisms: one configuration against matrices, lanes against one configuration, Jacobians
//! against differentiation, and what cannot be one.

mod arms;
mod dh;
mod empty;
mod errors;
mod far;
mod hinge;
mod jobs;
mod manipulable;
mod rates;
mod reach;
mod single;
mod solutions;
mod tree;
