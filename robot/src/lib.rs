//! Robots: from joint values to poses of links, Jacobians and velocities, and back by inverse
//! kinematics.
//!
//! Motions are dual quaternions of [`dq8`], one configuration at a time in any [`Real`](dq8::Real)
//! number, or many on the lanes of the CPU.
//!
#![doc = include_str!("frames.svg")]
//!
//! The `guide` (feature `urdf`) goes from a file to inverse kinematics, and says which array is
//! indexed by what.
//!
//! | item | what it is |
//! |---|---|
//! | [`Joint`], [`JointKind`], [`Mimic`] | how a link is joined to the one that carries it |
//! | [`Mechanism`], [`Step`] | a tree of joints, or an arm from screws or a [`Dh`] table |
//! | [`Job`] | a run over many configurations, with options |
//! | [`OwnedMechanism`] | the same with memory of its own (feature `alloc`) |
//! | [`World`], [`Body`], [`WorldAligned`] | the frame of a Jacobian |
//! | [`JointValues`] | how values of many configurations lie in memory |
//! | [`Reach`], [`Goal`], [`ik`] | inverse kinematics: which values bring links to their targets |
//! | [`OwnedReach`], [`ik::OwnedSixAxisArm`] | the same, owning their memory (`alloc`) |
//! | [`ik::SixAxisArm`] | all solutions of an arm of six hinges: elbow up and down, and so on |
//! | `urdf` | robots from files (feature `urdf`) |
//!
//! Everything is there twice: for one configuration and any [`Real`](dq8::Real), by the book, as a
//! method of [`Mechanism`]; and for many on lanes, as a method of its [`Job`], or of a
//! [`ReachJob`](ik::ReachJob).
//!
//! | one configuration | many |
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
//! An angle may be up to 2¹⁷ radians (`f32`) or 2⁴⁶ (`f64`) from zero; beyond, poses,
//! velocities and accelerations are NaN, of one configuration as on lanes. Sine and cosine of half
//! an `f32` angle, taken as exact, are off by
//! at most 2.71 and 3.35 units of 2⁻²⁴ at any angle up to there, the cosine by 2.19 up to π.
//! All floats were tried.
//!
//! # Firmware
//!
//! Without default features and with `libm` nothing is allocated and only `core` is linked; a
//! mechanism borrows the caller's memory.
//! [`dq8::guide::firmware`](https://docs.rs/dq8/latest/dq8/guide/firmware) says what is proved of
//! it. An arm of two joints and a tool:
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
//! `std` (default), `alloc`, `libm` and `rayon` are those of dq8; `urdf` reads files, and
//! `urdf-encodings` those that are in neither UTF-8 nor UTF-16; `defmt` formats errors and reports.
#![cfg_attr(not(feature = "urdf"), no_std)]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]

#[cfg(feature = "alloc")]
extern crate alloc;

/// A page of documentation: robots, from a file to inverse kinematics, and the index of each array.
#[cfg(feature = "urdf")]
#[doc = include_str!("guide.md")]
pub mod guide {}

pub mod ik;
mod mechanism;
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
