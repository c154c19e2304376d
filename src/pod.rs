//! The promise that a struct is numbers and nothing else, which makes it `bytemuck::Pod`. Its proof
//! and its `unsafe` are in `dq8_simd`; the rooms that hold such structs know no more of the lanes
//! than this.

pub(crate) use dq8_simd::pod;
