//! Rigid motions as dual quaternions, many at a time on SIMD lanes.
//!
//! A dual quaternion is eight floats: a rotation and a translation in one number. This crate
//! multiplies, blends and interpolates them, moves points with them, and runs them down joint
//! hierarchies; one at a time in a textbook reference, or as many at a time as the lanes of a SIMD
//! register, with the same laws.
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
//! # Where things are
//!
//! | item | what it is |
//! |---|---|
//! | [`Motion`] | **the conventions, stated once**, and the laws; the trait of both implementations |
//! | [`Quaternion`], [`DualNumber`] | the same for what motions are made of |
//! | [`DualQuat`], [`Quat`], [`Dual`] | the scalar reference, in textbook form |
//! | [`batch`] | the same names on lanes, of all that kernels ask for |
//! | [`Real`] | what the reference computes with: floats, dual numbers (which differentiate it), your own |
//! | [`representation`] | Euler angles, rotation and translation, polar decomposition, affine maps |
//! | [`Line`], [`Plane`], [`geometry`] | what motions act on and are described by: screws, dual vectors |
//! | [`incidence`] | lines, planes and points together, with typed errors where they are parallel or one |
//! | [`fit`] | the motion that brings points to points with least squares: any, about one axis, or with a scale |
//! | [`Twist`], [`geometry::Wrench`] | velocities and forces: derivatives, adjoints and Jacobians of motions and joints |
//! | [`Hierarchy`], [`Job`], [`Crowd`] | joint hierarchies, one instance or many |
//! | [`Skeleton`] | a hierarchy that owns its parents, of any order and type |
//! | [`hierarchy::Plan`], [`Backend::chain_products`] | one instance without a heap, and long chains |
//! | [`ik`] | inverse kinematics of two bones; robots have a crate of their own, [dq8-robot](https://docs.rs/dq8-robot) |
//! | [`skinning`] | meshes that follow joints: linear and dual quaternion blends |
//! | [`Backend`], [`slices`] | kernels over slices of motions and points |
//! | [`storage`] | how slices lie in memory: one thing after the other, or in [blocks](Block) of lanes |
//! | [`Kernel`], [`Element`] | kernels of your own, for any layout and any instructions |
//! | [`interop`] | glam, nalgebra, serde and others, each behind a feature |
//! | [`Lanes`], [`Level`], [`simd`] | vectors of numbers, and the proof that the CPU has them |
//!
//! The [guide] has pages: [choosing a layout](crate::guide::layout), [writing your own
//! kernel](crate::guide::kernel), [clips](crate::guide::clips), [accuracy](crate::guide::accuracy),
//! [the same bits everywhere](crate::guide::reproducible), [firmware](crate::guide::firmware), and
//! [coming from another library](crate::guide::migration).
//!
//! What most programs need is at the root; everything else is in its module alone.
//!
//! # Features
//!
//! | feature | default | what it does |
//! |---|---|---|
//! | `std` | yes | square roots of the standard library; implies `alloc` |
//! | `alloc` | | `Crowd`, owned blocks for any number of instances, and `Skeleton` |
//! | `libm` | | what replaces `std` on targets without it |
//! | `reproducible` | | `Backend::reproducible`: lanes with the [same bits](crate::guide::reproducible) on every machine |
//! | `rayon` | | `threads` of every job and of [`Backend`]: any number of them, and the same bits |
//! | `serde`, `rkyv_08`, `mint_05`, `glam_034`, `nalgebra_035`, `approx_05`, `rand_010`, `arbitrary`, `proptest`, `defmt` | | types of other crates: see [`interop`] |
//!
//! Unit length is a precondition that nothing checks by default.
//! `RUSTFLAGS="--cfg dq8_debug_assert_unit"` makes debug builds panic where [`DualQuat`] and
//! [`Quat`] are plainly not unit, as [`Motion`](crate::Motion#where-unit-length-is-a-precondition)
//! says. It is a flag of the whole build and not a feature: a feature that one dependency enables
//! would let all others panic.
//!
//! Without `std` only `core` is linked (and `alloc` if asked for). No operation on borrowed memory
//! allocates.
//!
//! # Not here
//!
//! Scale and shear in hierarchies: they are not rigid motions, and dual quaternions cannot hold
//! them ([`Affine`](representation::Affine) has the reason). A skeleton that needs them keeps them
//! next to the motion; [`skinning`] takes them from there.
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
#[cfg(not(dq8_record))]
mod everyday;
#[cfg(dq8_record)]
pub mod everyday;
pub mod fit;
pub mod geometry;
// Pages, and no code: nothing that a build needs.
#[cfg(any(doc, doctest))]
pub mod guide;
pub mod hierarchy;
pub mod ik;
pub mod incidence;
pub mod interop;
pub mod law;
mod macros;
mod number;
mod operators;
pub mod representation;
pub mod scalar;
#[doc(hidden)]
pub mod seams;
pub mod skinning;
pub mod slices;
pub mod storage;

/// The number of the set of bits that [reproducible](crate::guide::reproducible) results have: a
/// minor release raises it when they change, a patch release changes none. Machines that compute in
/// lockstep compare it.
pub const BITS: u32 = 2;

/// The front page is tested like the documentation.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// The lanes' own crate: numbers, vectors and instruction sets, for kernels of your own.
pub use dq8_simd as simd;

pub(crate) use macros as brief;
pub(crate) use macros as errors;
pub(crate) use storage::palette_entry;

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
