//! Arms from screws: their poses against other algebra, and the steps to their targets.

mod forward;
mod honest;
mod lanes;
mod reference;
mod shapes;
mod steps;

/// What [`Options::default`](dq8_robot::ik::Options) calls reached, radians and lengths, and what measuring it is
/// rounded by.
const REACHED: f64 = 1.001e-5;
