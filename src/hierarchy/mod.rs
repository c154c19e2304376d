//! Joint hierarchies: local poses to model space and back.
//!
//! | item | what it is |
//! |---|---|
//! | [`Hierarchy`] | a parent array, checked once |
//! | [`Element`](crate::Element) | how motions lie in memory: one ([`DualQuat`](crate::DualQuat)), or a [`Block`](crate::Block) of instances |
//! | [`Poses`], [`RotationsTranslations`], [`Rotations`] | forms of locals |
//! | [`PaletteEntry`](crate::PaletteEntry) | what a skinning palette is made of: motions or matrices |
//! | [`Job`] | a run with a root transform or on some of the joints |
//! | [`HierarchyPlan`], [`Strategy`] | one instance: an order found once (feature `alloc`) |
//! | [`pack_chain`](crate::storage::pack_chain), [`unpack_chain`](crate::storage::unpack_chain) | chains in segments, for [`Backend::chain_products`](crate::Backend::chain_products) |
//! | [`Renormalize`] | when a run normalizes what it has multiplied |
//! | [`Crowd`] | owned blocks for any number of instances (feature `alloc`) |
//! | [`pack`](crate::storage::pack), [`unpack`](crate::storage::unpack) | the same conversion between slices of your own |
//!
//! # Layout
//!
//! One instance is one element a joint. Several instances stand one after the other; instances in
//! blocks share a lane position: `[instance block][joint][component][lane]`, so that a child finds
//! its parent in the same lane of another block, without any shuffling.

mod backward;
mod chain;
mod concatenate;
#[cfg(feature = "alloc")]
mod crowd;
mod job;
mod locals;
mod palette;
#[cfg(feature = "rayon")]
mod parallel;
mod parents;
#[cfg(feature = "alloc")]
mod plan;
mod product;
mod renormalize;
mod run;
#[cfg(feature = "alloc")]
mod schedule;
mod slot;
mod transposed;
mod velocity;

#[cfg(feature = "alloc")]
pub use crowd::Crowd;
pub use job::Job;
pub use locals::{Locals, Poses, Rotations, RotationsTranslations};
pub use parents::Hierarchy;
#[cfg(feature = "alloc")]
pub use plan::{HierarchyPlan, Strategy};
pub use renormalize::Renormalize;
pub use slot::JointSlot;
