//! Conversions for types of other crates. Each crate has a feature with its name. If the crate has
//! no version 1.0 yet, the name of the feature contains the version, so that a new version of the
//! crate gets a new feature and breaks no user.
//!
//! | feature | what it adds |
//! |---|---|
//! | `serde` | `Serialize` and `Deserialize` of the plain types (quaternions as arrays) |
//! | `rkyv_08` | rkyv 0.8 for [`Quat`], [`DualQuat`], [`Twist`] and [`RotationTranslation`] |
//! | `mint_05` | mint 0.5: quaternions, and matrices by rows or columns |
//! | `glam_034` | glam 0.34: quaternions, affine maps and matrices; slices by cast |
//! | `nalgebra_035` | nalgebra 0.35: (dual) quaternions, isometries, matrices; slices by cast |
//! | `approx_05` | `abs_diff_eq!`, `relative_eq!` and `ulps_eq!` of approx 0.5 |
//! | `rand_010` | uniform rotations and poses for rand 0.10 |
//! | `arbitrary` | values of any bits, for fuzzers |
//! | `proptest` | strategies for unit rotations and motions (implies `std`) |
//! | `defmt` | `Format`: motions, rotations, twists, results of searches, all errors |
//!
//! Conversions are `From` and `Into`. A matrix becomes a motion only through `TryFrom`, which
//! returns an error unless the matrix is rigid within √ε of its element type (3·10⁻⁴ in
//! `f32`, 1.5·10⁻⁸ in `f64`); [`DualQuat::try_from_cols_array_2d`] has the tolerance as a
//! parameter.

#[cfg(feature = "approx_05")]
mod approx_05;
#[cfg(feature = "arbitrary")]
mod arbitrary;
#[cfg(feature = "defmt")]
mod defmt;
#[cfg(feature = "glam_034")]
pub mod glam_034;
#[cfg(feature = "mint_05")]
mod mint_05;
#[cfg(feature = "nalgebra_035")]
pub mod nalgebra_035;
#[cfg(feature = "proptest")]
pub mod proptest;
#[cfg(feature = "rand_010")]
mod rand_010;

#[cfg(doc)]
use crate::{DualQuat, Quat, Twist, representation::RotationTranslation};
