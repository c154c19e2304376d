//! The accuracy contract: the [table](operations) of operations with the errors allowed, every
//! [implementation] of [`dq8::Motion`], and reference vectors. Shared by the tests and by the
//! example `conform`.

#![allow(missing_docs, reason = "made for the tests of dq8, which read it")]

pub mod bound;
pub mod case;
pub mod conformance;
mod entry;
pub mod geometry;
pub mod implementation;
pub mod inputs;
mod kinds;
pub mod lanes;
pub mod law;
pub mod ledger;
pub mod matrix;
pub mod operation;
pub mod operations;
pub mod optimized;
pub mod records;
pub mod sample;
pub mod scale;
pub mod vectors;
pub mod worst;

#[cfg(not(target_family = "wasm"))]
pub use dq8_fixtures::stack;
pub use dq8_fixtures::{fusing, fuzz, kinematics, legible, random, textbook, vector};
