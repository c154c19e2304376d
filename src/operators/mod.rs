//! The operators of `core` on the plain types, as far as the textbook's own (`+`, `-`, `*` of
//! values, in `scalar`, `geometry` and `representation`) imply them: `*=`, references, numbers as
//! factors, sums and products of iterators, indices.
//!
//! With them conversions from and to arrays, and text.
//!
//! Macros list the types: a trait of another crate cannot be implemented for all types that have
//! something.

mod arithmetic;
mod convert;
pub mod text;
