//! The C ABI of `dq8`. C users read `include/dq8.h`, which is generated from here, and `README.md`.
//!
//! | module | what it exports |
//! |---|---|
//! | [`status`] | [`Status`], what every call returns, and its text |
//! | [`backend`] | which instructions compute |
//! | [`motion`], [`screw`], [`mean`], [`geometry`] | operations on one motion: the scalar reference |
//! | [`slices`] | kernels over arrays of motions, points, lines, planes, twists, plain or in blocks |
//! | [`hierarchy`] | joint hierarchies and skinning palettes, plain or in blocks |
//! | [`chain`] | long chains, plain or in blocks |
//! | [`clips`] | packed clips, plain |
//! | [`plan`] | one instance in the order that is fastest, plain |
//! | [`joint`], [`mechanism`] | one configuration of a mechanism: poses of links, Jacobians |
//! | [`reach`] | inverse kinematics of one configuration |
//! | [`targets`] | inverse kinematics of many configurations, plain |
//! | [`links`] | poses of links for many configurations, plain or in blocks |
//! | [`skin`], [`mesh`], [`skinning`] | meshes that follow joints, plain, or vertices of several fields |
//! | [`palette`] | skinning palettes from matrices, plain |
//! | [`packing`] | between plain arrays and blocks |
//! | [`trajectory`] | poses at times, sampled at other times |
//!
//! Each but the first two, `joint`, `skin` and `mesh` has its functions twice: in `single` for
//! `f32`, in `double` for `f64`. The symbol of `slices::single::mul` is `dq8_mul_f32`.
//!
//! Nothing here computes: pointers are checked and become slices, and errors become numbers. No
//! function allocates but those of [`trajectory`], which the feature of that name adds, and none
//! panics; a panic could not leave an `extern "C"` function anyway, it would abort.
#![cfg_attr(target_os = "none", no_std)]

#[macro_use]
mod export;
#[macro_use]
mod kernel;
pub mod backend;
pub mod chain;
pub mod clips;
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
mod span;
pub mod status;
pub mod targets;
#[cfg(feature = "trajectory")]
pub mod trajectory;

pub use backend::InstructionSet;
pub use slices::Order;
pub use status::Status;

/// A static library brings its own handler where there is no std. Nothing reaches it: the firmware
/// in `firmware/` is searched for panics after linking.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
