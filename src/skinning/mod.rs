//! Skinning.

mod blender;
mod dual;
mod error;
mod influences;
mod linear;
mod linear_map;
mod run;
mod skin;
mod surface;
mod weight;

pub use dual::Dual;
pub use error::SkinningError;
pub use linear::Linear;
pub use skin::Skin;
pub use surface::{Surface, SurfaceMut};
pub use weight::Weight;
