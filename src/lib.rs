//! Rigid motions as dual quaternions, many at a time on SIMD lanes.
//!
//! A dual quaternion is eight floats that represent a rotation and a translation. This crate
//! multiplies, blends and interpolates dual quaternions, moves points with them, and computes the
//! poses of joint hierarchies. It does so for one motion at a time in a textbook reference, or for
//! as many motions at a time as a SIMD register has lanes. Both obey the same laws.
//!
//! ```
//! use dq8::{Crowd, DualQuat, Hierarchy, Quat};
//! // A two-link arm, and eleven poses of it: lanes are poses.
//! let parents = [Hierarchy::ROOT, 0];
//! let arm = Hierarchy::new(&parents)?;
//! let pose = |angle: f32| {
//!     let turn = Quat::from_axis_angle([0.0, 0.0, 1.0], angle);
//!     [DualQuat::from_rotation(turn), DualQuat::from_rotation_translation(turn, [1.0, 0.0, 0.0])]
//! };
//! let locals: Vec<_> = (0..11).flat_map(|i| pose(0.1 * i as f32)).collect();
//! let mut crowd = Crowd::<f32, 8>::from_slice(arm.joints(), &locals)?;
//! arm.job().local_to_model_in_place(crowd.blocks_mut())?;
//! let [x, y, _] = crowd.get(10, 1).unwrap().transform_point([1.0, 0.0, 0.0]);
//! assert!((x - (1f32.cos() + 2f32.cos())).abs() + (y - (1f32.sin() + 2f32.sin())).abs() < 1e-6);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! # I have … I use …
//!
//! | I have | I use |
//! |---|---|
//! | one motion | [`DualQuat`], [`Quat`], [`representation`] |
//! | my own element type, or derivatives | the same types with any [`Real`], such as [`Dual`] |
//! | an array of motions, points, lines or twists | [`Backend::best`] and its methods, [`slices`] |
//! | one skeleton, or many in plain arrays | [`Skeleton`] |
//! | a skeleton without a heap | [`Hierarchy`], [`hierarchy::Plan`] |
//! | a crowd that stays in [blocks](Block) | [`Crowd`], [`storage`] |
//! | animation clips | [`hierarchy::Clip`], [`hierarchy::PackedClip`], [`hierarchy::Layered`] |
//! | a palette to write for the GPU | [`Job::palette`] |
//! | a mesh on the CPU | [`skinning::Skin`] |
//! | limbs of two bones that reach for a place | [`ik`] |
//! | a robot, or a URDF file | the crate [dq8-robot] |
//! | a trajectory, or a scan to deskew | the crate [dq8-trajectory] |
//! | pairs of points to fit a motion to | [`fit`] |
//! | lines, planes, screws, twists | [`Line`], [`Plane`], [`Twist`], [`geometry`], [`incidence`] |
//! | types of glam, nalgebra, mint, serde | [`interop`] |
//! | a kernel of my own | [`Kernel`], [`Element`], [`batch`], [`simd`] |
//! | machines in lockstep | [`guide::reproducible`] |
//! | firmware | [`guide::firmware`] |
//!
//! # Guide
//!
//! | page | what it answers |
//! |---|---|
//! | [conventions](guide::conventions) | the eight components, which factor acts first, units |
//! | [layout](guide::layout) | plain arrays or blocks, how many lanes |
//! | [kernel](guide::kernel) | kernels of your own |
//! | [clips](guide::clips) | which form of an animation to keep |
//! | [skins](guide::skins) | from joints and weights to posed vertices |
//! | [robots](guide::robots) | from joints to poses of links and back |
//! | [accuracy](guide::accuracy) | how exact answers are, for which input |
//! | [reproducible](guide::reproducible) | the same bits everywhere |
//! | [firmware](guide::firmware) | no heap, no panic, sizes |
//! | [migration](guide::migration) | coming from another library |
//!
//! [`Motion`] states the laws of motions, for single motions and for lanes alike. Every operation
//! is a method of the types, so no program needs to import this trait. The crate's root has the
//! items that most programs need; all other items are in their modules.
//!
//! # Features
//!
//! | feature | default | what it does |
//! |---|---|---|
//! | `std` | yes | square roots of the standard library; implies `alloc` |
//! | `alloc` | | `Crowd`, owned blocks for any number of instances, and `Skeleton` |
//! | `libm` | | mathematical functions on targets without `std` |
//! | `reproducible` | | `Backend::reproducible`: lanes with the [same bits] on every machine |
//! | `rayon` | | `threads` of every job and of [`Backend`]: any count gives the same bits |
//! | `serde`, `rkyv_08`, `defmt` | | motions written to files and logs: see [`interop`] |
//! | `mint_05`, `glam_034`, `nalgebra_035`, `approx_05` | | types of other crates of mathematics |
//! | `rand_010`, `arbitrary`, `proptest` | | random motions |
//!
//! [dq8-robot]: https://docs.rs/dq8-robot
//! [dq8-trajectory]: https://docs.rs/dq8-trajectory
//! [same bits]: crate::guide::reproducible
//!
//! Operations need motions of unit length, and nothing checks this by default.
//! `RUSTFLAGS="--cfg dq8_debug_assert_unit"` makes debug builds panic where [`DualQuat`] and
//! [`Quat`] are clearly not unit, as [`Motion`](crate::Motion#where-unit-length-is-a-precondition)
//! says. It is a flag of the whole build and not a feature: if one dependency enabled a feature, it
//! would make the code of all others panic.
//!
//! Without `std` the crate links only `core` (and `alloc` if that feature is enabled). No operation
//! on borrowed memory allocates.
//!
//! # Not here
//!
//! Hierarchies have no scale and no shear: these are not rigid motions, and dual quaternions cannot
//! represent them ([`Affine`](representation::Affine) explains why). A skeleton that needs scale
//! and shear stores them beside the motions, and [`skinning`] applies them.
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("dq8 needs square roots and trigonometry: enable the feature `std` or `libm`");

mod backend;
pub mod batch;
mod contract;
pub mod fit;
pub mod geometry;
#[cfg(not(dq8_record))]
mod quick;
#[cfg(dq8_record)]
pub mod quick;
// The guide has pages of documentation and no code, so only builds of documentation and of its
// tests need it.
#[cfg(any(doc, doctest))]
pub mod guide;
pub mod hierarchy;
pub mod ik;
pub mod incidence;
#[doc(hidden)]
pub mod internal;
pub mod interop;
pub mod law;
mod macros;
mod number;
mod operators;
pub mod representation;
pub mod scalar;
pub mod skinning;
pub mod slices;
pub mod storage;

/// The version of the bits of [reproducible](crate::guide::reproducible) results. A minor release
/// raises it if these bits change; a patch release never changes them. Machines that compute in
/// lockstep should compare it.
pub const BITS: u32 = 2;

/// An item whose documentation is the README, so that its examples are tested, too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// The crate of lanes: their element types, vectors and instruction sets, for kernels of your own.
pub use dq8_simd as simd;

pub use backend::{Backend, Kernel, UnavailableBackend};
pub use contract::{DualNumber, Motion, Quaternion};
#[doc(inline)]
pub use dq8_simd::{Lanes, Level};
#[doc(inline)]
pub use geometry::{Line, Plane, Twist};
#[cfg(feature = "alloc")]
#[doc(inline)]
pub use hierarchy::{Crowd, Skeleton};
#[doc(inline)]
pub use hierarchy::{Hierarchy, Job};
pub use number::{Real, Scalar};
pub use operators::text;
#[doc(inline)]
pub use scalar::{Dual, DualQuat, Quat};
pub use storage::shape::ShapeError;
#[doc(inline)]
pub use storage::{Block, Element};
