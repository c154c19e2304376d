//! Rigid motions as dual quaternions, many at a time on SIMD lanes.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("dq8 needs square roots and trigonometry: enable the feature `std` or `libm`");

pub mod batch;
mod error;
mod geometry;
pub mod hierarchy;
mod motion;
mod real;
pub mod scalar;

pub use dq8_simd::{Float, Lane, Level, Mask, Portable, f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
pub use error::{HierarchyError, InverseError, MatrixError, NormalizeError, ShapeError};
pub use geometry::{DualVector, Line, Plane, Screw};
#[cfg(feature = "alloc")]
pub use hierarchy::Crowd;
pub use hierarchy::{Block, Hierarchy, Job, Pose, pack, unpack};
pub use motion::Motion;
pub use real::Real;
pub use scalar::{Dual, DualQuat, Quat};
