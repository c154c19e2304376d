//! Joint hierarchies: the computation of model poses from local poses, and of local poses from
//! model poses.
//!
//! | item | contents |
//! |---|---|
//! | [`Hierarchy`] | a parent array, checked once |
//! | [`Skeleton`] | a hierarchy that owns its parents and its plan (feature `alloc`) |
//! | [`Job`] | a run over a hierarchy: with a root, on some joints, with a palette, or backwards |
//! | [`Poses`], [`RotationsTranslations`], [`Tracks`], [`Bones`] | forms of [locals](Locals) |
//! | [`Clip`], [`Sampled`], [`Layered`] | locals that are sampled and blended during the run |
//! | [`Either`] | locals of one of two forms, chosen at run time |
//! | [`OwnedClip`] | a clip that owns its keys (feature `alloc`) |
//! | [`PackedClip`], [`PackedClips`] | clips in 8 bytes for each frame of each moving track |
//! | [`Plan`], [`PlanScratch`] | the order that computes one instance fastest, without a heap |
//! | [`Renormalize`] | the joints whose models a run normalizes |
//! | [`Crowd`] | owned blocks for any number of instances (feature `alloc`) |
//!
//! # Layout
//!
//! One instance has one element for each joint. Several instances follow each other in one slice,
//! `[instance][joint]`. Plain elements are transposed in registers, for as many instances at a time
//! as there are lanes. In blocks, `[instance block][joint][component][lane]`, each instance has one
//! lane. The parent of a joint is in the same lane of another block, so no lanes are shuffled. This
//! is the fastest way. See [`storage`](crate::storage).

// The best order to read these files is: parents, skeleton, job; run, locals, layers, clip,
// packed_clips, packed_clip; forward, blocks, plain, plan, backward, chain, limb; crowd.
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

/// Hidden types and traits, which public signatures name but users need not. They may change in any
/// release, so packages of this project that name them depend on this exact version of the crate.
#[doc(hidden)]
pub use {
    clip::{Frames, Keys, KeysAt},
    packed_clips::Playback,
    plan::{NoPlan, Plans},
    run::{JointSlot, NoRoot, Roots},
};

#[doc(inline)]
pub use dq8_simd::internal::TrackPlace;
