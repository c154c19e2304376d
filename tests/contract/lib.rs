//! The accuracy contract: reference vectors, every implementation of [`dq8::Motion`], and the table
//! of errors allowed. Shared by the tests and by the example `conform`.

#![allow(missing_docs, reason = "support for tests, not published")]

pub mod agreement;
pub mod cluster;
pub mod conformance;
pub mod inputs;
pub mod kinematics;
pub mod law;
pub mod ledger;
pub mod operation;
pub mod random;
pub mod repertoire;
pub mod sample;
pub mod textbook;
pub mod tolerance;
pub mod vectors;
