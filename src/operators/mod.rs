//! The operators of `core` on the plain types that follow from `+`, `-` and `*` on values, which
//! `scalar`, `geometry` and `representation` implement: `*=`, references, real numbers as factors,
//! sums and products of iterators, indices.
//!
//! Conversions from and to arrays, and text, are here too.
//!
//! Macros list the types, because Rust does not allow a trait of another crate to be implemented
//! for all types that satisfy a bound.

mod arithmetic;
mod convert;
pub mod text;
