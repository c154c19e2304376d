//! Other representations of rotations, on lanes: see [`representation`](crate::representation).

mod axis_angle;
mod directions;
