//! Joint hierarchies: local poses to model space and back.
//!
//! | item | what it is |
//! |---|---|
//! | [`Hierarchy`] | a parent array, checked once |
//! | [`Skeleton`] | one that owns its parents, of any order and type, and its plan (feature `alloc`) |
//! | [`Job`] | a run over it: with a root transform, on some of the joints, with a palette, backwards |
//! | [`Poses`], [`RotationsTranslations`], [`Tracks`], [`Bones`] | forms of [locals](Locals) |
//! | [`Clip`], [`Sampled`], [`Layered`] | locals that are sampled, blended and masked in the pass that uses them |
//! | [`Either`] | locals of one of two forms, which the running program chooses |
//! | [`OwnedClip`] | a clip with memory of its own (feature `alloc`) |
//! | [`PackedClip`], [`PackedClips`] | clips in 8 bytes for each track that moves, and frame: owned, borrowed |
//! | [`Plan`], [`PlanScratch`] | the order in which one instance is computed fastest, for those without a heap |
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

mod ahead;
mod backward;
mod chain;
mod clip;
mod concatenate;
#[cfg(feature = "alloc")]
mod crowd;
mod either;
mod error;
mod family;
mod forward;
mod job;
mod keys;
mod layers;
mod limb;
mod local_poses;
mod locals;
mod model_to_local;
#[cfg(feature = "alloc")]
mod owned_clip;
#[cfg(feature = "alloc")]
mod owned_plan;
#[cfg(feature = "alloc")]
mod packed_clip;
mod packed_clips;
mod packed_error;
mod palette;
mod palettes;
#[cfg(feature = "rayon")]
mod parallel;
#[cfg(feature = "alloc")]
mod parent_index;
mod parents;
mod plan;
mod planned;
mod product;
mod renormalize;
mod root;
mod root_motion;
mod rows;
mod run;
mod sampled;
mod schedule;
#[cfg(feature = "alloc")]
mod skeleton;
mod slot;
mod transposed;
mod unkept;
mod write;

pub use crate::palette_entry::{MatrixOrder, PaletteEntry};
pub use clip::{Clip, Frames};
#[cfg(feature = "alloc")]
pub use crowd::Crowd;
pub use either::Either;
pub use error::HierarchyError;
pub use job::Job;
pub use keys::{Keys, PlacedKeys};
pub use layers::{Layered, PoseSource};
pub use locals::{Bones, Locals, Poses, RotationsTranslations, Tracks};
#[cfg(feature = "alloc")]
pub use owned_clip::OwnedClip;
#[cfg(feature = "alloc")]
pub use packed_clip::{Deviation, PackedClip, Tolerance};
pub use packed_clips::{PackedClips, Playback};
pub use packed_error::PackedError;
#[cfg(feature = "alloc")]
pub use parent_index::ParentIndex;
pub use parents::Hierarchy;
pub use plan::{NoPlan, Plan, Plans};
pub use renormalize::Renormalize;
pub use root::{NoRoot, Roots};
pub use run::Root;
pub use sampled::Sampled;
pub use schedule::PlanScratch;
#[cfg(feature = "alloc")]
pub use skeleton::{JointOrder, Skeleton};
pub use slot::JointSlot;

#[doc(inline)]
pub use dq8_simd::internal::TrackPlace;
