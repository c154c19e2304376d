//! [`Spline`]: a smooth curve by control poses at equal intervals.
//!
//! # The formula
//!
//! Between two knots four control poses σ₀ … σ₃ count. With ξⱼ = 2 log(σⱼ₋₁*
//! σⱼ), the twist from one to the next, and the share u of the way,
//!
//! ```text
//! σ(u) = σ₀ exp(½λ₁(u) ξ₁) exp(½λ₂(u) ξ₂) exp(½λ₃(u) ξ₃)
//! ```
//!
//! where λⱼ is the sum of the weights of σⱼ … σ₃ in the spline of the same kind through
//! numbers: the *cumulative* form (Kim, Kim & Shin 1995). Body twist and acceleration follow from
//! one factor to the next (Sommer, Usenko, Schubert, Demmel & Cremers 2020, theorems 1 and 2; there
//! for SO(3), here with the adjoint and the bracket of SE(3)):
//!
//! ```text
//! ω ← Ad(exp(−½λⱼξⱼ)) ω + λ̇ⱼ ξⱼ
//! α ← Ad(exp(−½λⱼξⱼ)) α + λ̇ⱼ [ω, ξⱼ] + λ̈ⱼ ξⱼ
//! ```

mod curve;
mod jacobians;
mod job;

pub use curve::{Basis, Jacobians, Moving, Spline};
