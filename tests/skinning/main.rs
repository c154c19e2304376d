//! Skinning: laws, agreement of all backends with the reference, and errors.
//!
//! Bounds are in units of the unit roundoff ε times the size of what is computed with.

mod agree;
mod errors;
mod influences;
mod interleaved;
mod laws;
mod palettes;
mod scene;
mod tube;
mod worst;
