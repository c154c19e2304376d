//! Operators of `core` for the types of `scalar`, `geometry` and `representation`. These modules
//! implement `+`, `-` and `*` on values; here the operators that follow from these are implemented:
//! `*=`, operators on references, real numbers as factors, sums and products of iterators, indices.
//!
//! Conversions from and to arrays, and text, are here too.
//!
//! Macros list the types, because Rust does not allow a trait of another crate to be implemented
//! for all types that satisfy a bound.

mod arithmetic;
mod convert;
pub mod text;
