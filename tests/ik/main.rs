//! Inverse kinematics: arms against other algebra, and limbs against their own geometry.

use dq8_contract::arms;

mod forward;
mod honest;
mod lanes;
mod outcomes;
mod reference;
mod shapes;
mod success;
mod turns;
mod two_bone;

/// What [`Options::default`](dq8::ik::Options) calls reached, radians and lengths, and what measuring it is rounded by.
const REACHED: f64 = 1.001e-5;
