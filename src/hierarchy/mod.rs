//! Joint hierarchies: local poses to model space and back.
//!
//! | item | |
//! |---|---|
//! | [`Hierarchy`] | a parent array, checked once |
//! | [`Skeleton`] | a hierarchy that owns its parents, in any order, and its plan (`alloc`) |
//! | [`Job`] | a run over it: with a root, on some joints, with a palette, or backwards |
//! | [`Poses`], [`RotationsTranslations`], [`Tracks`], [`Bones`] | forms of [locals](Locals) |
//! | [`Clip`], [`Sampled`], [`Layered`] | locals, sampled and blended as they are used |
//! | [`Either`] | locals of one of two forms, which the running program chooses |
//! | [`OwnedClip`] | a clip with memory of its own (feature `alloc`) |
//! | [`PackedClip`], [`PackedClips`] | clips in 8 bytes per frame and moving track |
//! | [`Plan`], [`PlanScratch`] | the order that computes one instance fastest, without a heap |
//! | [`Renormalize`] | when a run normalizes what it has multiplied |
//! | [`Crowd`] | owned blocks for any number of instances (feature `alloc`) |
//!
//! # Layout
//!
//! One instance is one element for each joint; several instances stand one after the other,
//! `[instance][joint]`. Plain elements are transposed in registers, as many instances at a time as
//! there are lanes. Instances in blocks share a lane position,
//! `[instance block][joint][component][lane]`, so that a child finds its parent in the same lane of
//! another block, without any shuffling: the fastest way. See [`storage`](crate::storage).

// In reading order: parents, skeleton, job; run, slot, locals, layers, clip, packed_clips,
// packed_clip; forward, blocks, plain, plan, backward, chain, limb; crowd.
mod backward;
mod blocks;
mod chain;
mod clip;
#[cfg(feature = "alloc")]
mod crowd;
mod forward;
mod job;
mod layers;
mod limb;
mod locals;
#[cfg(feature = "alloc")]
mod packed_clip;
mod packed_clips;
mod parents;
mod plain;
mod plan;
mod run;
#[cfg(feature = "alloc")]
mod skeleton;

pub use crate::storage::palette_entry::{MatrixOrder, PaletteEntry};
#[cfg(feature = "alloc")]
pub use clip::OwnedClip;
pub use clip::{Clip, Sampled};
#[cfg(feature = "alloc")]
pub use crowd::Crowd;
pub use job::Job;
pub use layers::{Either, Layered, PoseSource};
pub use locals::{Bones, Locals, Poses, RotationsTranslations, Tracks};
#[cfg(feature = "alloc")]
pub use packed_clip::{Deviation, PackedClip, Tolerance};
pub use packed_clips::{PackedClips, PackedError};
pub use parents::{Hierarchy, HierarchyError};
pub use plan::{Plan, PlanScratch};
pub use run::{Renormalize, Root};
#[cfg(feature = "alloc")]
pub use skeleton::{JointOrder, ParentIndex, Skeleton};

/// Types and traits that signatures need and users do not: hidden, and free to change. Packages
/// that name them pin the version of this one.
#[doc(hidden)]
pub use {
    clip::{Frames, Keys, KeysAt},
    packed_clips::Playback,
    plan::{NoPlan, Plans},
    run::{JointSlot, NoRoot, Roots},
};

#[doc(inline)]
pub use dq8_simd::internal::TrackPlace;
