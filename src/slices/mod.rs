//! Kernels over slices, as methods of [`Backend`]: one choice of instructions for each call.
//!
//! | method | what it computes |
//! |---|---|
//! | [`mul`](Backend::mul), [`mul_in_place`](Backend::mul_in_place) | aᵢbᵢ |
//! | [`mul_left_in_place`](Backend::mul_left_in_place) | a bᵢ |
//! | [`normalize`](Backend::normalize), [`inverse`](Backend::inverse), and in place | exactly, one by one |
//! | [`conjugate`](Backend::conjugate), and in place | the inverse of unit motions |
//! | [`nlerp`](Backend::nlerp), [`sclerp`](Backend::sclerp), with one t or one each | between aᵢ and bᵢ |
//! | [`dib_windows`](Backend::dib_windows) | means of windows of poses that follow each other |
//! | [`transform_points`](Backend::transform_points), [`transform_vectors`](Backend::transform_vectors), and in place | by one motion |
//! | [`transform_points_each`](Backend::transform_points_each), [`transform_vectors_each`](Backend::transform_vectors_each) | by one motion each |
//! | [`transform_lines_each`](Backend::transform_lines_each), [`transform_planes_each`](Backend::transform_planes_each), [`transform_twists_each`](Backend::transform_twists_each) | by one motion each |
//! | [`dlb`](Backend::dlb) | linear blends of several motions, by a weight each |
//! | [`log`](Backend::log), [`exp`](Backend::exp), [`pow_each`](Backend::pow_each) | screws and their powers; a logarithm is *half* a twist |
//! | [`to_twist`](Backend::to_twist), [`from_twist`](Backend::from_twist) | motions and the twists that lead to them in one second |
//! | [`integrate_body`](Backend::integrate_body) | one step along twists |
//! | [`angles`](Backend::angles), [`distances`](Backend::distances) | between aᵢ and bᵢ |
//! | [`two_bone`](Backend::two_bone) | limbs of two bones with their ends at targets |
//! | [`matrices`](Backend::matrices), [`from_matrices`](Backend::from_matrices), [`try_from_matrices`](Backend::try_from_matrices) | to and from 3×4 and 4×4 matrices, by rows or by columns |
//!
//! Each takes plain slices (`[DualQuat<f32>]`, `[[f32; 3]]`, …) or slices of blocks; see
//! [`storage`](crate::storage). Plain slices may have any length and lie anywhere: they are
//! transposed in registers, and the last few elements go through the same kernel with the lanes
//! that are left filled up. Blocks are read as they are: the fastest way.
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
mod interpolate;
mod map;
mod matrix;
mod metric;
mod product;
mod rigid_matrix;
mod screw;
mod sweep;
mod transform;
mod transform_each;
mod two_bone;
mod unit;
mod windows;

pub use matrix::MatricesError;
pub use rigid_matrix::RigidMatrix;

#[cfg(doc)]
use crate::Backend;
