//! Trees of joints, and what is computed of them: `walk.rs` is the loop on lanes,
//! `configuration.rs` that of one configuration of floats, `single.rs` the book.

mod configuration;
mod dh;
mod error;
mod factor;
mod frame;
mod group;
mod jacobians;
mod job;
pub(crate) mod joint;
pub(crate) mod limits;
mod manipulability;
#[cfg(feature = "alloc")]
pub(crate) mod owned;
pub(crate) mod placed;
mod plan;
mod points;
pub(crate) mod poses;
mod screws;
mod single;
pub(crate) mod step;
pub(crate) mod tree;
mod turned;
mod turns;
mod twists;
pub(crate) mod values;
mod velocities;
pub(crate) mod walk;

pub use dh::{Dh, DhConvention};
pub use error::MechanismError;
pub use frame::{Body, JacobianFrame, World, WorldAligned};
pub use job::{AllLinks, Job};
pub use joint::{Joint, JointKind, Mimic};
#[cfg(feature = "alloc")]
pub use owned::OwnedMechanism;
pub use step::Step;
pub use tree::Mechanism;
pub use values::JointValues;
