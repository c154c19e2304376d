//! Mechanisms: from joint values to poses of links, Jacobians and velocities.
//!
//! | item | what it is |
//! |---|---|
//! | [`Joint`], [`JointKind`], [`Mimic`] | how a link is joined to the one that carries it |
//! | [`Mechanism`], [`Step`] | a tree of joints, or an arm from screws, checked once, in memory of the caller |
//! | [`Job`] | a run over many configurations, with options |
//! | [`OwnedMechanism`] | the same with memory of its own (feature `alloc`) |
//! | [`World`], [`Body`], [`WorldAligned`] | the frame of a Jacobian |
//! | [`JointValues`] | how values of many configurations lie in memory |
//! | [`Reach`], [`Goal`], [`Freedom`] | inverse kinematics: which values bring links to their targets |
//! | [`OwnedReach`] | the same with memory of its own (feature `alloc`) |
//! | [`Options`], [`Report`], [`Outcome`] | how it searches, and how a search ended |
//!
//! Everything is there twice: for one configuration and any [`Real`](crate::Real), by the book, as a method
//! of [`Mechanism`]; and for many on lanes, as a method of its [`Job`], or of a [`ReachJob`].
//!
//! | one configuration | many |
//! |---|---|
//! | [`Mechanism::link_poses`] | [`Job::poses`] |
//! | [`Mechanism::link_pose`] | `mechanism.job().links(&links).poses(…)` |
//! | [`Mechanism::link_jacobian`] | `mechanism.job().links(&links).jacobians(…)` |
//! | [`Reach::solve`] | [`ReachJob::solve`] |
//! | [`Mechanism::link_velocities`] | [`Job::velocities`] |
//! | [`Mechanism::link_accelerations`] | [`Job::accelerations`] |
//!
//! An angle may be up to 2¹⁷ radians (`f32`) or 2⁴⁶ (`f64`) from zero; beyond, poses, velocities and
//! accelerations are NaN, of one configuration as on lanes. Sine and cosine of half an `f32` angle, taken as
//! exact, are off by at most 2.71 and 3.35 units of 2⁻²⁴ at any angle up to there, the cosine by 2.19 up to π.
//! All floats were tried.

mod error;
mod frame;
mod group;
mod jacobians;
mod job;
mod joint;
mod one_lane;
#[cfg(feature = "alloc")]
mod owned;
mod placed;
mod poses;
pub(crate) mod reach;
mod screws;
mod single;
mod step;
mod tree;
mod twists;
mod values;
mod velocities;
mod walk;

pub use error::MechanismError;
pub use frame::{Body, JacobianFrame, World, WorldAligned};
pub use job::{AllLinks, Job};
pub use joint::{Joint, JointKind, Mimic};
#[cfg(feature = "alloc")]
pub use owned::OwnedMechanism;
#[cfg(feature = "alloc")]
pub use reach::OwnedReach;
pub use reach::{Freedom, Goal, Options, Outcome, Reach, ReachError, ReachJob, Report};
pub use step::Step;
pub use tree::Mechanism;
pub use values::JointValues;
