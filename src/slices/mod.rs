//! Kernels over slices, as methods of [`Backend`]. Each call chooses its instructions once.
//!
//! Kernels that compute each element from one element of every input:
//!
//! | method | what it computes |
//! |---|---|
#![doc = crate::__for_each_kernel!(crate::__kernels_table)]
//!
//! Kernels of other forms:
//!
//! | method | what it computes |
//! |---|---|
//! | [`mul_left_in_place`](Backend::mul_left_in_place) | products with one left factor a: a bᵢ |
//! | [`transform_points`](Backend::transform_points), and in place | points moved by a motion |
//! | [`transform_vectors`](Backend::transform_vectors), and in place | vectors turned by a motion |
//! | [`dlb`](Backend::dlb) | linear blends of K motions, with one weight for each |
//! | [`dib_windows`](Backend::dib_windows) | means of windows of consecutive poses |
//! | [`matrices`](Backend::matrices) | 3×4 or 4×4 matrices of motions, by rows or by columns |
//! | [`from_matrices`](Backend::from_matrices) | motions of matrices that are known to be rigid |
//! | [`try_from_matrices`](Backend::try_from_matrices) | motions of matrices, which are checked |
//! | [`two_bone`](Backend::two_bone) | rotations of limbs of two bones whose ends reach targets |
//! | [`fit_each`](Backend::fit_each) | the best maps of many sets of pairs of points |
//!
//! Each kernel takes plain slices (`[DualQuat<f32>]`, `[[f32; 3]]`, …) or slices of blocks; see
//! [`storage`](crate::storage). Plain slices may have any length and any alignment. Their elements
//! are transposed in registers, and the last few go through the same kernel with the free lanes
//! filled up. Blocks are read without a transpose, which is the fastest way.
//!
//! ```
//! use dq8::{Backend, DualQuat, Quat};
//! let turn = DualQuat::from_rotation(Quat::from_xyzw(0.0_f32, 0.0, 1.0, 0.0));
//! let points = [[1.0, 2.0, 3.0]; 5];
//! let mut moved = [[0.0; 3]; 5];
//! Backend::best().transform_points(turn, &points, &mut moved)?;
//! assert_eq!(moved, [[-1.0, -2.0, 3.0]; 5]);
//! # Ok::<(), dq8::ShapeError>(())
//! ```

mod blend;
mod fit;
mod kernels;
mod matrix;
mod sweep;
mod transform;
mod two_bone;

pub use matrix::{MatricesError, RigidMatrix};

#[cfg(doc)]
use crate::Backend;
