//! Tests of dq8-simd that do as much as a user of every lane type: a package of its own, which is
//! not optimised. With the lanes themselves, which are (see the profile of the workspace), they
//! would compile four times as long.
#![cfg(test)]
#![forbid(unsafe_code)]

mod lanes;
mod memory;
