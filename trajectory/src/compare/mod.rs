//! Two trajectories, compared: poses at the same times, laid over each other, and how far they are
//! apart.
//!
//! | step | how |
//! |---|---|
//! | poses at the same times | [`pair`] by the nearest stamp, or [`interpolated`] |
//! | one frame | [`Pairs::align`]: by the first pose, yaw, any rotation, or with a scale |
//! | errors | [`Pairs::absolute`] of poses (APE, ATE), [`Pairs::relative`] over a [`Step`] (RPE) |
//! | in a few numbers | [`Errors::translation`] and [`Errors::rotation`]: [`Statistics`] |
//!
//! [`pair`]: crate::Trajectory::pair
//! [`interpolated`]: crate::Trajectory::interpolated
//!
//! Definitions and figures are those of the Python package evo (1.38), but for two things: stamps
//! of a trajectory rise here, where evo takes doubles and disorder as they come; and interpolation
//! follows screws.

mod align;
mod error;
mod errors;
mod pairs;
mod step;

pub use align::{Align, Alignment};
pub use error::CompareError;
pub use errors::{Errors, Statistics};
pub use pairs::Pairs;
pub use step::Step;
