//! Skinning: a mesh follows the joints of a skeleton.
//!
//! A [`Skin`] holds the joints that move each vertex and their weights, which are checked once.
//! [`Skin::pose`] poses the positions, normals and tangents of a mesh, in plain slices or blocks of
//! `f32` or `f64`, by one of these blends:
//!
//! | blend | palette | effect |
//! |---|---|---|
//! | [`Linear`] | 3×4 matrices | Σ wᵢMᵢv: for any matrix; collapses where joints twist |
//! | [`DualBlend`] | motions | Σ ±wᵢσᵢ, normalized: keeps volume; bulges where joints bend |
//! | [`StretchedDualBlend`] | stretches and motions | a dual blend of joints that scale and shear |
//! | [`Mixed`] | the palettes of two blends | a mix of both, by a share per vertex |
//!
#![doc = include_str!("twist.svg")]
//!
//! [`Job::pose_interleaved`] poses vertex buffers, whose vertices are records of several fields,
//! and [`Skin::interleaved`] reads joints and weights from such buffers.
//!
//! [`Job::palette`](crate::Job::palette) computes palettes of motions or of 3×4 matrices by rows.
//! [`matrix_palette`] makes a palette from the matrices of an engine or a file, and
//! [`split_palette`] takes matrices apart into motions and stretches. [`linear_blend`] and
//! [`dual_blend`] are the reference implementations, for one vertex.
//!
//! Nothing allocates, and nothing panics. A [`SkinningError`] names the fault before any output is
//! written.
//!
//! ```
//! use dq8::skinning::{DualBlend, Skin, Surface, SurfaceMut};
//! use dq8::{DualQuat, Quat};
//! // Halfway between a joint at rest and one that is twisted by a third of a turn.
//! let skin = Skin::new(2, 2, &[0_u16, 1], &[0.5_f32, 0.5])?;
//! let twist = Quat::from_axis_angle([0.0_f32, 0.0, 1.0], 120_f32.to_radians());
//! let palette = [DualQuat::IDENTITY, DualQuat::from_rotation(twist)];
//! let mut posed = [[0.0; 3]];
//! let rest = Surface::positions(&[[1.0, 0.0, 0.0]]);
//! skin.pose(DualBlend::new(&palette), rest, SurfaceMut::positions(&mut posed))?;
//! assert!((posed[0][0] - 0.5).abs() < 1e-6 && (posed[0][1] - 0.75_f32.sqrt()).abs() < 1e-6);
//! # Ok::<(), dq8::skinning::SkinningError>(())
//! ```

mod blender;
mod composite;
mod dual_blend;
mod error;
mod job;
mod linear;
mod mesh;
mod palette;
mod reference;
mod skin;

#[doc(hidden)]
pub use blender::Blender;
pub use composite::{Mixed, StretchedDualBlend};
#[doc(inline)]
pub use dq8_simd::internal::Index;
pub use dual_blend::DualBlend;
pub use error::SkinningError;
pub use job::Job;
pub use linear::Linear;
pub use mesh::{Surface, SurfaceMut, VertexFields};
#[doc(hidden)]
pub use palette::Split;
pub use palette::{matrix_palette, split_palette};
pub use reference::{dual_blend, linear_blend};
pub use skin::{InfluenceField, Skin, Weight};
