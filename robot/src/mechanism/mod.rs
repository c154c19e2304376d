//! Trees of joints, and what is computed of them: `walk.rs` is the loop on lanes,
//! `configuration.rs` that of one configuration of floats, `single.rs` the book.

mod configuration;
mod jacobians;
pub(crate) mod job;
pub(crate) mod joint;
mod single;
pub(crate) mod step;
pub(crate) mod tree;
pub(crate) mod values;
mod velocities;
pub(crate) mod walk;

pub use jacobians::{Body, JacobianFrame, World, WorldAligned};
#[cfg(feature = "alloc")]
pub use job::OwnedMechanism;
pub use job::{AllLinks, Job};
pub use joint::{Joint, JointKind, MechanismError, Mimic};
pub use step::Step;
pub use tree::{Dh, DhConvention, Mechanism};
pub use values::JointValues;
