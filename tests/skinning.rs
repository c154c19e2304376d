//! Skinning: laws, agreement of all backends with the reference, and errors.
//!
//! Bounds are in units of the unit roundoff ε times the size of what is computed with.

#[path = "skinning/agree.rs"]
mod agree;
#[path = "skinning/errors.rs"]
mod errors;
#[path = "skinning/interleaved.rs"]
mod interleaved;
#[path = "skinning/laws.rs"]
mod laws;
#[path = "skinning/palettes.rs"]
mod palettes;
#[path = "skinning/scene.rs"]
mod scene;
#[path = "skinning/tube.rs"]
mod tube;
#[path = "skinning/worst.rs"]
mod worst;
