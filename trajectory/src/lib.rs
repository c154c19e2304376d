//! Trajectories: poses with stamps, sampled at many times, and compared; points that are each moved
//! by the pose at their own time; smooth curves by control poses; and trees of frames that move in
//! each other.
//!
//! | item | what it is |
//! |---|---|
//! | [`Trajectory`] | stamps and poses in the caller's memory; screw motion between neighbours |
//! | [`OwnedTrajectory`] | a trajectory with memory of its own, of any order of stamps |
//! | [`Spline`] | a cubic B-spline by control poses, or Catmull and Rom's through them |
//! | [`Job`] | a run over many times, with a clock, a frame and threads |
//! | [`Frame`] | the frame that poses and points come out in |
//! | [`Outside`] | what happens before the first stamp and after the last |
//! | [`Time`] | the numbers that times of points may be |
//! | [`Frames`] | a tree of frames: the pose of one in another at many times |
//! | [`covariance`] | covariances of poses in another frame, of inverses and of products |
//! | [`compare`] | errors of an estimate against a reference, after pairing and alignment |
//! | `files` | trajectories in text files: TUM, EuRoC, KITTI (feature `std`) |
//!
//! Poses and stamps are `f64`. A pose is first taken relative to the wanted frame and only then
//! rounded to the numbers of the points, so a map whose origin is 10⁶ m away costs an `f32` point
//! nothing.
//!
//! ```
//! use dq8::DualQuat;
//! use dq8_trajectory::{Frame, Trajectory};
//! // A scanner moves two metres along x within 0.1 s.
//! let stamps = [100.0, 100.1];
//! let poses = [0.0, 2.0].map(|x| DualQuat::from_translation([x, 0.0, 0.0]));
//! let path = Trajectory::new(&stamps, &poses)?;
//! // It sees one wall five times, each time nearer. The times of the points count from the
//! // beginning of the scan.
//! let points = [10.0_f32, 9.5, 9.0, 8.5, 8.0].map(|x| [x, 0.0, 0.0]);
//! let times = [0.0_f32, 0.025, 0.05, 0.075, 0.1];
//! let mut moved = points;
//! path.job().clock(100.0, 1.0).frame(Frame::End).deskew(&times, &points, &mut moved)?;
//! assert!(moved.iter().all(|[x, ..]| (x - 8.0).abs() < 1e-5));
//! # Ok::<(), dq8_trajectory::TrajectoryError>(())
//! ```
//!
//! # Clouds that other crates read
//!
//! Any slice of `[f32; C]` or `[f64; C]` whose first three numbers are coordinates is a cloud, and
//! records of such numbers alone become one without a copy. A `#[repr(C)]` record of `f32` fields
//! `x`, `y`, `z`, `intensity` and `time`, which `pcd-rs` fills and bytemuck calls `Pod`, is moved
//! by `deskew_in_place(&times, bytemuck::cast_slice_mut::<_, [f32; 5]>(&mut points))`; all but the
//! coordinates stays. The points of `las` hold more than numbers, so collect `[p.x, p.y, p.z]`, and
//! `p.gps_time` as their times.
//!
//! # Features
//!
//! `std` (default), `libm`, `rayon` and `reproducible` are those of dq8; `std` adds the module
//! `files`. The crate is `no_std` and needs a heap, on which a job keeps the segments of its
//! trajectory.
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]

extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

mod along;
mod clock;
pub mod compare;
pub mod covariance;
mod error;
#[cfg(feature = "std")]
pub mod files;
mod frames;
mod job;
mod path;
mod screw;
mod segments;
mod spline;
mod stretches;

pub use clock::Time;
pub use error::TrajectoryError;
pub use frames::{Edge, Frames, FramesError};
pub use job::{Columns, Job};
pub use path::{OwnedTrajectory, Trajectory};
pub use segments::{Frame, Outside};
pub use spline::{Basis, Jacobians, Moving, Spline};

/// The example of the README is tested like the documentation.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
