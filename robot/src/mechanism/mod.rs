//! Trees of joints, and the kernels that compute poses, points, Jacobians and velocities of their
//! links. `walk.rs` has the loop over many configurations, one per lane. `configuration.rs` has the
//! fast code for one configuration of `f32` or `f64`. `single.rs` has the formulas of textbooks.

mod configuration;
mod jacobians;
pub(crate) mod job;
pub(crate) mod joint;
pub(crate) mod rates;
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
