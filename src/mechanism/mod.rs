//! Mechanisms: from joint values to poses of links, Jacobians and velocities.
//!
//! | item | what it is |
//! |---|---|
//! | [`Joint`], [`JointKind`], [`Mimic`] | how a link is joined to the one that carries it |
//! | [`Mechanism`], [`Step`] | a tree of joints, checked once, in memory of the caller |
//! | [`OwnedMechanism`] | the same with memory of its own (feature `alloc`) |
//! | [`World`], [`Body`], [`WorldAligned`] | the frame of a Jacobian |

mod error;
mod frame;
mod group;
mod jacobians;
mod joint;
#[cfg(feature = "alloc")]
mod owned;
#[cfg(feature = "rayon")]
mod parallel;
mod placed;
mod poses;
mod single;
mod step;
mod tree;
mod twists;
mod values;
mod velocities;
mod walk;

pub use error::MechanismError;
pub use frame::{Body, JacobianFrame, World, WorldAligned};
pub use joint::{Joint, JointKind, Mimic};
#[cfg(feature = "alloc")]
pub use owned::OwnedMechanism;
pub use step::Step;
pub use tree::Mechanism;
pub use values::JointValues;
