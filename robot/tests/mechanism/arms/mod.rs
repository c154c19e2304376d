//! Arms from screws: their poses against other algebra, how often they reach, and the steps to there.

mod forward;
mod honest;
mod lanes;
mod reference;
mod shapes;
mod steps;
mod success;

/// What [`Options::default`](dq8_robot::ik::Options) calls reached, radians and lengths, and what measuring it is
/// rounded by.
const REACHED: f64 = 1.001e-5;
