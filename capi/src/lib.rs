//! The C ABI of `dq8`. C users read `include/dq8.h`, which is generated from here, and `README.md`.
//!
//! | module | exports |
//! |---|---|
//! | [`status`] | [`Status`], the result of every call, and its text |
//! | [`backend`] | the choice of the instruction set |
//! | [`motion`], [`screw`], [`mean`], [`geometry`], [`euler`] | operations on one motion |
//! | [`fit`] | the motion between two arrays of points |
//! | [`slices`] | kernels over arrays, plain or in blocks |
//! | [`hierarchy`] | joint hierarchies and skinning palettes, plain or in blocks |
//! | [`chain`] | products along long chains, plain or in blocks |
//! | [`clips`] | packed clips, plain |
//! | [`clip_files`] | packed clips, written |
//! | [`plan`] | one instance of a hierarchy in the fastest order, plain |
//! | [`joint`], [`mechanism`] | one configuration of a mechanism: poses of links, Jacobians |
//! | [`reach`] | inverse kinematics of one configuration |
//! | [`targets`] | inverse kinematics of many configurations, plain |
//! | [`solutions`] | all solutions of arms of six hinges, plain |
//! | [`links`] | poses and Jacobians of links for many configurations, plain or in blocks |
//! | [`skin`], [`mesh`], [`skinning`] | meshes that follow joints: arrays or vertex buffers |
//! | [`palette`] | skinning palettes from matrices, plain |
//! | [`packing`] | conversions between plain arrays and blocks |
//! | [`trajectory`] | poses at stamps, sampled at other times |
//! | `urdf` | joints from URDF files |
//!
//! In this table, *plain* means arrays of one record after the other, and *blocks* are blocks of
//! lanes (AoSoA). Functions that exist for both `f32` and `f64` are in two submodules: `single` for
//! `f32`, and `double` for `f64`. The symbol of `slices::single::mul` is `dq8_mul_f32`.
//!
//! The functions here do not compute themselves. They check pointers, turn them into slices, call
//! `dq8`, and turn its errors into values of [`Status`]:
//!
//! ```text
//! Input::new, Output::new    null, misaligned and too large arrays are refused
//! span::disjoint             outputs that overlap other arrays are refused
//! slice()                    unsafe: C guarantees that the arrays have their lengths
//! Status::of                 the error as an integer, or DQ8_STATUS_OK
//! ```
//!
//! No function allocates, except for functions of the modules `trajectory` and `urdf`, which need
//! the features of these names, and dq8_clips_pack, which needs the feature `std`. No function
//! panics. A panic would abort the program, because it must not leave an `extern "C"` function.
#![cfg_attr(target_os = "none", no_std)]

#[macro_use]
mod export;
#[macro_use]
mod kernel;
pub mod backend;
pub mod chain;
#[cfg(feature = "std")]
pub mod clip_files;
pub mod clips;
pub mod euler;
pub mod fit;
pub mod geometry;
pub mod hierarchy;
pub mod joint;
pub mod links;
pub mod mean;
pub mod mechanism;
mod memory;
pub mod mesh;
pub mod motion;
pub mod packing;
pub mod palette;
pub mod plan;
pub mod reach;
pub mod screw;
pub mod skin;
pub mod skinning;
pub mod slices;
pub mod solutions;
mod span;
pub mod status;
pub mod targets;
#[cfg(feature = "trajectory")]
pub mod trajectory;
#[cfg(feature = "urdf")]
pub mod urdf;

pub use backend::InstructionSet;
pub use slices::Order;
pub use status::Status;

/// The panic handler that a static library without std must define. It is never called: a script
/// searches the linked firmware of `firmware/` for panics.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
