//! The accuracy contract: reference vectors, every implementation of [`dq8::Motion`], and the table
//! of errors allowed. Shared by the tests and by the example `conform`.

pub mod operation;
pub mod sample;
pub mod tolerance;
pub mod vectors;
