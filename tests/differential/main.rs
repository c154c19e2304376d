//! Twists, velocities and Jacobians: against finite differences, and against their laws. Against the
//! scalar `f64` path they are held with all other operations in `agree.rs`.

mod difference;
mod edge;
mod law;
mod oracle;
