//! What a motion acts on and what describes it: plain data, the same for one motion (`T` a float)
//! and for many (`T` a vector of lanes). Points and directions are plain `[T; 3]`.

mod dual_vector;
mod line;
mod mean;
mod plane;
mod screw;
mod twist;
pub(crate) mod vector;
mod wrench;

pub use dual_vector::DualVector;
pub use line::Line;
pub use mean::Mean;
pub use plane::Plane;
pub use screw::Screw;
pub use twist::Twist;
pub use wrench::Wrench;
