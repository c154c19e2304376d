//! Robots from URDF files: what is read, what is refused and what is reported.

mod changed;
mod elements;
mod errors;
mod large;
mod limits;
mod reach;
mod robots;
mod text;
mod warnings;
