//! Robots as trees of joints: poses, Jacobians and velocities of links are computed from joint
//! values, and joint values from poses by inverse kinematics.
//!
//! Motions are dual quaternions of [`dq8`]. A call computes one configuration in any element type
//! that is [`Real`](dq8::Real), or many configurations at once on the lanes of the CPU.
//!
#![doc = include_str!("frames.svg")]
//!
//! The page `guide` (feature `urdf`) leads from a robot's file to inverse kinematics, and says by
//! what each array is indexed.
//!
//! | item | meaning |
//! |---|---|
//! | [`Joint`], [`JointKind`], [`Mimic`] | the joint between a link and its parent link |
//! | [`Mechanism`], [`Step`] | a tree of joints, screws or [`Dh`] rows, and its memory |
//! | [`Job`] | a run over many configurations, with options |
//! | [`OwnedMechanism`] | a mechanism that owns its memory (feature `alloc`) |
//! | [`World`], [`Body`], [`WorldAligned`] | the frames in which a Jacobian can be given |
//! | [`JointValues`] | the layouts of the values of many configurations |
//! | [`Reach`], [`Goal`], [`ik`] | inverse kinematics: values that bring links to targets |
//! | [`OwnedReach`], [`ik::OwnedSixAxisArm`] | solvers that own their memory (`alloc`) |
//! | [`ik::SixAxisArm`] | all solutions of an arm of six hinges: elbow up and down, and so on |
//! | `urdf` | robots from files (feature `urdf`) |
//!
//! Each computation has two forms. A method of [`Mechanism`], [`Reach`] or [`ik::SixAxisArm`]
//! computes one configuration, in any [`Real`](dq8::Real). A method of their jobs, such as [`Job`]
//! and [`ReachJob`](ik::ReachJob), computes many configurations, one per lane.
//!
//! | one configuration | many configurations |
//! |---|---|
//! | [`Mechanism::link_poses`] | [`Job::poses`] |
//! | [`Mechanism::link_pose`] | `mechanism.job().links(&links).poses(…)` |
//! | [`Mechanism::link_jacobian`] | `mechanism.job().links(&links).jacobians(…)` |
//! | [`Reach::solve`] | [`ReachJob::solve`](ik::ReachJob::solve) |
//! | [`Reach::track`] | [`ReachJob::sequence`](ik::ReachJob::sequence) |
//! | [`Reach::rates`] | [`ReachJob::rates_in`](ik::ReachJob::rates_in) |
//! | [`ik::SixAxisArm::solutions`] | [`ik::SolutionsJob::solutions`] |
//! | [`Mechanism::link_velocities`] | [`Job::velocities`] |
//! | [`Mechanism::link_accelerations`] | [`Job::accelerations`] |
//! | [`Mechanism::link_points`] | [`Job::points`] |
//!
//! An angle may be up to 2¹⁷ radians (`f32`) or 2⁴⁶ (`f64`) from zero; beyond that range,
//! both forms give NaN for poses, velocities and accelerations. If an `f32` angle is taken as
//! exact, the sine and the cosine of its half have errors of at most 2.71 and 3.35 units of
//! 2⁻²⁴ at any angle in the range. Up to π the error of the cosine is at most 2.19. All
//! floats were tried.
//!
//! # Firmware
//!
//! Without default features and with `libm` nothing is allocated and only `core` is linked; a
//! mechanism borrows the caller's memory.
//! [`dq8::guide::firmware`](https://docs.rs/dq8/latest/dq8/guide/firmware) tells which of these
//! properties are proved. The example is an arm of two joints and a tool:
//!
//! ```
//! use dq8::DualQuat;
//! use dq8_robot::{Joint, Mechanism, Step};
//!
//! const Z: [f32; 3] = [0.0, 0.0, 1.0];
//! let along = DualQuat::from_translation([0.3, 0.0, 0.0]); // metres
//! let joints = [
//!     Joint::revolute(None, DualQuat::IDENTITY, Z),
//!     Joint::revolute(Some(0), along, Z),
//!     Joint::fixed(Some(1), along),
//! ];
//! let mut steps = [Step::default(); 3]; // the memory of the mechanism
//! let arm = Mechanism::new(&joints, &mut steps)?; // checked once
//! let tool = arm.link_pose(&[0.0, core::f32::consts::FRAC_PI_2], 2)?; // radians
//! assert!((tool.translation()[1] - 0.3).abs() < 1e-6);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! # Features
//!
//! `std` (default), `alloc`, `libm` and `rayon` switch on the features of the same names in dq8.
//! `urdf` reads robots from files, and `urdf-encodings` reads files in encodings other than UTF-8
//! and UTF-16. `defmt` formats errors and reports for the crate of that name.
#![cfg_attr(not(feature = "urdf"), no_std)]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]

#[cfg(feature = "alloc")]
extern crate alloc;

/// A page of documentation that leads from a robot's file to inverse kinematics, and says by what
/// each array is indexed.
#[cfg(feature = "urdf")]
#[doc = include_str!("guide.md")]
pub mod guide {}

pub mod ik;
mod mechanism;
/// The functions on lanes by which the Python package finds rates from Jacobians. They are not for
/// other packages.
#[doc(hidden)]
pub mod internal {
    pub use crate::mechanism::rates::{rate_of, rows, scales};
}
#[cfg(feature = "urdf")]
pub mod urdf;

#[cfg(feature = "alloc")]
#[doc(inline)]
pub use ik::OwnedReach;
#[doc(inline)]
pub use ik::{Goal, Reach};
#[cfg(feature = "alloc")]
pub use mechanism::OwnedMechanism;
pub use mechanism::{
    AllLinks, Body, Dh, DhConvention, JacobianFrame, Job, Joint, JointKind, JointValues, Mechanism,
    MechanismError, Mimic, Step, World, WorldAligned,
};
