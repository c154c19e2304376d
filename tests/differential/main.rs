//! Twists, velocities and Jacobians: their laws, an integral and a closed form, and edges. With all
//! other operations they are held to 60 digits in `oracle.rs`, and to the scalar `f64` path in
//! `agree.rs`; `differentiate.rs` differentiates.

mod edge;
mod law;
mod oracle;
