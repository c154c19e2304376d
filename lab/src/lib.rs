//! A laboratory for dq8, for learning and measuring: it tests what the sources claim. Nothing
//! depends on it.
//!
//! Every experiment is a module with a function `section` that runs it and writes it up for the
//! report; `cargo run --release --manifest-path lab/Cargo.toml -- --out DIR` puts all of them on
//! one page.

pub mod arends;
mod arm;
mod counted;
pub mod differentiation;
pub mod drift;
pub mod fabisch;
pub mod figures;
pub mod forward_kinematics;
pub mod hessian;
mod hyper_dual;
mod hyper_dual_quat;
pub mod interpolation;
pub mod kenwright;
pub mod keyframe;
pub mod keyframing;
mod logarithm;
pub mod matrix;
pub mod operations;
pub mod products;
pub mod report;
pub mod speed;

pub use arm::{Arm, Joint};
pub use counted::{Counted, Counts};
pub use hyper_dual::{HyperDual, hyper_dual, hyper_dual_parts};
pub use hyper_dual_quat::HyperDualQuat;
pub use logarithm::{LogarithmError, logarithm};
